#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Two lasers on topics of their own, one of them on a mount that turns, with scans of changing
shape, by drivers that stamp a quarter of a second late; transforms at a fixed rate."""
import math
import sys
import time

import rospy
import rostest
from localization_case import initial_pose, stamp_of
from sensor_msgs.msg import LaserScan
from toy_robot import ToyRobotCase, room, transform

LATE = rospy.Duration(0.25)
RATE = 20  # Hz


class Lasers(ToyRobotCase):
    def setUp(self):
        self.lasers = {}
        self.topics = []  # of the lasers in use
        self.sent = 0
        super().setUp()

    def publisher(self, topic, kind):
        if kind is LaserScan:
            self.lasers = {name: ToyRobotCase.publisher(self, name, kind)
                           for name in ["front", "rear"]}
            return None
        return super().publisher(topic, kind)

    def send(self):
        self.sent += 1
        turned = (-0.1, 0.0, math.pi + 0.8 * math.sin(0.5 * self.sent))
        self.send_odometry()
        self.broadcaster.sendTransform(transform("base_link", "rear", turned, self.time))
        for topic in self.topics:
            mount = turned if topic == "rear" else self.MOUNT
            frame = "/rear" if topic == "rear" else "laser"
            scan = self.scan_message(mount, frame, 181 - self.sent % 2)
            scan.header.stamp += LATE
            self.lasers[topic].publish(scan)
        return time.time()

    def has_answered(self, received, is_new):
        """What is published bears the time of the measurement, not of the driver."""
        stamps = [stamp_of(status) for status in self.statuses[received[0]:]]
        poses = [pose[0] for pose in self.poses[received[2]:]]
        is_now = lambda stamp: abs(stamp - self.time.to_sec()) < 1e-5
        return sum(map(is_now, stamps)) == len(self.topics) and any(map(is_now, poses))

    def test_each_laser_alone_and_both_keep_the_robot(self):
        self.maps.publish(room())
        self.wait_for_log("Map of")
        self.initial_poses.publish(initial_pose(*self.pose))
        self.wait_for_log("Initial pose")
        for topics in [["front"], ["rear"], ["front", "rear"]]:
            self.forget()
            self.topics = topics
            self.steps(40, (0.05, 0.0, 0.12))
            self.assertEqual(self.status(), "tracking", topics)
            self.assertLess(self.error(), 0.1, topics)
            self.assertGreater(len(self.poses), 30)

        # The transform comes at its rate, scans or not, and never with a stamp twice.
        self.forget()
        self.wait_for(lambda: len(self.corrections) > 40, "transforms without a scan")
        stamps = [t.header.stamp.to_sec() for t in self.corrections]
        self.assertEqual(stamps, sorted(set(stamps)))
        self.assertGreater(stamps[-1] - stamps[0], 0.8 * (len(stamps) - 1) / RATE)  # or late


if __name__ == "__main__":
    rospy.init_node("lasers_test")
    rostest.rosrun("adaptive_localization", "lasers", Lasers, sys.argv)
