#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""In a hall that looks the same after half a turn nobody can know where the robot is: the node says
so, names both places, and shows them and the region of similar energy to whoever looks."""
import math
import sys

import rospy
import rostest
from geometry_msgs.msg import PoseArray
from localization_case import AT_LAST, LocalizationCase, planar, wrap
from visualization_msgs.msg import Marker, MarkerArray

CENTRE = (5.0, 2.5)
DRIVE = 20.0  # s of simulated time


def turned(place):
    return 2 * CENTRE[0] - place[0], 2 * CENTRE[1] - place[1], wrap(place[2] + math.pi)


def is_near(a, b):
    return math.dist(a[:2], b[:2]) < 0.2 and abs(wrap(a[2] - b[2])) < 0.15


class Ambiguity(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.modes = []
        self.subscribers.append(
            rospy.Subscriber("adaptive_localization/modes", PoseArray, self.modes.append))

    def test_both_places_are_named_and_none_is_said_to_be_right(self):
        self.wait_for(lambda: self.status() == "ambiguous", "status ambiguous")
        self.wait_for_answers(2)
        self.statuses.clear()
        self.modes.clear()
        self.wait_for_answers(DRIVE)
        self.assertEqual({status.message for status in self.statuses}, {"ambiguous"})

        known = [m for m in self.modes if self.truth_at(m.header.stamp.to_sec())]
        self.assertGreater(len(known), 50)
        for message in known:
            self.assertEqual(message.header.frame_id, "map")
            places = [planar(pose) for pose in message.poses]
            self.assertEqual(len(places), 2, places)
            truth = self.truth_at(message.header.stamp.to_sec())
            if places[0] and not is_near(places[0], truth):
                places.reverse()
            self.assertTrue(is_near(places[0], truth), (places, truth))
            self.assertTrue(is_near(places[1], turned(truth)), (places, truth))

        values = self.status_values()
        self.assertEqual(values["modes"], "2")
        masses = [float(values["mode %d" % i].split()[1]) for i in [1, 2]]
        self.assertAlmostEqual(sum(masses), 1.0, delta=0.05)
        self.assertGreaterEqual(masses[0], masses[1])
        self.assertGreater(masses[1], 0.3)

    def test_the_region_is_shown_and_where_the_robot_is_lies_in_it(self):
        self.wait_for(lambda: self.truths and self.status(), "the robot")
        for _ in range(5):
            marker = rospy.wait_for_message("adaptive_localization/ser", Marker, AT_LAST)
            self.assertEqual((marker.type, marker.action), (Marker.POINTS, Marker.ADD))
            self.assertEqual(marker.header.frame_id, "map")
            self.assertTrue(0 < len(marker.points) <= 20000, len(marker.points))
            self.assertEqual(len(marker.points), len(marker.colors))
            stamp = marker.header.stamp.to_sec()
            truth = self.wait_for(lambda: self.truth_at(stamp), "the truth")
            for place in [truth, turned(truth)]:
                nearest = min(math.dist(place[:2], (p.x, p.y)) for p in marker.points)
                self.assertLess(nearest, 0.2)

    def test_the_status_is_written_beside_the_places(self):
        self.wait_for(lambda: self.status() == "ambiguous", "status ambiguous")
        topic = "adaptive_localization/status_text"
        markers = rospy.wait_for_message(topic, MarkerArray, AT_LAST).markers
        self.assertEqual(markers[0].action, Marker.DELETEALL)
        self.assertIn("ambiguous", markers[1].text)
        self.assertIn("or here 0.", markers[2].text)


if __name__ == "__main__":
    rospy.init_node("ambiguity_test")
    rostest.rosrun("adaptive_localization", "ambiguity", Ambiguity, sys.argv)
