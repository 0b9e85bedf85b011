#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What goes out on which scan, set_map, and what /diagnostics tells while something is missing."""
import math
import sys

import rospy
import rostest
from geometry_msgs.msg import PoseArray
from localization_case import AT_LAST, initial_pose
from nav_msgs.srv import SetMap
from std_srvs.srv import Empty
from toy_robot import ToyRobotCase, room


class Publications(ToyRobotCase):
    MOST_LOST = 0

    def counts(self):
        return len(self.poses), len(self.clouds), len(self.corrections)

    def test_each_scan_is_answered_as_the_table_says(self):
        self.wait_for(lambda: self.diagnostic("Scans"), "diagnostics")
        self.wait_for(lambda: "a scan on /scan" in self.diagnostic("Scans")[1], "'a scan'")
        self.assertIn("a map on topic /map", self.diagnostic("Scans")[1])
        self.assertIn("an initial pose", self.diagnostic("Scans")[1])
        self.assertIsNone(self.diagnostic("Standard deviation"))

        # A scan without odometry says which transform it lacks.
        self.scans.publish(self.scan_message())
        self.wait_for(lambda: "transform from 'base_link' to 'odom'" in self.diagnostic("Scans")[1],
                      "'transform'")

        self.set_map_starts_the_node()

        # The first scan after an initial pose, and, as the option says, one more.
        self.forget()
        self.initial_poses.publish(initial_pose(*self.pose))
        self.wait_for_log("Initial pose")
        self.steps(5)
        self.assertEqual(self.counts(), (2, 2, 5))
        self.assertLess(self.error(), 0.15)

        # A robot that stands still gets transforms only, all new.
        self.forget()
        self.steps(10)
        self.assertEqual(self.counts(), (0, 0, 10))
        stamps = [t.header.stamp for t in self.corrections]
        self.assertEqual(len(set(stamps)), 10)
        self.assertAlmostEqual((stamps[-1] - self.time).to_sec(), 0.1, places=6)

        # Every scan beyond the thresholds brings all three; the pose has the scan's stamp.
        self.forget()
        self.steps(10, (0.15, 0.0, 0.0))
        self.assertEqual(self.counts(), (10, 10, 10))
        self.assertAlmostEqual(self.poses[-1][0], self.time.to_sec(), places=6)
        self.assertLess(self.error(), 0.1)

        self.a_late_subscriber_gets_the_newest()

        # A request without motion: one scan.
        self.forget()
        rospy.ServiceProxy("request_nomotion_update", Empty)()
        self.steps(3)
        self.assertEqual(self.counts(), (1, 1, 3))

        # The same stamp again, as from a second laser: no second transform.
        self.forget()
        for _ in range(3):
            self.step(seconds=0.0)
        self.assertEqual(len(self.corrections), 0)

        self.diagnostics_are_fine()

    def set_map_starts_the_node(self):
        rospy.wait_for_service("set_map", 10)
        set_map = rospy.ServiceProxy("set_map", SetMap)
        self.assertFalse(set_map(room(), initial_pose(*self.pose, frame="attic")).success)
        self.assertTrue(set_map(room(), initial_pose(*self.pose, frame="/map")).success)
        self.steps(5)
        self.assertEqual(self.counts(), (1, 1, 5))
        self.assertLess(self.error(), 0.15)
        self.a_refused_map_changes_nothing(set_map)

    def a_refused_map_changes_nothing(self, set_map):
        """Neither the map nor the pose that came with it."""
        empty, full = room(), room()
        empty.data = []
        full.data = [100] * len(full.data)
        for unusable in [empty, full]:
            self.assertFalse(set_map(unusable, initial_pose(6.0, 2.0, 2.0)).success)
        self.assertFalse(set_map(full, initial_pose(*self.pose, frame="attic")).success)
        self.steps(3, (0.11, 0.0, 0.0))
        self.assertLess(self.error(), 0.15)

    def a_late_subscriber_gets_the_newest(self):
        """Also one who is not the first."""
        for _ in range(2):
            modes = rospy.wait_for_message("adaptive_localization/modes", PoseArray, AT_LAST)
            self.assertAlmostEqual(modes.header.stamp.to_sec(), self.time.to_sec(), places=6)
            self.assertLess(math.dist((modes.poses[0].position.x, modes.poses[0].position.y),
                                      self.pose[:2]), 0.1)
            self.steps(1, (0.0, 0.0, 0.3))

    def diagnostics_are_fine(self):
        self.forget()
        self.steps(80, (0.0, 0.0, 0.1))
        self.wait_for(lambda: self.step() or len(self.diagnostics) >= 4, "diagnostics")
        stamps = [array.header.stamp.to_sec() for array in self.diagnostics]
        self.assertGreater(stamps[-1] - stamps[0], len(stamps) - 2.0)  # once a second, or late
        level, message, values = self.diagnostic("Standard deviation")
        self.assertEqual((level, message), (0, "OK"))
        for key in ["std_x", "std_y", "std_yaw"]:
            self.assertLess(float(values[key]), 0.1)
        limits = [values["std_warn_level_" + axis] for axis in ["x", "y", "yaw"]]
        self.assertEqual(limits, ["0.2", "0.2", "0.3"])
        level, message, values = self.diagnostic("Scans")
        self.assertEqual((level, message), (0, "OK"))
        self.assertGreater(int(values["scans used"]), 50)
        level, message, values = self.diagnostic("Latency")
        self.assertGreater(int(values["scans"]), 1)
        self.assert_latency_is_told(level, message, values)

        rospy.ServiceProxy("global_localization", Empty)()
        self.initial_poses.publish(initial_pose(*self.pose, variances=(4.0, 4.0, 1.0)))
        self.step()
        self.wait_for(lambda: self.diagnostic("Scans")[0] == 1, "scans to be missed")


if __name__ == "__main__":
    rospy.init_node("publications_test")
    rostest.rosrun("adaptive_localization", "publications", Publications, sys.argv)
