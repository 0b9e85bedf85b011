#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A robot with a laser and sixteen sonars. The laser is covered, and then silent: sonars keep the
robot. They are switched on and off while it drives, and tell nonsense:
the node says so, and keeps the robot."""
import copy
import math
import sys

import rospy
import rostest
from localization_case import LocalizationCase, stamp_of
from sensor_msgs.msg import LaserScan, Range


class Sonar(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.is_on = True
        self.spoil = lambda message: message
        self.look = lambda scan: scan
        self.laser = rospy.Publisher("laser", LaserScan, queue_size=50)
        self.pings = rospy.Publisher("pings", Range, queue_size=200)
        self.subscribers += [
            rospy.Subscriber("scan", LaserScan, self.on_scan, queue_size=50),
            rospy.Subscriber("sonar", Range, self.on_ping, queue_size=200)]

    def on_scan(self, message):
        message = self.look(message)
        if message:
            self.laser.publish(message)

    def on_ping(self, message):
        if self.is_on:
            self.pings.publish(self.spoil(message))

    def state(self):
        return self.status_values().get("sonar", "")

    def check_that_it_is_known(self, seconds):
        self.wait_for_answers(1)
        begin = rospy.get_time()
        self.wait_for_answers(seconds)
        errors = self.errors(begin)
        self.assertGreater(len(errors), 3)
        self.assertLess(sum(metres for _, metres, _ in errors) / len(errors), 0.15)
        self.assertLess(max(metres for _, metres, _ in errors), 0.5)

    @staticmethod
    def covered(scan):
        scan = copy.deepcopy(scan)
        scan.ranges = [0.2] * len(scan.ranges)
        return scan

    def test_1_they_are_used_beside_the_laser(self):
        self.tell_where_it_is()
        self.wait_for(lambda: self.status() == "tracking", "tracking")
        self.check_that_it_is_known(5)
        self.assertEqual(self.state(), "used")
        self.assertEqual(self.status_values()["sonar messages dropped"], "0")

    def test_2_they_keep_the_robot_while_the_laser_is_covered(self):
        self.look = self.covered
        begin = rospy.get_time() + 1
        self.check_that_it_is_known(30)
        said = [status.message for status in self.statuses if stamp_of(status) >= begin]
        self.assertGreater(len(said), 200)
        # one update in fifty hears little but wrong echoes, and says "lost"
        self.assertGreater(said.count("tracking") / len(said), 0.9)

    def test_3_they_keep_the_robot_while_the_laser_is_silent(self):
        self.look = lambda scan: None
        self.check_that_it_is_known(15)
        self.look = lambda scan: scan
        self.check_that_it_is_known(5)

    def test_4_a_pause_is_bridged_and_told(self):
        self.is_on = False
        self.wait_for(lambda: self.state().startswith("silent for"), "silent")
        self.check_that_it_is_known(2)
        self.is_on = True
        self.wait_for(lambda: self.state() == "used", "used")

    def test_5_nonsense_is_counted(self):
        def set_frame(message):
            message.header.frame_id = "nowhere"

        def set_nan(message):
            message.range = math.nan

        def set_far(message):
            message.range = 77.0

        def set_wide(message):
            message.field_of_view = -1.0

        def set_late(message):
            message.header.stamp = rospy.Time(1)

        self.spoil_in_turn([set_frame, set_nan, set_far, set_wide, set_late],
                           self.dropped)
        self.check_that_it_is_known(5)

    def dropped(self):
        return int(self.status_values().get("sonar messages dropped", 0))


if __name__ == "__main__":
    rospy.init_node("sonar_test")
    rostest.rosrun("adaptive_localization", "sonar", Sonar, sys.argv)
