#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The robot is carried away while it drives, and nobody tells the node: it notices, says so, and
finds the robot within seconds; likewise when it is asked to look anywhere."""
import sys

import rospy
import rostest
from geometry_msgs.msg import PoseStamped
from localization_case import LocalizationCase
from std_srvs.srv import Empty

# The first looks like none of the way before, from wherever on it the robot is taken.
PLACES = [(2.6, 0.5, 1.0), (6.4, 1.4, -1.57), (1.5, 2.8, 3.0), (5.5, 2.7, 0.0)]
PATIENCE = 3.0  # s of simulated time until a carried robot is found
GLOBAL_PATIENCE = 2.0  # s, likewise after global_localization


class Kidnap(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.kidnaps = rospy.Publisher("kidnap", PoseStamped, queue_size=1)
        self.wait_for(lambda: self.is_accurate(0.0) and self.status() == "tracking", "tracking")

    def next_word(self, since, is_wanted):
        """The first status, with its stamp, that is of this kind."""
        return next((word for word in self.words(since) if is_wanted(word[1])), None)

    def assert_found_within(self, patience, begin):
        """From this stamp on the node does not know, then it does, and what it says is true."""
        away, word = self.wait_for(lambda: self.next_word(begin, lambda w: w != "tracking"),
                                   "the node to notice")
        self.assertIn(word, ["lost", "ambiguous", "globalizing"])
        back, _ = self.wait_for(lambda: self.next_word(away, lambda w: w == "tracking"),
                                "the robot to be found")
        self.wait_for(lambda: len(self.errors(back)) >= 10, "ten more poses")
        for stamp, metres, degrees in self.errors(back):
            self.assertLess(metres, 0.2, "%.1f s after tracking was said" % (stamp - back))
            self.assertLess(degrees, 8.0, "%.1f s after tracking was said" % (stamp - back))
        print("%s after %.1f s, tracking after %.1f s" % (word, away - begin, back - begin))
        self.assertLess(back - begin, patience)

    def test_a_carried_robot_is_found_again(self):
        for place in 3 * PLACES:  # each a second after it was found
            with self.subTest(place=place):
                self.assert_found_within(PATIENCE, self.carry(self.kidnaps, *place))

    def test_global_localization_takes_two_seconds(self):
        for _ in range(5):
            rospy.ServiceProxy("global_localization", Empty)()
            begin = rospy.get_time()
            self.wait_for(lambda: self.is_accurate(begin) and self.status() == "tracking",
                          "the robot to be found")
            wrong = [s for s, metres, degrees in self.errors(begin) if metres > 0.2 or degrees > 8.0]
            took = min(s for s, _, _ in self.errors(begin) if s > max(wrong, default=0)) - begin
            print("found after %.1f s" % took)
            self.assertLess(took, GLOBAL_PATIENCE)
            self.wait_for_time(1.0)


if __name__ == "__main__":
    rospy.init_node("kidnap_test")
    rostest.rosrun("adaptive_localization", "kidnap", Kidnap, sys.argv)
