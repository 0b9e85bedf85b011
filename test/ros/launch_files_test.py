#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""All launch files: what roslaunch-check says about them, and what p3dx.launch starts for which
driver and laser."""
import glob
import os
import sys
import unittest

import roslaunch.config
import roslaunch.rlutil
import rospkg
import rostest

FOLDER = os.path.join(rospkg.RosPack().get_path("adaptive_localization"), "launch")


def load(name, *arguments):
    path = os.path.join(FOLDER, name + ".launch")
    return roslaunch.config.load_config_default([(path, list(arguments))], None)


class LaunchFiles(unittest.TestCase):
    def test_roslaunch_check_finds_nothing(self):
        paths = glob.glob(os.path.join(FOLDER, "*.launch"))
        self.assertGreaterEqual(len(paths), 4)
        for path in paths:
            self.assertIsNone(roslaunch.rlutil.check_roslaunch(path), path)

    def test_amcl_launch_names_the_node_amcl_and_sets_all_its_parameters(self):
        config = load("amcl")
        self.assertEqual([(n.name, n.package, n.type) for n in config.nodes],
                         [("amcl", "adaptive_localization", "adaptive_localization")])
        self.assertIn("/amcl/laser_max_beams", config.params)

    def test_p3dx_starts_the_programs_of_driver_and_laser(self):
        for driver, of_driver in [("none", set()), ("rosaria", {"rosaria/RosAria"}),
                                  ("p2os", {"p2os_driver/p2os_driver", "rostopic/rostopic"})]:
            for laser, of_laser in [("none", set()),
                                    ("sicklms", {"sicktoolbox_wrapper/sicklms",
                                                 "tf2_ros/static_transform_publisher"})]:
                config = load("p3dx", "driver:=" + driver, "laser:=" + laser)
                programs = {n.package + "/" + n.type for n in config.nodes}
                self.assertEqual(programs - {"adaptive_localization/adaptive_localization"},
                                 of_driver | of_laser, (driver, laser))

    def test_p3dx_passes_the_mount_the_ports_and_the_topic(self):
        config = load("p3dx", "driver:=p2os", "laser:=sicklms", "laser_x:=0.1", "map_file:=/m.yaml",
                      "filter:=kld")
        nodes = {n.name: n for n in config.nodes}
        self.assertEqual(nodes["base_link_to_laser"].args.split(),
                         "0.1 0.0 0.30 0.0 0 0 base_link laser".split())
        self.assertEqual(nodes["map_publisher"].args, "'/m.yaml'")
        values = {key: param.value for key, param in config.params.items()}
        self.assertEqual(values["/p2os_driver/port"], "/dev/ttyS0")
        self.assertEqual(values["/sicklms/port"], "/dev/ttyUSB0")
        self.assertEqual(values["/adaptive_localization/filter"], "kld")
        self.assertEqual(values["/adaptive_localization/scan_time_offset"], -0.1)

        config = load("p3dx", "driver:=rosaria", "laser:=rosaria")
        node = next(n for n in config.nodes if n.name == "adaptive_localization")
        self.assertIn(["scan", "/RosAria/lms2xx_1_laserscan"], list(map(list, node.remap_args)))
        self.assertTrue(config.params["/RosAria/publish_aria_lasers"].value)


if __name__ == "__main__":
    rostest.rosrun("adaptive_localization", "launch_files", LaunchFiles, sys.argv)
