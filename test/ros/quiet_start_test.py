#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A node that is started together with everything else warns of nothing: not of a map server or a
laser's transform that come seconds later, nor of a pose that it was told to wait for. It takes the
map that it is given first."""
import os
import subprocess
import sys
import time
import unittest

import roslib.packages
import rospy
import rostest
import tf2_ros
from localization_case import AT_LAST, initial_pose
from nav_msgs.srv import GetMap, SetMap
from sensor_msgs.msg import LaserScan
from toy_robot import ToyRobotCase, room, transform

PROGRAM = roslib.packages.find_node("adaptive_localization", "adaptive_localization")[0]


class QuietStart(unittest.TestCase):
    frame = "laser"

    def setUp(self):
        if rospy.has_param("/node"):
            rospy.delete_param("/node")
        self.robot = ToyRobotCase()
        self.robot.pose = (1.5, 1.0, 0.3)
        self.scans = rospy.Publisher("scan", LaserScan, queue_size=10)
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.static_broadcaster = tf2_ros.StaticTransformBroadcaster()

    def start(self, *arguments):
        environment = dict(os.environ, ROSCONSOLE_STDOUT_LINE_BUFFERED="1")
        return subprocess.Popen([PROGRAM, "__name:=node"] + list(arguments), env=environment,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def send(self, _):
        """Odometry up to now; the laser's driver is slower."""
        now = rospy.Time.now()
        self.broadcaster.sendTransform(transform("odom", "base_link", (0, 0, 0), now))
        self.robot.time = now - rospy.Duration(0.2)
        self.scans.publish(self.robot.scan_message(frame=self.frame))

    def test_what_comes_seconds_later_is_waited_for(self):
        self.frame = "late_laser"
        timer = rospy.Timer(rospy.Duration(0.1), self.send)
        process = self.start("_initial_pose_x:=1.5", "_initial_pose_y:=1.0", "_initial_pose_a:=0.3")
        time.sleep(2.5)
        mount = transform("base_link", self.frame, ToyRobotCase.MOUNT, rospy.Time.now())
        self.static_broadcaster.sendTransform(mount)
        time.sleep(1.0)
        server = rospy.Service("static_map", GetMap, lambda _: room())
        time.sleep(3.0)
        timer.shutdown()
        server.shutdown()
        process.terminate()
        output = process.communicate(timeout=20)[0].decode()
        self.assertIn("Energy grid ready", output)  # which is made for the first scan that is used
        self.assertNotIn("WARN", output)

    def test_pose_that_it_was_told_to_wait_for_is_no_fault(self):
        timer = rospy.Timer(rospy.Duration(0.1), self.send)
        server = rospy.Service("static_map", GetMap, lambda _: room())
        mount = transform("base_link", "laser", ToyRobotCase.MOUNT, rospy.Time.now())
        self.static_broadcaster.sendTransform(mount)
        process = self.start("_start:=wait")
        time.sleep(8.0)
        timer.shutdown()
        server.shutdown()
        process.terminate()
        output = process.communicate(timeout=20)[0].decode()
        self.assertIn("waiting for an initial pose", output)
        self.assertNotIn("WARN", output)

    def test_map_that_was_set_is_kept(self):
        """Nobody is asked for another one: a master that does not answer would hold up the scans."""
        process = self.start("_start:=wait")
        rospy.wait_for_service("set_map", AT_LAST)
        self.assertTrue(rospy.ServiceProxy("set_map", SetMap)(room(), initial_pose(1, 1, 0)).success)
        asked = []
        server = rospy.Service("static_map", GetMap, lambda request: asked.append(request) or room())
        time.sleep(3.0)
        server.shutdown()
        process.terminate()
        process.communicate(timeout=20)
        self.assertEqual(asked, [])

    def test_what_stays_away_is_warned_of(self):
        timer = rospy.Timer(rospy.Duration(0.1), self.send)
        self.frame = "attic"
        process = self.start()
        time.sleep(8.0)
        timer.shutdown()
        process.terminate()
        output = process.communicate(timeout=20)[0].decode()
        self.assertRegex(output, "WARN.*Scan dropped .* where frame 'attic' is")
        self.assertRegex(output, "WARN.*Not localizing for 5 s: .*; a map on service /static_map")


if __name__ == "__main__":
    rospy.init_node("quiet_start_test")
    rostest.rosrun("adaptive_localization", "quiet_start", QuietStart, sys.argv)
