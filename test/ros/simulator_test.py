#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The simulated Pioneer as its drivers would show it, and what carries it away."""
import math
import os
import subprocess
import sys
import time

import roslib.packages
import rospkg
import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import PoseStamped, TransformStamped, Twist
from localization_case import AT_LAST, LocalizationCase, planar, wrap
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from std_srvs.srv import Empty

PROGRAM = roslib.packages.find_node("adaptive_localization", "p3dx_simulator")[0]
START = (0.8, 0.8)


class Simulator(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.scans = []
        self.odometry = []
        self.markers = []
        self.subscribers += [
            rospy.Subscriber("scan", LaserScan, self.scans.append),
            rospy.Subscriber("odom", Odometry, self.odometry.append),
            rospy.Subscriber("p3dx_simulator/truth_markers", rospy.AnyMsg, self.markers.append),
        ]
        self.kidnap = rospy.Publisher("kidnap", PoseStamped, queue_size=1)
        self.command = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        rospy.wait_for_service("reset_positions", AT_LAST)
        rospy.ServiceProxy("reset_positions", Empty)()
        self.wait_for(lambda: self.truths and self.odometry and self.place_is(*START), "the start")

    def place_is(self, x, y):
        return math.hypot(self.truths[-1][1] - x, self.truths[-1][2] - y) < 0.02

    def carry_to(self, x, y, frame="map"):
        self.wait_for(lambda: self.kidnap.get_num_connections() > 0, "the simulator to listen")
        message = PoseStamped()
        message.header.frame_id = frame
        message.pose.position.x, message.pose.position.y = x, y
        message.pose.orientation.w = 1.0
        self.kidnap.publish(message)

    def test_scans_and_odometry_are_those_of_the_drivers(self):
        self.wait_for(lambda: len(self.scans) > 20, "scans")
        scan = self.scans[-1]
        self.assertEqual(scan.header.frame_id, "laser")
        self.assertEqual(len(scan.ranges), 181)
        self.assertAlmostEqual(scan.angle_max, math.pi / 2, 5)
        stamps = [s.header.stamp.to_sec() for s in self.scans[-10:]]
        for a, b in zip(stamps, stamps[1:]):
            self.assertAlmostEqual(b - a, 0.1, 6)
        self.assertEqual(self.odometry[-1].header.frame_id, "odom")
        self.assertEqual(self.odometry[-1].child_frame_id, "base_link")

    def test_tf_places_every_scan(self):
        self.wait_for(lambda: len(self.scans) > 5, "scans")
        stamp = self.scans[-1].header.stamp
        self.wait_for(lambda: self.tf.can_transform("odom", "laser", stamp), "tf")
        mount = self.tf.lookup_transform("base_link", "laser", stamp).transform.translation
        self.assertAlmostEqual(mount.x, 0.021)
        self.assertAlmostEqual(mount.z, 0.30)

    def test_drives_as_told_and_stops_when_nobody_tells(self):
        command = Twist()
        command.linear.x, command.angular.z = 0.2, 0.3
        before = planar(self.odometry[-1].pose.pose)

        def has_driven():
            self.command.publish(command)
            now = planar(self.odometry[-1].pose.pose)
            return math.dist(now[:2], before[:2]) > 0.3 and wrap(now[2] - before[2]) > 0.4

        self.wait_for(has_driven, "the robot to drive a curve", pause=0.03)
        self.wait_for(lambda: self.odometry[-1].twist.twist.linear.x == 0.0, "the robot to stop")

    def test_carrying_it_moves_the_truth_and_not_the_odometry(self):
        before = planar(self.odometry[-1].pose.pose)
        self.carry_to(2.0, 2.7)
        self.wait_for(lambda: self.place_is(2.0, 2.7), "the robot to be carried")
        self.wait_for_time(0.5)
        self.assertEqual(planar(self.odometry[-1].pose.pose), before)
        rospy.ServiceProxy("kidnap_random", Empty)()
        self.wait_for(lambda: not self.place_is(2.0, 2.7), "the robot to be carried")

    def test_time_waits_for_whoever_localizes_the_robot(self):
        broadcaster = tf2_ros.TransformBroadcaster()
        self.wait_for(lambda: broadcaster.pub_tf.get_num_connections() >= 2, "the simulator")
        correction = TransformStamped()
        correction.header.frame_id, correction.child_frame_id = "map", "odom"
        correction.transform.rotation.w = 1.0
        correction.header.stamp = rospy.Time.now() + rospy.Duration(2)
        held_at = correction.header.stamp.to_sec() + 0.5
        broadcaster.sendTransform(correction)
        self.wait_for(lambda: rospy.get_time() > held_at, "time to stop")
        for _ in range(20):
            broadcaster.sendTransform(correction)
            time.sleep(0.1)
            self.assertLess(rospy.get_time(), held_at + 0.05)
        correction.header.stamp += rospy.Duration(1e6)
        broadcaster.sendTransform(correction)
        self.wait_for(lambda: rospy.get_time() > held_at + 1.0, "time to go on")

    def test_a_pose_in_another_frame_is_refused(self):
        self.carry_to(2.0, 2.7, "odom")
        self.wait_for_time(1.0)
        self.assertTrue(self.place_is(*START))

    def test_markers_show_robot_and_people(self):
        self.wait_for(lambda: self.markers, "markers")
        self.assertEqual(self.markers[-1]._connection_header["type"],
                         "visualization_msgs/MarkerArray")
        self.assertEqual(self.markers[-1]._buff[:4], b"\x04\0\0\0")  # robot, arrow, two people

    def test_bad_parameters_are_one_fatal_line(self):
        world = os.path.join(rospkg.RosPack().get_path("adaptive_localization"),
                             "maps/maze/world.yaml")
        for arguments, expected in [
                ([], "'world'"),
                (["_world:=/no/such/file.yaml"], "/no/such/file.yaml"),
                (["_world:=" + world, "_start:=1,2"], "'start': got '1,2', expected x,y,yaw"),
                (["_world:=" + world, "_profile:=perfect"], "'profile': got 'perfect'"),
                (["_world:=" + world, "_scan_rate:=-1"], "'scan_rate': got '-1', expected"),
                (["_world:=" + world, "_speed:=2", "_publish_clock:=false"], "'speed'"),
                (["_world:=" + world, "_lock_step:=true", "_publish_clock:=false"],
                 "'lock_step'")]:
            process = subprocess.Popen([PROGRAM, "__name:=bad"] + arguments,
                                       stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            output = process.communicate(timeout=AT_LAST)[0].decode()
            self.assertEqual(process.returncode, 1, output)
            self.assertEqual(output.count("FATAL"), 1, output)
            self.assertIn(expected, output)
            if rospy.has_param("/bad"):
                rospy.delete_param("/bad")


if __name__ == "__main__":
    rospy.init_node("simulator_test")
    rostest.rosrun("adaptive_localization", "simulator", Simulator, sys.argv)
