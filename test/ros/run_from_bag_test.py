#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""amcl's bag mode: topics with and without a leading slash, the mount in /tf_static; a start
that is not known; landmarks alone; wrong arguments."""
import math
import os
import random
import re
import subprocess
import sys
import tempfile
import types
import unittest

import roslib.packages
import rosbag
import rospy
import rostest
from localization_case import AT_LAST
from geometry_msgs.msg import Point32
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import ChannelFloat32, PointCloud
from tf2_msgs.msg import TFMessage
from toy_robot import ToyRobotCase, compose, room, transform

PROGRAM = roslib.packages.find_node("adaptive_localization", "adaptive_localization")[0]
START = (1.5, 1.0, 0.3)
POSTS = [(0.5, 0.5), (3.5, 0.5), (3.5, 2.5), (0.5, 2.5)]


def sightings(pose, stamp):
    """All posts, from base, by who knows them."""
    message = PointCloud()
    message.header.frame_id, message.header.stamp = "base_link", stamp
    for x, y in POSTS:
        dx, dy = x - pose[0], y - pose[1]
        c, s = math.cos(pose[2]), math.sin(pose[2])
        message.points.append(Point32(c * dx + s * dy, c * dy - s * dx, 0.0))
    for name, values in [("id", range(len(POSTS))), ("range_std", [0.03] * len(POSTS)),
                         ("bearing_std", [0.02] * len(POSTS))]:
        message.channels.append(ChannelFloat32(name, [float(value) for value in values]))
    return message


class RunFromBag(unittest.TestCase):
    def run_node(self, *arguments):
        environment = dict(os.environ, ROSCONSOLE_STDOUT_LINE_BUFFERED="1")
        result = subprocess.run(
            [PROGRAM] + list(arguments), env=environment, timeout=AT_LAST,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        return result.returncode, result.stdout.decode()

    def write_bag(self, path, prefix, scan_topic):
        """The robot drives a curve; the last pose is returned."""
        robot = types.SimpleNamespace(pose=START, time=rospy.Time(1000), MOUNT=ToyRobotCase.MOUNT,
                                      view=ToyRobotCase.view)
        odometry, motion = (0.0, 0.0, 0.0), (0.05, 0.0, 0.04)
        with rosbag.Bag(path, "w") as bag:
            fixed = transform("base_link", "laser", robot.MOUNT, robot.time)
            stray = transform("base_link", "arm", robot.MOUNT, rospy.Time(2**32 - 1))  # ignored
            bag.write(prefix + "tf", TFMessage([stray]), robot.time)
            for _ in range(60):
                moving = transform("odom", "base_link", odometry, robot.time)
                bag.write(prefix + "tf", TFMessage([moving]), robot.time)
                bag.write(prefix + scan_topic, ToyRobotCase.scan_message(robot), robot.time)
                bag.write(prefix + "posts", sightings(robot.pose, robot.time), robot.time)
                last = robot.pose
                robot.time += rospy.Duration(0.1)
                robot.pose = compose(robot.pose, motion)
                odometry = compose(odometry, motion)
            bag.write(prefix + "tf_static", TFMessage([fixed]), robot.time)
        return last

    def check_final_location(self, prefix, scan_topic, *arguments, initial=START):
        maps = rospy.Publisher("map", OccupancyGrid, queue_size=1, latch=True)
        maps.publish(room())
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "drive.bag")
            truth = self.write_bag(path, prefix, scan_topic)
            code, output = self.run_node(
                "--run-from-bag", path, *arguments, "_use_map_topic:=true",
                "_save_pose_rate:=-1", *("_initial_pose_%s:=%s" % p for p in zip("xya", initial)))
        self.assertEqual(code, 0, output)
        self.assertRegex(output, r"Bag complete, took [0-9.]+ seconds to process")
        found = re.search(r"Final location (\S+), (\S+), (\S+) with stamp=1005\.9", output)
        self.assertIsNotNone(found, output)
        for value, expected in zip(found.groups(), truth):
            self.assertLess(abs(float(value) - expected), 0.1, output)

    def test_bag_with_slashes(self):
        self.check_final_location("/", "scan")

    def test_bag_as_amcl_wants_it(self):
        self.check_final_location("", "base_scan")

    def test_bag_from_anywhere(self):
        self.check_final_location("/", "scan", "--global-localization", initial=(7.0, 2.0, 3.0))

    def test_bag_with_landmarks_alone(self):
        maps = rospy.Publisher("map", OccupancyGrid, queue_size=1, latch=True)
        maps.publish(room())
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "drive.bag")
            truth = self.write_bag(path, "/", "unheard")
            posts = os.path.join(folder, "posts.yaml")
            with open(posts, "w") as known:
                known.write("landmarks:\n")
                for i, (x, y) in enumerate(POSTS):
                    known.write("  - {id: %d, at: [%g, %g]}\n" % (i, x, y))
            beside = (START[0] + 0.3, START[1] - 0.2, START[2] + 0.1)
            for name in ["scan_topics", "landmark_topic", "landmark_map"]:  # stay with the master
                self.addCleanup(rospy.delete_param, "/adaptive_localization/" + name)
            code, output = self.run_node(
                "--run-from-bag", path, "_use_map_topic:=true", "_save_pose_rate:=-1",
                "_scan_topics:=", "_landmark_topic:=posts", "_landmark_map:=" + posts,
                *("_initial_pose_%s:=%s" % p for p in zip("xya", beside)))
        self.assertEqual(code, 0, output)
        found = re.search(r"Final location (\S+), (\S+), (\S+) with", output)
        self.assertIsNotNone(found, output)
        for value, expected in zip(found.groups(), truth):
            self.assertLess(abs(float(value) - expected), 0.1, output)

    def test_bag_without_a_pose_says_what_it_lacks(self):
        maps = rospy.Publisher("map", OccupancyGrid, queue_size=1, latch=True)
        maps.publish(room())
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "drive.bag")
            self.write_bag(path, "/", "laser/scan")
            code, output = self.run_node("--run-from-bag", path, "_use_map_topic:=true")
            self.assertIn("No pose was found in the bag, whose scans are on /laser/scan; "
                          "waited for a scan on /scan", output)
            self.write_bag(path, "/robot/", "scan")
            code, output = self.run_node("--run-from-bag", path, "_use_map_topic:=true",
                                         "scan:=robot/scan")
            self.assertIn("waited for a transform from 'laser' to 'base_link'", output)
        self.assertEqual(code, 0, output)

    def test_missing_bag_is_one_fatal_line(self):
        code, output = self.run_node("--run-from-bag", "/no/such.bag")
        self.assertEqual(code, 1)
        self.assertEqual(output.count("FATAL"), 1, output)
        self.assertIn("/no/such.bag", output)

    def test_damaged_bag_ends_with_a_message(self):
        maps = rospy.Publisher("map", OccupancyGrid, queue_size=1, latch=True)
        maps.publish(room())
        numbers = random.Random(1)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "damaged.bag")
            self.write_bag(path, "/", "scan")
            with open(path, "rb") as bag:
                whole = bag.read()
            for _ in range(10):
                damaged = bytearray(whole)
                for _ in range(4):
                    at = numbers.randrange(len(damaged) - 4)
                    damaged[at:at + 4] = numbers.choice([b"\0\0\0\0", b"\xff\xff\xff\x7f"])
                with open(path, "wb") as bag:
                    bag.write(damaged)
                code, output = self.run_node("--run-from-bag", path, "_use_map_topic:=true",
                                             "_save_pose_rate:=-1")
                self.assertIn(code, (0, 1), output)
                self.assertTrue(code == 0 or path in output, output)

    def test_other_arguments_show_the_usage(self):
        for arguments in [["foo"], ["--run-from-bag"], ["--run-from-bag", "a", "--global"]]:
            code, output = self.run_node(*arguments)
            self.assertEqual(code, 1)
            self.assertIn("got '%s' with %d more, expected" % (arguments[0], len(arguments) - 1), output)
            self.assertIn("usage: adaptive_localization", output)


if __name__ == "__main__":
    rospy.init_node("run_from_bag_test")
    rostest.rosrun("adaptive_localization", "run_from_bag", RunFromBag, sys.argv)
