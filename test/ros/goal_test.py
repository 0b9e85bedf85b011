#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A robot is driven to goals by the transform from map to base alone, as a navigation stack does it,
and stands there: on the floor, not only on the map."""
import math
import os
import signal
import sys
import xmlrpc.client

import rosgraph
import rospy
import rostest
from geometry_msgs.msg import PoseStamped, Twist
from localization_case import LocalizationCase, wrap
from nav_msgs.msg import Path

GOALS = [(2.6, 0.6, 0.0), (5.5, 2.7, 1.57), (1.5, 2.8, 3.14), (0.8, 0.8, -1.57)]
NEAR, FACING = 0.10, 8.0  # m, degrees: the follower stops within 0.05 m and 3 degrees, as it thinks


class Goal(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.plans, self.commands, self.logs = [], [], []
        self.subscribers += [rospy.Subscriber("plan", Path, self.plans.append),
                             rospy.Subscriber("cmd_vel", Twist, self.commands.append)]
        self.goals = rospy.Publisher("move_base_simple/goal", PoseStamped, queue_size=1)
        self.wait_for(lambda: self.goals.get_num_connections() > 0, "the follower")
        self.wait_for(lambda: self.status() == "tracking", "tracking")

    def send(self, x, y, yaw, frame="map"):
        goal = PoseStamped()
        goal.header.frame_id = frame
        goal.pose.position.x, goal.pose.position.y = x, y
        goal.pose.orientation.z, goal.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        self.goals.publish(goal)

    def stands(self, since):
        """Commanded to stand at last, and standing, after it drove."""
        drove = [c for c in self.commands[since:] if c.linear.x > 0.0]
        last = self.commands[-1] if len(self.commands) > since else None
        if not drove or last.linear.x != 0.0 or last.angular.z != 0.0 or len(self.truths) < 10:
            return False
        now, before = self.truths[-1], self.truths[-6]
        return math.hypot(now[1] - before[1], now[2] - before[2]) < 1e-3

    def test_the_robot_is_driven_to_each_goal(self):
        for x, y, yaw in GOALS:
            with self.subTest(goal=(x, y, yaw)):
                since, plans = len(self.commands), len(self.plans)
                self.send(x, y, yaw)
                self.wait_for(lambda: self.stands(since), "the robot to stand")
                truth = self.truths[-1]
                off = math.hypot(truth[1] - x, truth[2] - y)
                turned = abs(math.degrees(wrap(truth[3] - yaw)))
                print("%.0f mm and %.1f degrees off the goal, on the floor" % (1e3 * off, turned))
                self.assertLess(off, NEAR)
                self.assertLess(turned, FACING)
                self.assertEqual(len(self.plans), plans + 1)
                end = self.plans[-1].poses[-1].pose.position
                self.assertLess(math.hypot(end.x - x, end.y - y), 0.1)

    def test_a_goal_in_another_frame_moves_nothing(self):
        since, plans = len(self.commands), len(self.plans)
        self.send(2.6, 0.6, 0.0, frame="odom")
        self.wait_for_time(2.0)
        self.assertEqual(len(self.plans), plans)
        self.assertFalse([c for c in self.commands[since:] if c.linear.x > 0.0])

    def test_when_the_follower_ends_the_robot_stands(self):
        """Comes last, by its name."""
        since = len(self.commands)
        self.send(5.5, 2.7, 0.0)
        self.wait_for(lambda: [c for c in self.commands[since:] if c.linear.x > 0.1], "the robot to drive")
        follower = xmlrpc.client.ServerProxy(rosgraph.Master("goal_test").lookupNode("/goal_follower"))
        os.kill(follower.getPid("goal_test")[2], signal.SIGINT)
        self.wait_for(lambda: self.stands(since), "the robot to stand")


if __name__ == "__main__":
    rospy.init_node("goal_test")
    rostest.rosrun("adaptive_localization", "goal", Goal, sys.argv)
