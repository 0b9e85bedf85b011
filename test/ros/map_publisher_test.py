#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The map publisher serves map files as map_server does."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import roslib.packages
import rospy
import rostest
from localization_case import AT_LAST
from nav_msgs.msg import MapMetaData, OccupancyGrid
from nav_msgs.srv import GetMap, LoadMap, LoadMapResponse

YAML = ("image: {image}\nresolution: {resolution}\norigin: [-1, -2, 0.5]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n")


class MapPublisher(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()

    def tearDown(self):
        shutil.rmtree(self.folder)

    def write(self, name, resolution=0.1, image="map.pgm"):
        with open(os.path.join(self.folder, "map.pgm"), "wb") as file:
            file.write(b"P5\n2 3\n255\n" + bytes([0, 254, 205, 254, 254, 254]))
        path = os.path.join(self.folder, name)
        with open(path, "w") as file:
            file.write(YAML.format(image=image, resolution=resolution))
        return path

    def change(self, path):
        rospy.wait_for_service("change_map", AT_LAST)
        return rospy.ServiceProxy("change_map", LoadMap)(path)

    def test_1_map_is_latched_and_served(self):
        grid = rospy.wait_for_message("map", OccupancyGrid, AT_LAST)
        self.assertEqual(grid.header.frame_id, "site")
        self.assertEqual(len(grid.data), grid.info.width * grid.info.height)
        self.assertEqual(set(grid.data), {0, 100, -1})
        self.assertEqual(rospy.wait_for_message("map_metadata", MapMetaData, AT_LAST), grid.info)
        rospy.wait_for_service("static_map", AT_LAST)
        self.assertEqual(rospy.ServiceProxy("static_map", GetMap)().map, grid)

    def test_2_bad_maps_are_refused_with_a_reason_and_the_old_one_stays(self):
        before = rospy.wait_for_message("map", OccupancyGrid, AT_LAST)
        cases = [
            ("/no/such/map.yaml", LoadMapResponse.RESULT_MAP_DOES_NOT_EXIST),
            (self.write("lost.yaml", image="lost.pgm"), LoadMapResponse.RESULT_MAP_DOES_NOT_EXIST),
            (self.write("zero.yaml", resolution=0), LoadMapResponse.RESULT_INVALID_MAP_METADATA),
            (self.write("odd.yaml", image="odd.yaml"), LoadMapResponse.RESULT_INVALID_MAP_DATA),
        ]
        for path, result in cases:
            response = self.change(path)
            self.assertEqual(response.result, result, path)
            self.assertEqual(len(response.map.data), 0)
        self.assertEqual(rospy.wait_for_message("map", OccupancyGrid, AT_LAST), before)

    def test_3_map_is_changed(self):
        for url in [self.write("good.yaml"), "file://" + self.write("good.yaml")]:
            response = self.change(url)
            self.assertEqual(response.result, LoadMapResponse.RESULT_SUCCESS)
            self.assertEqual(list(response.map.data), [0, 0, -1, 0, 100, 0])
            self.assertAlmostEqual(response.map.info.resolution, 0.1, places=6)
            self.assertEqual(response.map.info.origin.position.y, -2)
            self.assertAlmostEqual(response.map.info.origin.orientation.z, 0.24740396, places=6)
            published = rospy.wait_for_message("map", OccupancyGrid, AT_LAST)
            self.assertEqual(published.data, response.map.data)

    def test_start_up_errors_are_one_fatal_line(self):
        program = roslib.packages.find_node("adaptive_localization", "map_publisher")[0]
        for arguments, expected in [
                ([], "usage: map_publisher MAP.yaml"),
                (["/no/such/map.yaml"], "map file '/no/such/map.yaml' cannot be opened"),
                ([self.write("zero.yaml", resolution=0)], "'resolution': got '0', expected")]:
            done = subprocess.run([program, "__name:=map_publisher_wrong"] + arguments,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=AT_LAST)
            output = done.stdout.decode()
            self.assertEqual(done.returncode, 1, output)
            self.assertEqual(output.count("FATAL"), 1, output)
            self.assertIn(expected, output)


if __name__ == "__main__":
    rospy.init_node("map_publisher_test")
    rostest.rosrun("adaptive_localization", "map_publisher", MapPublisher, sys.argv)
