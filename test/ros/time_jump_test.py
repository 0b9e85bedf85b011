#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Time jumps back, with the robot where it was and elsewhere, and forward; odometry starts anew."""
import math
import sys

import rospy
import rostest
from toy_robot import ToyRobotCase

TURN = (0.05, 0.0, 0.1)


class TimeJump(ToyRobotCase):
    def setUp(self):
        super().setUp()
        self.subscribers.pop(0).unregister()  # our own tf would complain about old data

    def test_node_goes_on_after_jumps(self):
        self.localize()
        self.steps(20, TURN)
        self.check_tracking()

        # A simulation started again: odometry too, the robot is where it was.
        self.forget()
        self.time -= rospy.Duration(100)
        self.odometry = (0.0, 0.0, 0.0)
        self.steps(20, TURN)
        self.check_logged_once("Time jumped back by 99.9 s")
        self.check_tracking()
        self.check_stamps()
        self.check_kept()
        self.wait_for(lambda: self.step() or self.is_diagnosed(), "diagnostics after the jump")

        # A bag played again: the robot is elsewhere, standing still at first.
        self.forget()
        self.time -= rospy.Duration(200)
        self.pose, self.odometry = (5.5, 1.2, 2.5), (3.0, 1.0, 1.0)
        self.steps(25)
        self.assertTrue(self.status() != "tracking" or self.error() < 0.12)
        self.steps(80, (0.03, 0.0, 0.06))
        self.check_logged_once("Time jumped back")
        self.check_tracking()

        # A pause in which the robot drove on.
        self.forget()
        self.time += rospy.Duration(50)
        self.step((0.2, 0.1, 0.2))
        self.steps(10, TURN)
        self.check_logged_once("No scan for 50.1 s, or time jumped")
        self.check_tracking()

        # A driver started again: odometry alone jumps.
        self.forget()
        self.odometry = (30.0, -10.0, 2.0)
        self.steps(10, TURN)
        self.check_logged_once("Odometry jumped")
        self.check_tracking()

        # The same, to its origin, after a pause in which scans came.
        self.forget()
        for _ in range(15):
            self.move()
            self.scans.publish(self.scan_message())
        self.move()
        self.odometry = (0.0, 0.0, 0.0)
        self.send_odometry()
        self.steps(20, TURN)
        self.check_logged_once("Odometry jumped")
        self.wait_for_log("odometry was silent, and then started anew")
        self.check_tracking()

        # The robot drives a circle, to the origin of its odometry, while no scans come.
        self.forget()
        for _ in range(42):
            self.move(TURN)
            self.send_odometry()
        self.step(TURN)
        self.assertLess(math.hypot(*self.odometry[:2]), 0.05)
        self.steps(10, TURN)
        self.check_tracking()
        self.assertFalse(self.logged("Odometry jumped"), self.logs)

    def check_logged_once(self, text):
        self.wait_for_log(text)
        self.assertEqual(len(self.logged(text)), 1, self.logs)

    def is_diagnosed(self):
        scans = self.diagnostic("Scans")
        return scans and scans[0] == 0 and self.diagnostic("Standard deviation")

    def check_tracking(self):
        self.assertEqual(self.status(), "tracking", self.status_values())
        self.assertLess(self.error(), 0.12)

    def check_stamps(self):
        stamps = [t.header.stamp for t in self.corrections]
        self.assertGreater(len(stamps), 15)
        self.assertEqual(stamps, sorted(set(stamps)))
        self.assertAlmostEqual((stamps[-1] - self.time).to_sec(), 0.1, places=6)

    def check_kept(self):
        for axis, now in zip("xy", self.pose):
            self.wait_for_param("adaptive_localization/initial_pose_" + axis,
                                lambda kept, now=now: abs(kept - now) < 0.15)


if __name__ == "__main__":
    rospy.init_node("time_jump_test")
    rostest.rosrun("adaptive_localization", "time_jump", TimeJump, sys.argv)
