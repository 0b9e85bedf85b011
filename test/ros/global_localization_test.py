#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The robot is found from a start that the node does not know, and again after it was carried away,
when asked to."""
import sys

import rospy
import rostest
from localization_case import AT_LAST, LocalizationCase
from std_srvs.srv import Empty


class GlobalLocalization(LocalizationCase):
    def test_robot_is_found_anywhere(self):
        self.wait_for(lambda: self.is_found(0.0), "the robot to be found")
        for service in ["kidnap_random", "global_localization"]:
            rospy.wait_for_service(service, AT_LAST)
            rospy.ServiceProxy(service, Empty)()
        begin = rospy.get_time()
        self.wait_for(lambda: self.is_found(begin), "the robot to be found again")

    def is_found(self, since):
        """Where it is, and no longer where it might be as well."""
        return self.is_accurate(since) and self.status() == "tracking"


if __name__ == "__main__":
    rospy.init_node("global_localization_test")
    rostest.rosrun("adaptive_localization", "global_localization", GlobalLocalization, sys.argv)
