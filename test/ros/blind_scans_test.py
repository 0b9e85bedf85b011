#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Scans that cannot be matched, of eight hits or of garbage: the Kalman filter goes on with the
odometry, is less sure with each scan, and the node says why; then scans are good again."""
import math
import sys

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticStatus
from toy_robot import ToyRobotCase
from visualization_msgs.msg import MarkerArray


MATCHED = ("used", "left to a cloud: walls so thick that hits slide in them")


class BlindScans(ToyRobotCase):
    def setUp(self):
        self.variances = []
        super().setUp()
        self.spoil = lambda ranges: ranges
        self.texts = []
        texts = rospy.Subscriber("adaptive_localization/status_text", MarkerArray,
                                 lambda m: self.texts.extend(marker.text for marker in m.markers))
        self.subscribers.append(texts)
        self.wait_for_connections(texts)

    def on_pose(self, message):
        self.variances.append(message.pose.covariance[0])
        super().on_pose(message)

    def scan_message(self, *arguments, **named):
        message = super().scan_message(*arguments, **named)
        message.ranges = self.spoil(message.ranges)
        return message

    def test_unmatched_scans_leave_the_odometry_and_growing_doubt(self):
        self.localize()
        self.steps(10, (0.11, 0.0, 0.02))
        self.assertEqual(self.status(), "tracking")
        self.assertLess(self.error(), 0.05)
        self.assertIn(self.status_values()["match"], MATCHED)

        few = lambda ranges: [r if i % 23 == 0 else math.inf for i, r in enumerate(ranges)]
        garbage = lambda ranges: [0.5 + 4.0 * (i * 7919 % 181) / 181 for i, _ in enumerate(ranges)]
        for spoil, why in [(few, "too few hits"),
                           (garbage, "too many hits are not of the map")]:
            with self.subTest(why=why):
                self.spoil = spoil
                self.forget()
                self.variances.clear()
                self.texts.clear()
                self.steps(6, (0.11, 0.0, 0.0))
                self.assertEqual(self.status_values()["match"], why)
                self.wait_for(lambda: self.diagnostic("Match"), "diagnostics")
                self.wait_for(lambda: self.diagnostic("Match")[1] == "Refused: " + why, why)
                self.assertEqual(self.diagnostic("Match")[0], DiagnosticStatus.WARN)
                said = "not matched: " + why
                self.wait_for(lambda: self.step() or [t for t in self.texts if t.endswith(said)],
                              "a text beside the robot")
                self.assertGreaterEqual(len(self.variances), 5)
                for before, after in zip(self.variances, self.variances[1:]):
                    self.assertGreater(after, before)
                self.assertLess(self.error(), 0.05)

                self.spoil = lambda ranges: ranges
                self.steps(12, (-0.055, 0.0, 0.0))
                self.assertEqual(self.status(), "tracking")
                self.assertLess(self.error(), 0.05)
                self.assertIn(self.status_values()["match"], MATCHED)
                self.assertLess(self.variances[-1], max(self.variances))


if __name__ == "__main__":
    rospy.init_node("blind_scans_test")
    rostest.rosrun("adaptive_localization", "blind_scans", BlindScans, sys.argv)
