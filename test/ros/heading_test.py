#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A compass settles which end of a symmetric hall the robot is in. It is switched on and off while
the robot drives, is disturbed, and sends nonsense: the node says what it does with it, and keeps
the robot."""
import copy
import math
import sys

import rospy
import rostest
from localization_case import LocalizationCase
from sensor_msgs.msg import Imu
from std_msgs.msg import Float64


class Heading(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.is_on = True
        self.spoil = lambda message: message
        self.compass = rospy.Publisher("compass", Imu, queue_size=200)
        self.disturbance = rospy.Publisher("disturb_compass", Float64, queue_size=1, latch=True)
        self.subscribers.append(rospy.Subscriber("imu", Imu, self.on_imu, queue_size=200))

    def on_imu(self, message):
        if self.is_on:
            self.compass.publish(self.spoil(message))

    def compass_state(self):
        return self.status_values().get("compass", "")

    def wait_for_heading(self, state):
        self.wait_for(lambda: self.compass_state().startswith(state), "compass " + state)

    def wait_for_the_right_end(self):
        self.wait_for(lambda: self.status() == "tracking", "status tracking")
        self.wait_for_answers(1)
        self.assertLess(self.errors()[-1][1], 0.2)

    def check_that_it_stays(self, seconds):
        begin = rospy.get_time()
        self.wait_for_answers(seconds)
        errors = self.errors(begin)
        self.assertGreater(len(errors), 3)
        self.assertLess(max(metres for _, metres, _ in errors), 0.3)
        self.assertLess(max(degrees for _, _, degrees in errors), 10)

    def test_1_it_settles_the_end_of_the_hall(self):
        self.wait_for_the_right_end()
        self.assertEqual(self.compass_state(), "used")
        self.assertEqual(self.status_values()["gyroscope"], "used")
        self.assertGreater(int(self.status_values()["compass messages received"]), 100)
        self.assertEqual(self.status_values()["compass messages dropped"], "0")

    def test_2_a_disturbed_one_is_told_and_not_heard(self):
        self.wait_for_the_right_end()
        self.disturbance.publish(math.pi / 2)
        self.wait_for_heading("disturbed")
        self.check_that_it_stays(20)
        self.disturbance.publish(0)
        self.wait_for_heading("used")

    def test_3_a_silent_one_is_told_and_not_missed(self):
        self.wait_for_the_right_end()
        self.is_on = False
        self.wait_for_heading("silent for")
        self.check_that_it_stays(5)
        self.is_on = True
        self.wait_for_heading("used")

    def test_4_nonsense_is_counted(self):
        self.wait_for_the_right_end()

        def spoil(change):
            def spoilt(message):
                message = copy.deepcopy(message)
                change(message)
                return message
            return spoilt

        def set_frame(message):
            message.header.frame_id = "nowhere"

        def set_nan(message):
            message.orientation.w = math.nan

        def set_certain(message):
            message.orientation_covariance = [0] * 9

        def set_late(message):
            message.header.stamp = rospy.Time(1)

        for change in [set_frame, set_nan, set_certain, set_late]:
            with self.subTest(change=change.__name__):
                before = int(self.status_values()["compass messages dropped"])
                self.spoil = spoil(change)
                self.wait_for(lambda: int(self.status_values()["compass messages dropped"]) >
                              before + 10, "messages to be dropped")
                self.wait_for_heading("silent for")
        self.check_that_it_stays(2)
        self.spoil = lambda message: message
        self.wait_for_heading("used")


if __name__ == "__main__":
    rospy.init_node("heading_test")
    rostest.rosrun("adaptive_localization", "heading", Heading, sys.argv)
