#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Cells of the map change while the robot drives: what is sent on map_updates is in the map that the
scans are compared with, and what does not fit into it is refused."""
import sys

import rospy
import rostest
from localization_case import initial_pose
from map_msgs.msg import OccupancyGridUpdate
from toy_robot import ToyRobotCase, room

LEFT = 120  # column of the map from which on the first map has rock, 6 m from the origin


def old_room():
    """The room before its last two metres were there."""
    grid = room()
    width = grid.info.width
    grid.data = [100 if i % width >= LEFT else cell for i, cell in enumerate(grid.data)]
    return grid


def update(left, low, right, high):
    """Of these columns and rows, from the room as it is."""
    grid = room()
    message = OccupancyGridUpdate()
    message.header.frame_id = "map"
    message.x, message.y, message.width, message.height = left, low, right - left, high - low
    message.data = [grid.data[y * grid.info.width + x]
                    for y in range(low, high) for x in range(left, right)]
    return message


class MapUpdates(ToyRobotCase):
    def setUp(self):
        super().setUp()
        self.updates = self.publisher("map_updates", OccupancyGridUpdate)
        self.wait_for_connections(self.updates)

    def inliers(self):
        self.step((0.0, 0.0, 0.02))
        return float(self.status_values()["match inliers"])

    def refused(self, message, why):
        """Errors of one topic are told every five seconds at the most."""
        self.wait_for(lambda: self.updates.publish(message) or self.logged(why),
                      "'%s' in the log" % why, pause=1.0)

    def test_scans_are_compared_with_what_the_map_is_now(self):
        self.refused(update(0, 0, 5, 5), "map update: got one before any map")
        self.maps.publish(old_room())
        self.wait_for_log("Map of 165 x 125 cells")
        self.initial_poses.publish(initial_pose(*self.pose))
        self.wait_for_log("Initial pose")
        self.steps(3, (0.02, 0.0, 0.02))
        before = max(self.inliers() for _ in range(5))
        self.assertLess(before, 0.95)

        for left in range(LEFT, 165, 15):  # in nine parts
            for low in range(0, 125, 50):
                self.updates.publish(update(left, low, left + 15, min(low + 50, 125)))
        self.wait_for_log("Map updated")
        self.wait_for(lambda: self.inliers() > 0.99, "the whole room in the map")
        self.assertLess(self.error(), 0.1)
        self.assertEqual(self.logged("Map not used"), [])

        self.forget()
        beyond = update(160, 120, 165, 125)
        beyond.x = 161
        self.refused(beyond, "map update: got 25 cells for 5 x 5 at (161, 120), expected at least "
                     "one, all within the map's 165 x 125")
        short = update(0, 0, 5, 5)
        short.data = short.data[:-1]
        self.refused(short, "map update: got 24 cells for 5 x 5 at (0, 0), expected 25")
        full = update(0, 0, 165, 125)
        full.data = [100] * (165 * 125)
        self.refused(full, "Map not used: map: got no free cell")
        self.steps(5, (0.0, 0.0, 0.1))
        self.assertGreater(self.inliers(), 0.99)
        self.assertLess(self.error(), 0.1)


if __name__ == "__main__":
    rospy.init_node("map_updates_test")
    rostest.rosrun("adaptive_localization", "map_updates", MapUpdates, sys.argv)
