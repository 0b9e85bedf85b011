#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Two lasers on topics of their own, one of them on a mount that turns, with scans of changing
shape, by drivers that stamp a quarter of a second late; transforms at a fixed rate."""
import math
import sys
import time

import rospy
import rostest
from localization_case import initial_pose
from sensor_msgs.msg import LaserScan
from toy_robot import ToyRobotCase, compose, room, transform

LATE = rospy.Duration(0.25)


class Lasers(ToyRobotCase):
    def setUp(self):
        self.lasers = {}
        super().setUp()

    def publisher(self, topic, kind):
        if kind is LaserScan:
            self.lasers = {name: ToyRobotCase.publisher(self, name, kind)
                           for name in ["front", "rear"]}
            return None
        return super().publisher(topic, kind)

    def drive(self, count, topics, motion=(0.05, 0.0, 0.12)):
        """Odometry is sent up to the late stamps, as by a driver that goes on."""
        for k in range(count):
            self.time += rospy.Duration(0.1)
            self.pose = compose(self.pose, motion)
            self.odometry = compose(self.odometry, motion)
            turned = (-0.1, 0.0, math.pi + 0.8 * math.sin(0.5 * k))
            self.send_odometry()
            self.broadcaster.sendTransform(transform("base_link", "rear", turned, self.time))
            for topic in topics:
                mount = turned if topic == "rear" else self.MOUNT
                frame = "/rear" if topic == "rear" else "laser"
                scan = self.scan_message(mount, frame, 181 - k % 2)
                scan.header.stamp += LATE
                self.lasers[topic].publish(scan)
            rospy.sleep(0.03)
        rospy.sleep(0.1)

    def test_each_laser_alone_and_both_keep_the_robot(self):
        self.maps.publish(room())
        self.wait_for_log("Map of")
        self.initial_poses.publish(initial_pose(*self.pose))
        self.wait_for_log("Initial pose")
        for topics in [["front"], ["rear"], ["front", "rear"]]:
            self.forget()
            self.drive(40, topics)
            # What is published bears the time of the measurement, not of the driver.
            self.wait_for(lambda: self.poses and abs(self.poses[-1][0] - self.time.to_sec()) < 1e-5,
                          "a pose at the time of the last scan")
            self.assertEqual(self.status(), "tracking", topics)
            self.assertLess(self.error(), 0.1, topics)
            self.assertGreater(len(self.poses), 30)

        # The transform comes at its rate, scans or not, and never with a stamp twice.
        self.forget()
        begin = time.monotonic()
        time.sleep(2.0)
        stamps = [t.header.stamp for t in self.corrections]
        rate = len(stamps) / (time.monotonic() - begin)
        self.assertTrue(15 <= rate <= 25, rate)
        self.assertEqual(stamps, sorted(set(stamps)))


if __name__ == "__main__":
    rospy.init_node("lasers_test")
    rostest.rosrun("adaptive_localization", "lasers", Lasers, sys.argv)
