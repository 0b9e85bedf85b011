#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A robot without a laser is localized by landmarks, from a start that it is told: the field looks
the same after half a turn, so that nobody can be sure, and the robot says "ambiguous". What sights them is switched on and off while
it drives, and tells nonsense: the node says so, and keeps the robot."""
import math
import sys

import rospy
import rostest
from localization_case import LocalizationCase
from sensor_msgs.msg import PointCloud


class Landmarks(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.is_on = True
        self.spoil = lambda message: message
        self.camera = rospy.Publisher("camera", PointCloud, queue_size=50)
        self.subscribers.append(
            rospy.Subscriber("landmarks", PointCloud, self.on_landmarks, queue_size=50))

    def on_landmarks(self, message):
        if self.is_on:
            self.camera.publish(self.spoil(message))

    def state(self):
        return self.status_values().get("landmarks", "")

    def wait_for_state(self, state):
        self.wait_for(lambda: self.state().startswith(state), "landmarks " + state)

    def check_that_it_is_known(self, seconds):
        self.wait_for(lambda: self.status() in ["tracking", "ambiguous"], "a status")
        self.wait_for_answers(1)
        begin = rospy.get_time()
        self.wait_for_answers(seconds)
        errors = self.errors(begin)
        self.assertGreater(len(errors), 3)
        self.assertLess(sum(metres for _, metres, _ in errors) / len(errors), 0.15)
        self.assertLess(max(metres for _, metres, _ in errors), 0.6)

    def test_1_they_localize_the_robot(self):
        self.tell_where_it_is()
        self.check_that_it_is_known(20)
        self.assertEqual(self.state(), "used")
        self.assertEqual(self.status_values()["landmarks messages dropped"], "0")

    def test_2_a_pause_is_bridged(self):
        self.check_that_it_is_known(2)
        self.is_on = False
        self.wait_for_time(4)
        self.is_on = True
        self.check_that_it_is_known(10)

    def test_3_nonsense_is_counted(self):
        self.check_that_it_is_known(2)

        def set_frame(message):
            message.header.frame_id = "nowhere"

        def set_nan(message):
            for point in message.points:
                point.x = math.nan

        def set_certain(message):
            message.channels[1].values = [0.0] * len(message.points)

        def set_unknown(message):
            message.channels[0].values = [77.0] * len(message.points)

        def drop_channel(message):
            message.channels = message.channels[:2]

        def set_late(message):
            message.header.stamp = rospy.Time(1)

        self.spoil_in_turn([set_frame, set_nan, set_certain, set_unknown, drop_channel, set_late],
                           self.dropped)
        self.check_that_it_is_known(5)

    def dropped(self):
        return int(self.status_values().get("landmarks messages dropped", 0))


if __name__ == "__main__":
    rospy.init_node("landmarks_test")
    rostest.rosrun("adaptive_localization", "landmarks", Landmarks, sys.argv)
