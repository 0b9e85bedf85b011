#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How the node starts and ends: parameters good and bad, and a stop before there is a map."""
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import roslib.packages
import rosparam
import rospkg
import rospy
import rostest
from localization_case import AT_LAST

PROGRAM = roslib.packages.find_node("adaptive_localization", "adaptive_localization")[0]


class StartUp(unittest.TestCase):
    def setUp(self):
        if rospy.has_param("/node"):
            rospy.delete_param("/node")

    def start(self, *arguments):
        environment = dict(os.environ, ROSCONSOLE_STDOUT_LINE_BUFFERED="1")
        return subprocess.Popen([PROGRAM, "__name:=node"] + list(arguments), env=environment,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def run_until_it_waits(self, *arguments):
        """The output up to where the node waits for its map; there it is interrupted."""
        process = self.start(*arguments)
        end = time.time() + AT_LAST
        output = ""
        while "Waiting for a map" not in output and time.time() < end:
            line = process.stdout.readline().decode()
            if not line:
                break
            output += line
        process.send_signal(signal.SIGINT)
        output += process.communicate(timeout=AT_LAST)[0].decode()
        return process.returncode, output

    def test_interrupt_before_the_map_ends_well_and_keeps_no_pose(self):
        code, output = self.run_until_it_waits()
        self.assertEqual(code, 0, output)
        self.assertFalse(rospy.has_param("/node/initial_pose_a"))

    def test_stock_amcl_parameters_load_unchanged(self):
        path = os.path.join(rospkg.RosPack().get_path("adaptive_localization"), "config/amcl.yaml")
        given = rosparam.load_file(path)[0][0]
        self.assertGreater(len(given), 40)
        rospy.set_param("/node", given)
        code, output = self.run_until_it_waits()
        self.assertEqual(code, 0, output)
        self.assertNotIn("WARN", output)
        self.assertIn("amcl's usual values", output)
        self.assertIn("laser_max_beams", output)
        self.assertIn("laser_sigma_hit: 0.2\n", output)
        self.assertIn("no effect here: bag_scan_period", output)

    def test_unknown_nested_and_nan_parameters_are_warned_about(self):
        rospy.set_param("/node", {"laser_max_beans": 3, "gains": [1, 2], "group": {"a": 1},
                                  "initial_pose_x": float("nan"), "kld_err": "5e-2"})
        code, output = self.run_until_it_waits()
        self.assertEqual(code, 0, output)
        self.assertIn("Unknown parameter 'laser_max_beans'", output)
        self.assertIn("Parameter 'gains' is a list or a group", output)
        self.assertIn("Parameter 'group' is a list or a group", output)
        self.assertIn("Parameter 'initial_pose_x' is NaN", output)
        self.assertEqual(output.count("WARN"), 4, output)
        self.assertRegex(output, "kld_err: 0.05[\n\x1b]")  # the last option ends the message
        self.assertIn("'laser_max_beans' is ignored; did you mean 'laser_max_beams'?", output)

    def test_options_that_differ_from_the_defaults_are_said_and_others_if_asked(self):
        code, output = self.run_until_it_waits()
        self.assertEqual(code, 0, output)
        self.assertIn("All options have their defaults", output)
        self.assertNotIn("laser_max_beams", output)
        code, output = self.run_until_it_waits("_laser_max_beams:=31")
        self.assertRegex(output, "differ from the defaults:\n  laser_max_beams: 31\x1b")
        code, output = self.run_until_it_waits("--verbose", "_laser_max_beams:=31")
        self.assertEqual(code, 0, output)
        self.assertRegex(output, "Options in effect:(\n  .*)*\n  laser_max_beams: 31")
        self.assertIn("\n  update_min_d: 0.1\n", output)

    def test_help_needs_no_master(self):
        environment = dict(os.environ, ROS_MASTER_URI="http://localhost:1")
        for name, word in [("adaptive_localization", "--run-from-bag BAG"),
                           ("map_publisher", "MAP.yaml"), ("p3dx_simulator", "_world:=")]:
            program = roslib.packages.find_node("adaptive_localization", name)[0]
            for argument in ["--help", "-h"]:
                done = subprocess.run([program, argument], env=environment, timeout=10,
                                      stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                self.assertEqual(done.returncode, 0, name)
                self.assertIn("usage: " + name, done.stdout.decode())
                self.assertIn(word, done.stdout.decode())
                self.assertEqual(done.stderr.decode(), "")

    def test_arguments_that_the_simulator_does_not_know_are_refused(self):
        program = roslib.packages.find_node("adaptive_localization", "p3dx_simulator")[0]
        done = subprocess.run([program, "world.yaml"], timeout=10, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 1)
        self.assertIn("unknown argument 'world.yaml'", done.stderr.decode())

    def test_floor_plan_anywhere_is_fine_until_there_is_a_map(self):
        with tempfile.NamedTemporaryFile(mode="w", suffix=".yaml") as plan:
            plan.write("outline: [[900, -700], [907, -700], [907, -694]]\n")
            plan.flush()
            code, output = self.run_until_it_waits("_line_map:=" + plan.name)
        self.assertEqual(code, 0, output)
        self.assertIn("line_map: " + plan.name, output)

    def test_bad_parameters_are_one_fatal_line(self):
        for key, value, expected in [
                ("laser_max_beams", "1", "'laser_max_beams': got '1', expected a whole number in"),
                ("odom_alpha1", "-0.5", "'odom_alpha1': got '-0.5', expected a number in [0, 100]"),
                ("laser_sigma_hit", ".nan", "'laser_sigma_hit': got 'nan', expected a number in"),
                ("max_particles", "many", "'max_particles': got 'many', expected a whole number"),
                ("filter", "magic", "'filter': got 'magic', expected one of"),
                ("start", "here", "'start': got 'here', expected one of pose, anywhere, wait"),
                ("line_map", "/does/not/exist.yaml",
                 "option 'line_map': floor plan '/does/not/exist.yaml'"),
                ("match_reach", "0.1", "'match_reach': got '0.1', expected at least"),
                ("imu_topic", "3d", "'imu_topic': got '3d', expected the name of a topic: "),
                ("transform_tolerance", "-1", "'transform_tolerance': got '-1'")]:
            process = self.start("_%s:=%s" % (key, value))
            output = process.communicate(timeout=AT_LAST)[0].decode()
            self.assertEqual(process.returncode, 1, output)
            self.assertEqual(output.count("FATAL"), 1, output)
            self.assertIn(expected, output)
            rospy.delete_param("/node")


if __name__ == "__main__":
    rospy.init_node("start_up_test")
    rostest.rosrun("adaptive_localization", "start_up", StartUp, sys.argv)
