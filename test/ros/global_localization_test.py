#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The robot is found from a start that the node does not know, and again when asked to."""
import sys

import rospy
import rostest
from localization_case import LocalizationCase
from std_srvs.srv import Empty


class GlobalLocalization(LocalizationCase):
    def test_robot_is_found_anywhere(self):
        self.wait_for(lambda: self.is_accurate(0.0), "the robot to be found", 60)
        self.assertEqual(self.status(), "tracking")
        rospy.wait_for_service("global_localization", 10)
        begin = rospy.get_time()
        rospy.ServiceProxy("global_localization", Empty)()
        self.wait_for(lambda: self.status() != "tracking", "the pose to be given up")
        self.wait_for(lambda: self.is_accurate(begin), "the robot to be found again", 60)
        self.assertEqual(self.status(), "tracking")


if __name__ == "__main__":
    rospy.init_node("global_localization_test")
    rostest.rosrun("adaptive_localization", "global_localization", GlobalLocalization, sys.argv)
