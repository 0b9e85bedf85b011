#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The laser is set up anew while the robot drives: the energy grid is built once more, not with each
scan, and the robot stays known. So it does where the driver sends sweeps that cannot be."""
import math
import sys

import rospy
import rostest
from localization_case import initial_pose
from toy_robot import ToyRobotCase, room


class ScanGeometry(ToyRobotCase):
    time_increment = 0.0  # s

    def test_another_geometry_means_one_more_grid(self):
        self.maps.publish(room())
        self.wait_for_log("Map of")
        self.initial_poses.publish(initial_pose(*self.pose))
        self.wait_for_log("Initial pose")
        for view, grids in [(math.pi, 1), (1.5 * math.pi, 1), (math.pi, 0)]:
            self.forget()
            self.view = view
            for _ in range(20):
                self.step((0.02, 0.0, 0.05))
            self.steps(10, (-0.03, 0.0, -0.05))
            if grids > 0:
                self.wait_for_log("Energy grid ready")
            self.assertEqual(len(self.logged("Building the energy grid")), grids, self.logs)
            self.assertEqual(len(self.logged("Energy grid ready")), grids, self.logs)
            self.assertEqual(self.status(), "tracking")
            self.assertLess(self.error(), 0.1)

        # A driver that sends any number: a sweep of 0.9 s, ten times a second.
        self.forget()
        self.time_increment = 0.005
        self.steps(30, (0.04, 0.0, 0.1))
        self.assertLess(self.error(), 0.03)
        self.assertEqual(len(self.logged("longer than the time between scans")), 1, self.logs)

    def scan_message(self, *arguments, **named):
        named["beams"] = round(math.degrees(self.view)) + 1
        scan = super().scan_message(*arguments, **named)
        scan.time_increment = self.time_increment
        return scan


if __name__ == "__main__":
    rospy.init_node("scan_geometry_test")
    rostest.rosrun("adaptive_localization", "scan_geometry", ScanGeometry, sys.argv)
