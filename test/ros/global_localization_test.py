#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The robot is found from a start that the node does not know, and again after it was carried away,
when asked to."""
import sys

import rospy
import rostest
from localization_case import LocalizationCase
from std_srvs.srv import Empty


class GlobalLocalization(LocalizationCase):
    def test_robot_is_found_anywhere(self):
        self.wait_for(lambda: self.is_accurate(0.0), "the robot to be found", 60)
        self.assertEqual(self.status(), "tracking")
        for service in ["kidnap_random", "global_localization"]:
            rospy.wait_for_service(service, 10)
            rospy.ServiceProxy(service, Empty)()
        begin = rospy.get_time()
        self.wait_for(lambda: self.is_accurate(begin), "the robot to be found again", 60)
        self.assertEqual(self.status(), "tracking")


if __name__ == "__main__":
    rospy.init_node("global_localization_test")
    rostest.rosrun("adaptive_localization", "global_localization", GlobalLocalization, sys.argv)
