#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A node that waits is told where the robot is: wrongly, in the wrong frame, then rightly."""
import sys

import rospy
import rostest
from geometry_msgs.msg import PoseWithCovarianceStamped
from localization_case import LocalizationCase, initial_pose


class InitialPose(LocalizationCase):
    def test_pose_is_taken_from_the_topic(self):
        publisher = rospy.Publisher("initialpose", PoseWithCovarianceStamped, queue_size=10)
        self.wait_for(lambda: publisher.get_num_connections() > 0, "the node")

        self.wait_for(lambda: self.status() == "uninitialised", "status uninitialised")
        self.assertEqual(self.poses, [])
        self.assertFalse(self.tf.can_transform("map", "odom", rospy.Time(0)))

        publisher.publish(initial_pose(0.8, 0.8, 1.57, frame="odom"))
        publisher.publish(initial_pose(float("nan"), 0.8, 1.57))
        publisher.publish(initial_pose(0.8, 0.8, 1.57, variances=(-1, 0, 0)))
        publisher.publish(initial_pose(0.8, 0.8, 1.57, variances=(1e13, 0, 0)))
        publisher.publish(initial_pose(1e300, 0.8, 1.57))
        self.wait_for_answers(2)
        self.assertEqual(self.status(), "uninitialised")

        x, y, yaw = self.truths[-1][1:]
        begin = rospy.get_time()
        publisher.publish(initial_pose(x + 2.5, y + 1.0, yaw + 2.0))
        self.wait_for(lambda: self.errors(begin), "a pose after the wrong one")
        self.assertGreater(self.errors(begin)[0][1], 0.5)

        begin = rospy.get_time()
        stamp, x, y, yaw = self.truths[-20]  # as it was a second ago: it is carried forward
        publisher.publish(initial_pose(x, y, yaw, rospy.Time.from_sec(stamp)))
        self.wait_for(lambda: self.is_accurate(begin) and self.status() == "tracking",
                      "right poses")


if __name__ == "__main__":
    rospy.init_node("initial_pose_test")
    rostest.rosrun("adaptive_localization", "initial_pose", InitialPose, sys.argv)
