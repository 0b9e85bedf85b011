#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The energy grid of a large map is kept from start to start; what cannot be read or written is
said, and the node lives on."""
import os
import random
import re
import shutil
import signal
import sys
import tempfile

import rospy
import rostest
from amcl_protocol import Programs
from localization_case import AT_LAST
from nav_msgs.msg import OccupancyGrid
from rosgraph_msgs.msg import Log
from toy_robot import ToyRobotCase, room

SIDE = 1000  # cells


def large_room():
    """The room in a corner of a large hall full of boxes."""
    small, randomness = room(), random.Random(1)
    rows = [[0] * SIDE for _ in range(SIDE)]
    for _ in range(600):
        x, y = randomness.randrange(SIDE - 12), randomness.randrange(SIDE - 12)
        for row in rows[y:y + 3 + randomness.randrange(10)]:
            row[x:x + 8] = [100] * 8
    for j in range(small.info.height):
        width = small.info.width
        rows[j][:width] = small.data[j * width:(j + 1) * width]
    grid = OccupancyGrid()
    grid.header, grid.info = small.header, small.info
    grid.info.width = grid.info.height = SIDE
    grid.data = [cell for row in rows for cell in row]
    return grid


def truncate(name):
    os.truncate(name, os.path.getsize(name) // 2)


def change(name):
    """One bit in the middle."""
    with open(name, "r+b") as file:
        file.seek(os.path.getsize(name) // 2)
        byte = file.read(1)[0]
        file.seek(-1, os.SEEK_CUR)
        file.write(bytes([byte ^ 0x10]))


class EnergyCache(ToyRobotCase):
    @classmethod
    def setUpClass(cls):
        cls.map = large_room()

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="energy_cache_")
        self.addCleanup(shutil.rmtree, self.folder)
        self.programs = Programs()
        self.addCleanup(self.programs.end)
        self.node = None
        if rospy.has_param("/adaptive_localization"):
            rospy.delete_param("/adaptive_localization")

    def start(self, cache_dir, max_memory=500.0):
        """Starts a node, waits for its grid; returns "built" or "loaded"."""
        rospy.set_param("/adaptive_localization", {
            "cache_dir": cache_dir, "energy_grid_max_memory": max_memory, "use_map_topic": True,
            "initial_pose_x": 1.5, "initial_pose_y": 1.0, "initial_pose_a": 0.3})
        self.node = self.programs.start("adaptive_localization")
        super().setUp()  # the robot
        self.warnings = []
        self.subscribers.append(rospy.Subscriber("/rosout", Log, self.on_log))
        self.maps.publish(self.map)
        self.wait_for_log("Map of")
        self.wait_for(lambda: self.step() or self.logged("Energy grid ready"), "the energy grid")
        self.ready = self.logged("Energy grid ready")[0]
        print(self.ready)
        return re.search(r"(built|loaded) in [0-9.]+ s", self.ready).group(1)

    def on_log(self, log):
        if log.level >= Log.WARN and log.name == "/adaptive_localization":
            self.warnings.append(log.msg)

    def stop(self):
        """The node works to the end."""
        self.steps(10, (0.02, 0.0, 0.05))
        self.assertEqual(self.status(), "tracking")
        self.assertLess(self.error(), 0.1)
        self.assertIsNone(self.node.poll())
        self.node.send_signal(signal.SIGINT)
        self.assertEqual(self.node.wait(AT_LAST), 0)
        self.tearDown()

    def files(self):
        return [os.path.join(self.folder, name) for name in sorted(os.listdir(self.folder))]

    def test_the_second_start_loads_what_the_first_one_built(self):
        self.assertEqual(self.start(self.folder), "built")
        self.stop()
        sizes = [os.path.getsize(name) for name in self.files()]
        self.assertGreater(len(sizes), 0)
        written = [os.stat(name).st_ino for name in self.files()]

        self.assertEqual(self.start(self.folder), "loaded")
        self.stop()
        self.assertEqual(self.warnings, [])
        self.assertEqual([os.stat(name).st_ino for name in self.files()], written)

        for name in self.files():
            for damage in [truncate, change]:
                with self.subTest(file=name, damage=damage.__name__):
                    damage(name)
                    self.assertEqual(self.start(self.folder), "built")
                    self.stop()
                    self.assertEqual(len(self.warnings), 1, self.warnings)
                    self.assertIn(name, self.warnings[0])
                    self.assertEqual([os.path.getsize(file) for file in self.files()], sizes)
        self.assertEqual(self.start(self.folder), "loaded")
        self.stop()

    def test_a_folder_that_cannot_be_written_is_one_warning(self):
        occupied = os.path.join(self.folder, "file")
        open(occupied, "w").close()
        for _ in range(2):
            self.assertEqual(self.start(os.path.join(occupied, "cache")), "built")
            self.stop()
            self.assertEqual(len(self.warnings), 1, self.warnings)
            self.assertIn(os.path.join(occupied, "cache"), self.warnings[0])

    def test_without_a_folder_nothing_is_kept(self):
        before = set(os.listdir("."))
        self.assertEqual(self.start(""), "built")
        self.stop()
        self.assertEqual(self.warnings, [])
        self.assertEqual(set(os.listdir(".")), before)

    def test_where_memory_is_short_the_grid_is_coarser(self):
        self.assertEqual(self.start("", max_memory=30.0), "built")
        self.stop()
        self.assertEqual(len(self.warnings), 1, self.warnings)
        self.assertRegex(self.warnings[0], "one cell of ([3-9]) by \\1 .* energy_grid_max_memory")
        megabytes = float(re.search("([0-9.]+) MB", self.ready).group(1))
        self.assertLess(megabytes, 30.0)


if __name__ == "__main__":
    rospy.init_node("energy_cache_test")
    rostest.rosrun("adaptive_localization", "energy_cache", EnergyCache, sys.argv)
