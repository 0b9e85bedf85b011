#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""People walk about the maze, and the Kalman filter that matches scans does not mind them; the
robot is also found after it was carried away and from an unknown start. How large errors may be, and
how long the drive is, the launch file says."""
import sys

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped
from localization_case import LocalizationCase, stamp_of
from std_srvs.srv import Empty
from visualization_msgs.msg import Marker, MarkerArray


PATIENCE = 120.0  # s of simulated time; when tried at 224 moments it took up to 25 s, and to find
# the robot from anywhere, at 154 moments, up to 44 s


class People(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.matches, self.people, self.diagnostics = [], [], []
        self.subscribers += [
            rospy.Subscriber("adaptive_localization/match", Marker, self.matches.append),
            rospy.Subscriber("p3dx_simulator/truth_markers", MarkerArray, self.people.append),
            rospy.Subscriber("/diagnostics", DiagnosticArray, self.diagnostics.append)]
        self.wait_for(lambda: self.is_accurate(0.0) and self.status() == "tracking", "tracking")

    def test_a_drive_among_people(self):
        begin = rospy.get_time()
        self.wait_for_answers(rospy.get_param("~seconds"))
        errors = self.errors(begin)
        self.assertGreater(len(errors), 60, self.heard(begin))
        print("largest error %.3f m, %.2f deg, mean %.3f m of %d poses" % (
            max(m for _, m, _ in errors), max(d for _, _, d in errors),
            sum(m for _, m, _ in errors) / len(errors), len(errors)))
        for stamp, metres, degrees in errors:
            self.assertLess(metres, rospy.get_param("~largest_error"), "at %.1f s" % stamp)
            self.assertLess(degrees, 3.0, "at %.1f s" % stamp)
        self.assertEqual(self.status(), "tracking")

        fitting, strangers = 0, 0
        for marker in self.matches:
            self.assertEqual(len(marker.points), len(marker.colors))
            fitting += sum(c.g > c.r and c.g > c.b for c in marker.colors)
            strangers += sum(c.b > c.g for c in marker.colors)
        print("%d hits fit, %d do not" % (fitting, strangers))
        self.assertGreater(fitting, 1000)
        self.assertGreater(strangers, 100)
        self.assertGreater(fitting, strangers)
        values = self.status_values()
        self.assertIn("match", values)
        self.assertGreater(float(values["match inliers"]), 0.0)
        names = {s.name for array in self.diagnostics for s in array.status}
        self.assertIn("adaptive_localization: Match", names)

    def heard(self, begin):
        """What has come since, for a failure's message."""
        stamps = {"poses": [pose[0] for pose in self.poses],
                  "truths": [truth[0] for truth in self.truths],
                  "statuses": [stamp_of(status) for status in self.statuses]}
        return "since %.2f s, now %.2f s: %s" % (begin, rospy.get_time(), {
            what: "%d in order: %s, since then %d, from %.2f to %.2f s" % (
                len(s), s == sorted(s), sum(stamp >= begin for stamp in s), min(s), max(s))
            for what, s in stamps.items()})

    def test_found_among_people_after_being_carried_and_from_anywhere(self):
        """At last, and not whether the node says before that it does not know: it may be right
        again within three scans and never say so, or believe for long that it is somewhere else,
        where the scans fit as well if some of what they see is taken for people."""
        kidnaps = rospy.Publisher("kidnap", PoseStamped, queue_size=1)
        self.assert_found(self.carry(kidnaps, 5.5, 2.7), "carried")
        rospy.ServiceProxy("global_localization", Empty)()
        self.assert_found(rospy.get_time(), "anywhere")

    def assert_found(self, begin, what):
        """Scan by scan, so that a slow machine has all the time that it needs."""
        found = self.wait_for(lambda: self.found_at(begin) or self.waits_since(begin), what)
        self.assertIsInstance(found, float, "%s: not found for %.0f s" % (what, PATIENCE))
        print("%s: found %.1f s later" % (what, found - begin))

    def found_at(self, begin):
        """The stamp of the fifth right pose in a row, the node being sure of it."""
        sure = {round(stamp, 3) for stamp, word in self.words(begin) if word == "tracking"}
        right = 0
        for stamp, metres, degrees in self.errors(begin):
            is_right = metres < 0.1 and degrees < 3.0 and round(stamp, 3) in sure
            right = right + 1 if is_right else 0
            if right == 5:
                return stamp
        return None

    def waits_since(self, begin):
        return bool(self.statuses) and stamp_of(self.statuses[-1]) > begin + PATIENCE


if __name__ == "__main__":
    rospy.init_node("people_test")
    rostest.rosrun("adaptive_localization", "people", People, sys.argv)
