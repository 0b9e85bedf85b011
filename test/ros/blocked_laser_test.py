#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Somebody stands in front of the laser while the robot drives on: the node does not claim to know
where the robot is and keeps to the odometry, without a jump; when the view is free again, all is
well."""
import math
import sys

import rospy
import rostest
from geometry_msgs.msg import Pose
from localization_case import planar
from toy_robot import ToyRobotCase, compose

TOLERANCE = 0.1  # s, by which transforms are post-dated


class BlockedLaser(ToyRobotCase):
    def setUp(self):
        super().setUp()
        self.blocked_at = None  # m
        self.driven = {}  # odometry by stamp

    def move(self, *arguments, **named):
        super().move(*arguments, **named)
        self.driven[round(self.time.to_sec(), 3)] = self.odometry

    def scan_message(self, *arguments, **named):
        message = super().scan_message(*arguments, **named)
        if self.blocked_at is not None:
            message.ranges = [self.blocked_at + 0.02 * math.sin(7 * i)
                              for i in range(len(message.ranges))]
        return message

    def test_no_jump_while_the_laser_is_blocked(self):
        self.localize()
        self.steps(20, (0.02, 0.0, 0.05))
        self.assertEqual(self.status(), "tracking")

        for blocked_at in [0.3, 0.1, 1.0]:  # m
            with self.subTest(blocked_at=blocked_at):
                before = planar_of(self.corrections[-1])
                self.forget()
                self.blocked_at = blocked_at
                self.steps(5, (0.04, 0.0, 0.15))
                self.statuses.clear()
                self.steps(15, (0.04, 0.0, 0.15))
                self.steps(15, (-0.04, 0.0, -0.15))
                # an arc near the laser is what corners look like
                words = {status.message for status in self.statuses}
                self.assertTrue(words <= {"lost", "ambiguous"}, (words, self.status_values()))
                last = before
                for correction in self.corrections:
                    now = planar_of(correction)
                    odometry = self.driven[round(correction.header.stamp.to_sec() - TOLERANCE, 3)]
                    self.assertLess(moved(last, now, odometry), 0.1, self.status_values())
                    self.assertLess(moved(before, now, odometry), 0.3, self.status_values())
                    last = now
                self.assertGreater(len(self.corrections), 20)

                self.blocked_at = None
                self.forget()
                for _ in range(50):
                    self.step((0.02, 0.0, 0.1))
                    if self.status() == "tracking":
                        break
                self.steps(6, (0.02, 0.0, 0.0))  # 0.12 m, so there is an update by then
                self.assertEqual(self.status(), "tracking", self.status_values())
                self.assertLess(self.error(), 0.05)


def moved(old, new, odometry):
    """How far another correction moves the robot, m: turned about it, the origin moves farther."""
    return math.dist(compose(old, odometry)[:2], compose(new, odometry)[:2])


def planar_of(transform):
    pose = Pose()
    pose.position = transform.transform.translation
    pose.orientation = transform.transform.rotation
    return planar(pose)


if __name__ == "__main__":
    rospy.init_node("blocked_laser_test")
    rostest.rosrun("adaptive_localization", "blocked_laser", BlockedLaser, sys.argv)
