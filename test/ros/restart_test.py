#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A node that ends, in whatever way, and is started again goes on where the robot was."""
import math
import os
import signal
import sys
import time
import unittest

import dynamic_reconfigure.client
import rospkg
import rospy
import rostest
from amcl_protocol import PACKAGE, Programs
from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import PoseWithCovarianceStamped, Twist
from localization_case import AT_LAST, planar, stamp_of, wrap
from nav_msgs.msg import Odometry

MAZE = os.path.join(rospkg.RosPack().get_path(PACKAGE), "maps", "maze")
START = dict(initial_pose_x=0.8, initial_pose_y=0.8, initial_pose_a=1.57)
ROUTE_SPEED = 0.4  # m/s
ACCURACY = (0.15, 0.1)  # m, rad; of a pose


class Restart(unittest.TestCase):
    def setUp(self):
        rospy.set_param("/use_sim_time", True)  # of the nodes; this one needs no clock
        if rospy.has_param("/adaptive_localization"):
            rospy.delete_param("/adaptive_localization")
        self.poses, self.truth, self.speed, self.travelled = [], None, 0.0, 0.0
        self.is_held = False
        self.now = self.answered = 0.0  # s, stamps of the truth and of the last scan answered
        self.command = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        subscribers = [rospy.Subscriber("amcl_pose", PoseWithCovarianceStamped, self.on_pose),
                       rospy.Subscriber("base_pose_ground_truth", Odometry, self.on_truth),
                       rospy.Subscriber("adaptive_localization/status", DiagnosticStatus,
                                        self.on_status)]
        for subscriber in subscribers:
            self.addCleanup(subscriber.unregister)
        self.programs = Programs()
        self.addCleanup(self.programs.end)
        self.programs.start("map_publisher", os.path.join(MAZE, "map.yaml"))
        self.programs.start("p3dx_simulator", world=os.path.join(MAZE, "world.yaml"), drive="true",
                            start="0.8,0.8,1.57", speed=6, route_speed=ROUTE_SPEED, seed=3)

    def on_pose(self, message):
        self.poses.append(planar(message.pose.pose))

    def on_status(self, message):
        self.answered = stamp_of(message)

    def on_truth(self, message):
        self.now = message.header.stamp.to_sec()
        now = planar(message.pose.pose)
        if self.truth:
            self.travelled += math.dist(now[:2], self.truth[:2])
        self.truth = now
        self.speed = math.hypot(message.twist.twist.linear.x, message.twist.twist.angular.z)
        if self.is_held:
            self.command.publish(Twist())

    def wait(self, condition, what):
        end = time.time() + AT_LAST
        while not condition():
            self.assertLess(time.time(), end, "waited for " + what)
            time.sleep(0.01)

    def start(self, **parameters):
        self.poses.clear()
        process = self.programs.start("adaptive_localization", **parameters)
        self.wait(lambda: self.poses, "a pose")
        return process

    def travel(self, metres):
        begin = self.travelled
        self.wait(lambda: self.travelled > begin + metres, "the robot to drive")

    def hold(self):
        self.is_held = True
        self.wait(lambda: self.speed == 0.0, "the robot to stop")

    def settle(self):
        """Holds the robot until the node has seen that it stands."""
        self.hold()
        stopped = self.now
        self.wait(lambda: self.answered > stopped, "the answer to a scan of the robot at rest")

    def kept(self):
        return [rospy.get_param("/adaptive_localization/initial_pose_" + axis) for axis in "xya"]

    def assert_near(self, pose, metres=ACCURACY[0], radians=math.pi):
        self.assertLess(math.dist(pose[:2], self.truth[:2]), metres)
        self.assertLess(abs(wrap(pose[2] - self.truth[2])), radians)

    def test_asked_to_end_it_keeps_the_last_pose(self):
        for ending in [signal.SIGINT, signal.SIGTERM]:
            print(ending)
            parameters = START if ending == signal.SIGINT else {}
            process = self.start(save_pose_rate=0.001, **parameters)
            self.is_held = False
            self.travel(3.0)
            self.settle()
            process.send_signal(ending)
            self.assertEqual(process.wait(AT_LAST), 0)
            self.assert_near(self.kept(), *ACCURACY)
        self.start()
        self.assert_near(self.poses[0], *ACCURACY)
        self.is_held = False
        self.travel(2.0)
        self.settle()
        self.assert_near(self.poses[-1], 0.25)

    def test_told_to_keep_no_pose_any_more_it_keeps_no_old_one_as_it_ends(self):
        process = self.start(save_pose_rate=0.001, **START)
        self.travel(1.0)
        client = dynamic_reconfigure.client.Client("adaptive_localization", timeout=AT_LAST)
        self.addCleanup(client.close)
        client.update_configuration({"save_pose_rate": 0.0})
        self.travel(2.0)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(AT_LAST), 0)
        self.assertEqual(self.kept(), list(START.values()))

    def test_killed_it_goes_on_from_the_pose_kept_last(self):
        rate = 0.5
        process = self.start(save_pose_rate=rate, **START)
        self.travel(3.0)
        allowed = ACCURACY[0] + ROUTE_SPEED / rate
        self.wait(lambda: math.dist(self.kept()[:2], self.truth[:2]) < allowed, "a recent pose")
        process.kill()
        process.wait(AT_LAST)
        kept = self.kept()
        self.hold()
        self.start()
        self.assertLess(math.dist(self.poses[0][:2], kept[:2]), ACCURACY[0])


if __name__ == "__main__":
    rospy.init_node("restart_test")
    rostest.rosrun(PACKAGE, "restart", Restart, sys.argv)
