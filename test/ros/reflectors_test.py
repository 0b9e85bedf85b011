#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reflectors on the walls settle which end of a symmetric hall the robot is in, once its laser tells
how bright they are."""
import sys

import rospy
import rostest
from localization_case import LocalizationCase
from sensor_msgs.msg import LaserScan


class Reflectors(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.is_bright = True
        self.laser = rospy.Publisher("laser", LaserScan, queue_size=50)
        self.subscribers.append(
            rospy.Subscriber("scan", LaserScan, self.on_scan, queue_size=50))

    def on_scan(self, message):
        if not self.is_bright:
            message.intensities = []
        self.laser.publish(message)

    def test_1_a_laser_that_does_not_tell_them_leaves_two_places(self):
        self.is_bright = False
        self.wait_for(lambda: self.status() == "ambiguous", "status ambiguous")
        self.statuses.clear()
        self.wait_for_answers(5)
        self.assertEqual({status.message for status in self.statuses}, {"ambiguous"})
        self.assertEqual(self.status_values()["modes"], "2")

    def test_2_they_settle_the_end_of_the_hall(self):
        self.wait_for(lambda: self.status() == "tracking", "status tracking")
        begin = rospy.get_time()
        self.wait_for_answers(20)
        self.assertEqual({word for _, word in self.words(begin)}, {"tracking"})
        errors = self.errors(begin)
        self.assertGreater(len(errors), 10)
        self.assertLess(max(metres for _, metres, _ in errors), 0.2)
        self.assertLess(max(degrees for _, _, degrees in errors), 5)


if __name__ == "__main__":
    rospy.init_node("reflectors_test")
    rostest.rosrun("adaptive_localization", "reflectors", Reflectors, sys.argv)
