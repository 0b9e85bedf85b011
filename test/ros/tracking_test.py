#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The simulated robot drives through the maze from a start that the node knows."""
import math
import sys

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseArray
from localization_case import AT_LAST, LocalizationCase, planar, values_of, wrap
from std_msgs.msg import Float32

TOLERANCE = 0.1  # s, by which transforms are post-dated


class Tracking(LocalizationCase):
    def test_pose_stays_right_over_a_drive(self):
        self.wait_for(lambda: self.errors(), "a first pose")
        self.wait_for_answers(50)
        errors = self.errors()
        travelled = sum(abs(b[1] - a[1]) + abs(b[2] - a[2])
                        for a, b in zip(self.truths, self.truths[1:]))
        self.assertGreater(travelled, 5.0)
        self.assertGreater(len(errors), 40)
        for stamp, metres, degrees in errors:
            self.assertLess(metres, 0.15, "at %.1f s" % stamp)
            self.assertLess(degrees, 5.0, "at %.1f s" % stamp)
        self.assertEqual(self.status(), "tracking")

        self.wait_for(self.keeps_a_recent_pose, "a recent pose on the parameter server")

    def keeps_a_recent_pose(self):
        kept = [rospy.get_param("adaptive_localization/initial_pose_" + axis) for axis in "xya"]
        return any(math.dist(kept, pose[1:]) < 0.3 for pose in self.poses[-30:])

    def test_transform_agrees_with_the_pose_and_is_post_dated(self):
        self.wait_for(lambda: self.errors(), "a first pose")
        self.wait_for_answers(2)
        stamp, x, y, yaw = self.poses[-1]
        # tf interpolates between corrections, so they agree only closely
        transform = self.wait_for(lambda: self.lookup(stamp), "map -> base_link").transform
        self.assertAlmostEqual(transform.translation.x, x, delta=0.1)
        self.assertAlmostEqual(transform.translation.y, y, delta=0.1)
        newest = self.tf.lookup_transform("map", "odom", rospy.Time(0)).header.stamp.to_sec()
        self.wait_for(lambda: [s for s, _ in self.words(newest - TOLERANCE - 0.01)
                               if abs(s + TOLERANCE - newest) < 1e-6], "the scan of this transform")

    def lookup(self, stamp):
        when = rospy.Time.from_sec(stamp)
        if self.tf.can_transform("map", "base_link", when):
            return self.tf.lookup_transform("map", "base_link", when)
        return None

    def test_latency_is_told(self):
        statuses = []
        self.subscribers.append(rospy.Subscriber(
            "/diagnostics", DiagnosticArray, lambda array: statuses.extend(
                s for s in array.status if s.name == "adaptive_localization: Latency")))
        self.wait_for_answers(10)
        self.wait_for(lambda: statuses and int(values_of(statuses[-1])["scans"]) > 50, "scans")
        status = statuses[-1]
        values = values_of(status)
        median, _, most = self.assert_latency_is_told(status.level, status.message, values)
        # simulated time waits for the node
        self.assertGreater(median, -100.0)
        self.assertLess(most, 10e3)
        self.assertEqual(values["scans that are old"], "0")

    def test_cloud_confidence_and_status_are_published(self):
        self.wait_for(lambda: len(self.errors()) > 10, "some poses")
        cloud = rospy.wait_for_message("particlecloud", PoseArray, AT_LAST)
        self.assertEqual(cloud.header.frame_id, "map")
        self.assertGreaterEqual(len(cloud.poses), 100)
        x, y, yaw = self.truths[-1][1:]
        near = [p for p in map(planar, cloud.poses)
                if abs(p[0] - x) < 1 and abs(p[1] - y) < 1 and abs(wrap(p[2] - yaw)) < 1]
        self.assertGreater(len(near), 0.8 * len(cloud.poses))
        confidence = rospy.wait_for_message("adaptive_localization/confidence", Float32, AT_LAST)
        self.assertGreater(confidence.data, 0.5)
        dropped = self.status_values()["scans dropped"]  # some may come before tf at the start
        self.wait_for_answers(5)
        values = self.status_values()
        self.assertEqual(values["scans dropped"], dropped)
        self.assertGreater(int(values["scans used"]), 0)
        self.assertGreater(float(values["ms per update"]), 0.0)
        self.assertIn("mass", values["mode 1"])


if __name__ == "__main__":
    rospy.init_node("tracking_test")
    rostest.rosrun("adaptive_localization", "tracking", Tracking, sys.argv)
