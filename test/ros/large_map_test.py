#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A building of 200 m x 200 m, 4000 x 4000 cells: a robot that is carried to its other end is found,
and tracking is said of no wrong place. How late scans were answered is told, but not judged: that is
a question of the machine, and what may be searched per scan is tested in laws/update_budget_test."""
import os
import random
import sys
import tempfile

import rospy
import rostest
from amcl_protocol import Programs
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped, Twist
from localization_case import LocalizationCase, values_of

ROOMS, ROOM, SIDE = 20, 200, 4000  # along each side; cells, of 5 cm
WALL, DOOR = 4, 30  # cells
FREE, OCCUPIED = b"\xfe", b"\x00"
PLACES = [(195.0, 194.0, 0.0), (15.0, 184.0, 2.0), (105.0, 94.0, -1.0)]


def middle(room):
    """Of a room along one side, m."""
    return (room + 0.5) * ROOM * 0.05


def building():
    """The cells of 400 rooms of 10 m, each with furniture of its own, and doors between all."""
    cells = bytearray(FREE * (SIDE * SIDE))

    def fill(left, low, right, high, value=OCCUPIED):
        left, low, right, high = max(left, 0), max(low, 0), min(right, SIDE), min(high, SIDE)
        for y in range(low, high):
            cells[y * SIDE + left:y * SIDE + right] = value * (right - left)

    for k in range(ROOMS + 1):
        at = k * ROOM - WALL // 2
        fill(at, 0, at + WALL, SIDE)
        fill(0, at, SIDE, at + WALL)
    for k in range(1, ROOMS):
        at = k * ROOM - WALL // 2
        for room in range(ROOMS):
            door = room * ROOM + ROOM // 2 - DOOR // 2
            fill(at, door, at + WALL, door + DOOR, FREE)
            fill(door, at, door + DOOR, at + WALL, FREE)
    for room in range(ROOMS * ROOMS):
        for _ in range(5):
            width, height = random.randint(10, 40), random.randint(10, 40)
            x = random.choice([random.randint(2, 60 - width // 2), random.randint(140, 180)])
            y = random.choice([random.randint(2, 60 - height // 2), random.randint(140, 180)])
            left, low = room % ROOMS * ROOM + x, room // ROOMS * ROOM + y
            fill(left, low, left + width // 2, low + height // 2)
    return bytes(cells)


def write_map(folder):
    with open(os.path.join(folder, "map.pgm"), "wb") as image:
        image.write(b"P5\n%d %d\n255\n" % (SIDE, SIDE) + building())
    path = os.path.join(folder, "map.yaml")
    with open(path, "w") as text:
        text.write("image: map.pgm\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
    return path


class LargeMap(LocalizationCase):
    def setUp(self):
        super().setUp()
        random.seed(1)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = write_map(folder.name)
        self.latency = None
        rospy.Subscriber("/diagnostics", DiagnosticArray, self.on_diagnostics)
        self.kidnaps = rospy.Publisher("kidnap", PoseStamped, queue_size=1)
        self.command = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        programs = Programs()
        self.addCleanup(programs.end)
        programs.start("map_publisher", path)
        start = "%.1f,%.1f,0" % (middle(0), middle(0) - 1.0)
        programs.start("p3dx_simulator", world=path, start=start, lock_step="true", seed=1)
        x, y, _ = start.split(",")
        programs.start("adaptive_localization", initial_pose_x=x, initial_pose_y=y, seed=1,
                       cache_dir=folder.name)

    def on_diagnostics(self, message):
        for status in message.status:
            if status.name.endswith("Latency"):
                self.latency = status

    def drive_round(self):
        """Round the middle of a room, a metre from it, for ever: a robot that is told nothing stops."""
        twist = Twist()
        twist.linear.x = twist.angular.z = 0.4
        timer = rospy.Timer(rospy.Duration(0.1), lambda event: self.command.publish(twist))
        self.addCleanup(timer.shutdown)

    def test_a_robot_that_is_carried_away_is_found(self):
        self.wait_for(lambda: self.status() == "tracking", "tracking")
        self.drive_round()
        self.wait_for_answers(10.0)
        for place in PLACES:
            with self.subTest(place=place):
                begin = self.carry(self.kidnaps, *place)
                self.wait_for(lambda: any(word != "tracking" for _, word in self.words(begin)),
                              "the node to notice")
                self.wait_for(lambda: self.status() == "tracking" and self.is_accurate(begin),
                              "the robot to be found")
                wrong = [stamp for stamp, metres, _ in self.errors(begin) if metres > 0.5]
                said = [stamp for stamp, word in self.words(begin)
                        if word == "tracking" and stamp in set(wrong)]
                print("found after %.1f s" % (max(wrong) - begin + 0.1))
                self.assertLess(max(wrong) - begin, 20.0)
                self.assertLess(len(said), 10, "scans of which tracking was said of a wrong pose")
                self.wait_for_answers(5.0)
        self.wait_for(lambda: self.latency, "the latency")
        told = values_of(self.latency)
        print(", ".join("%s: %s" % item for item in told.items()))
        self.assertGreater(int(told["scans"]), 100)


if __name__ == "__main__":
    rospy.init_node("large_map_test")
    rostest.rosrun("adaptive_localization", "large_map", LargeMap, sys.argv)
