#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A new map, as large as a shopping centre, comes while the robot drives: the transform goes on while
it is prepared, and the robot is where it was."""
import sys

import rospy
import rostest
from localization_case import initial_pose
from toy_robot import ToyRobotCase, room

SIDE = 3000  # cells


def huge_room():
    """The room in a corner of a large map whose rest is unknown."""
    grid = room()
    width, height = grid.info.width, grid.info.height
    unknown = [-1] * (SIDE - width)
    rows = [grid.data[j * width:(j + 1) * width] + unknown for j in range(height)]
    grid.data = [cell for row in rows for cell in row] + [-1] * (SIDE * (SIDE - height))
    grid.info.width = grid.info.height = SIDE
    return grid


class HugeMap(ToyRobotCase):
    def test_transforms_go_on_while_a_map_is_prepared(self):
        huge = huge_room()
        self.maps.publish(room())
        self.wait_for_log("Map of 165 x 125 cells")
        self.initial_poses.publish(initial_pose(*self.pose))
        self.wait_for_log("Initial pose (%.3f" % self.pose[0])
        self.steps(5)
        self.assertLess(self.error(), 0.1)

        self.forget()
        self.maps.publish(huge)
        size = "%d x %d cells" % (SIDE, SIDE)
        self.wait_for_log("Preparing a map of " + size)
        sent_before = len(self.corrections)
        self.wait_for(lambda: self.step((0.0, 0.0, 0.002)) or self.logged("Map of " + size),
                      "the huge map", pause=0.0)
        # a node that was busy with the map would have answered the one scan that waited for it
        self.assertGreater(len(self.corrections), sent_before + 5)
        self.steps(5, (0.02, 0.0, 0.0))
        self.assertLess(self.error(), 0.1)


if __name__ == "__main__":
    rospy.init_node("huge_map_test")
    rostest.rosrun("adaptive_localization", "huge_map", HugeMap, sys.argv)
