#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Maps from the topic: an initial pose that comes before, a map in another frame, and no second map
where first_map_only says so."""
import sys

import rospy
import rostest
from localization_case import initial_pose
from toy_robot import ToyRobotCase, room


class AmclMaps(ToyRobotCase):
    def test_first_map_is_the_only_one(self):
        wrong = (7.0, 2.0, 0.0)
        for pose in [wrong, self.pose]:
            self.initial_poses.publish(initial_pose(*pose))
            self.wait_for_log("Initial pose (%.3f" % pose[0])
        self.maps.publish(room(frame="attic"))
        self.wait_for_log("The map's frame is 'attic', but global_frame_id is 'map'")
        self.wait_for_log("Map of 165 x 125 cells")

        self.steps(5)
        self.assertGreater(len(self.poses), 0)
        self.assertLess(self.error(), 0.15)

        self.wait_for(lambda: self.maps.get_num_connections() == 0, "the node to hear no more maps")
        self.forget()
        self.maps.publish(room())
        self.steps(5)
        self.assertEqual(self.logged("Map of"), [])


if __name__ == "__main__":
    rospy.init_node("amcl_maps_test")
    rostest.rosrun("adaptive_localization", "amcl_maps", AmclMaps, sys.argv)
