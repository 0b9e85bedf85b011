#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""All launch files: what roslaunch-check says about them and what their arguments are, what rviz is
told to show, and what p3dx.launch starts for which driver and laser."""
import glob
import os
import re
import sys
import unittest
import xml.etree.ElementTree

import rosgraph.names
import roslaunch.arg_dump
import roslaunch.config
import roslaunch.rlutil
import rospkg
import rostest

PACKAGE = rospkg.RosPack().get_path("adaptive_localization")
FOLDER = os.path.join(PACKAGE, "launch")
PATHS = glob.glob(os.path.join(FOLDER, "*.launch"))


def load(name, *arguments):
    path = os.path.join(FOLDER, name + ".launch")
    return roslaunch.config.load_config_default([(path, list(arguments))], None)


def topics_shown():
    with open(os.path.join(PACKAGE, "config/localization.rviz")) as file:
        return re.findall(r"Topic: (\S+)", file.read())


class LaunchFiles(unittest.TestCase):
    def node(self, config, name):
        found = [node for node in config.nodes if node.name == name]
        self.assertEqual(len(found), 1, name)
        return found[0]

    def shown(self, config):
        """The topics that rviz has, by the names in its configuration, remapped."""
        node = self.node(config, "rviz")
        remaps = {rosgraph.names.resolve_name(old, "/rviz"): rosgraph.names.resolve_name(new, "/rviz")
                  for old, new in node.remap_args}
        names = {topic: rosgraph.names.resolve_name(topic, "/rviz") for topic in topics_shown()}
        return {topic: remaps.get(name, name) for topic, name in names.items()}

    def test_roslaunch_check_finds_nothing(self):
        self.assertGreaterEqual(len(PATHS), 5)
        for path in PATHS:
            self.assertIsNone(roslaunch.rlutil.check_roslaunch(path), path)

    def test_all_arguments_have_a_default_and_say_what_they_are(self):
        for path in PATHS:
            for name, (doc, default) in roslaunch.arg_dump.get_args([path]).items():
                self.assertTrue(default, "%s: --ros-args calls %s required" % (path, name))
                self.assertTrue(doc, "%s: --ros-args says nothing of %s" % (path, name))

    def test_map_and_parameter_file_may_be_left_out(self):
        for nothing in ["none", ""]:
            config = load("localization", "map_file:=" + nothing, "params:=" + nothing)
            self.assertEqual([node.type for node in config.nodes], ["adaptive_localization"])

    def test_amcl_launch_names_the_node_amcl_and_sets_all_its_parameters(self):
        config = load("amcl")
        self.assertEqual([(n.name, n.package, n.type) for n in config.nodes],
                         [("amcl", "adaptive_localization", "adaptive_localization")])
        self.assertIn("/amcl/laser_max_beams", config.params)

    def test_rviz_shows_the_node_by_whatever_name(self):
        own = [topic for topic in topics_shown() if topic.startswith("adaptive_localization/")]
        self.assertEqual(len(own), 6)
        for config, name in [(load("amcl", "rviz:=true"), "amcl"),
                             (load("p3dx", "name:=where", "rviz:=true"), "where"),
                             (load("localization", "name:=where", "rviz:=true"), "where"),
                             (load("localization", "rviz:=true"), "adaptive_localization"),
                             (load("demo"), "adaptive_localization")]:
            self.node(config, name)
            shown = self.shown(config)
            for topic in own:
                self.assertEqual(shown[topic], "/%s/%s" % (name, topic.split("/")[1]))

    def test_rviz_shows_the_scans_and_the_frame_that_are_used(self):
        config = load("localization", "rviz:=true", "scan_topic:=base_scan",
                      "global_frame_id:=site")
        self.assertEqual(self.shown(config)["scan"], "/base_scan")
        self.assertIn("-f site", self.node(config, "rviz").args)

    def test_2d_nav_goal_kidnaps_in_the_demo_alone(self):
        goal = "move_base_simple/goal"
        self.assertEqual(self.shown(load("demo"))[goal], "/kidnap")
        for name in ["amcl", "localization", "p3dx"]:
            self.assertEqual(self.shown(load(name, "rviz:=true"))[goal], "/" + goal, name)

    def test_p3dx_starts_the_programs_of_driver_and_laser(self):
        always = {"adaptive_localization/adaptive_localization",
                  "robot_state_publisher/robot_state_publisher"}
        for driver, of_driver in [("none", set()), ("rosaria", {"rosaria/RosAria"}),
                                  ("p2os", {"p2os_driver/p2os_driver", "rostopic/rostopic"})]:
            for laser, of_laser in [("none", set()), ("sicklms", {"sicktoolbox_wrapper/sicklms"})]:
                config = load("p3dx", "driver:=" + driver, "laser:=" + laser)
                programs = {n.package + "/" + n.type for n in config.nodes}
                self.assertEqual(programs, always | of_driver | of_laser, (driver, laser))

    def test_p3dx_refuses_drivers_and_lasers_that_it_does_not_know(self):
        for argument, known in [("driver:=p2oss", "['p2os', 'rosaria', 'none']"),
                                ("laser:=lms", "['sicklms', 'rosaria', 'none']")]:
            with self.assertRaises(roslaunch.RLException) as refused:
                load("p3dx", argument)
            self.assertIn("'" + argument.split(":=")[1] + "' is not in list", str(refused.exception))
            self.assertIn(known, str(refused.exception))

    def test_p3dx_passes_the_ports_and_the_topic(self):
        config = load("p3dx", "driver:=p2os", "laser:=sicklms", "map_file:=/m.yaml", "filter:=kld")
        self.assertEqual(self.node(config, "map_publisher").args, "'/m.yaml'")
        values = {key: param.value for key, param in config.params.items()}
        self.assertEqual(values["/p2os_driver/port"], "/dev/ttyS0")
        self.assertEqual(values["/sicklms/port"], "/dev/ttyUSB0")
        self.assertEqual(values["/adaptive_localization/filter"], "kld")

        config = load("p3dx", "driver:=rosaria", "laser:=rosaria")
        remaps = map(list, self.node(config, "adaptive_localization").remap_args)
        self.assertIn(["scan", "/RosAria/lms2xx_1_laserscan"], list(remaps))
        self.assertTrue(config.params["/RosAria/publish_aria_lasers"].value)

    def test_p3dx_gives_the_odometry_of_both_drivers_the_same_name(self):
        for driver, name, pose in [("p2os", "p2os_driver", "pose"), ("rosaria", "RosAria", "~pose")]:
            node = self.node(load("p3dx", "driver:=" + driver), name)
            self.assertIn([pose, "odom"], list(map(list, node.remap_args)))

    def test_p3dx_lets_sicklms_stamp_its_scans_rightly(self):
        for baud, offset in [(38400, -0.1), (500000, 0.0)]:
            config = load("p3dx", "laser:=sicklms", "laser_baud:=%d" % baud)
            self.assertEqual(config.params["/sicklms/time_offset"].value, offset)
            self.assertEqual(config.params["/adaptive_localization/scan_time_offset"].value, 0.0)
        config = load("p3dx", "scan_time_offset:=-0.2")
        self.assertEqual(config.params["/adaptive_localization/scan_time_offset"].value, -0.2)

    def test_p3dx_describes_the_robot_with_its_laser_where_it_is_told(self):
        config = load("p3dx", "laser:=sicklms", "laser_x:=-0.1", "laser_y:=0.02", "laser_z:=0.4",
                      "laser_yaw:=0.5", "laser_frame:=lms")
        urdf = xml.etree.ElementTree.fromstring(config.params["/robot_description"].value)
        mounts = [joint for joint in urdf.findall("joint") if joint.find("child").get("link") == "lms"]
        self.assertEqual(len(mounts), 1)
        self.assertEqual(mounts[0].find("parent").get("link"), "base_link")
        self.assertEqual(mounts[0].find("origin").attrib, {"xyz": "-0.1 0.02 0.4", "rpy": "0 0 0.5"})
        self.assertEqual(urdf.find("sensor/parent").get("link"), "lms")
        links = [link.get("name") for link in urdf.findall("link")]
        self.assertIn("lms", links)
        self.assertNotIn("laser", links)
        self.assertEqual(config.params["/sicklms/frame_id"].value, "lms")

    def test_p3dx_can_leave_the_model_to_others(self):
        config = load("p3dx", "robot_model:=false")
        self.assertNotIn("/robot_description", config.params)
        self.assertEqual([node.type for node in config.nodes], ["adaptive_localization"])


if __name__ == "__main__":
    rostest.rosrun("adaptive_localization", "launch_files", LaunchFiles, sys.argv)
