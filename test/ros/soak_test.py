#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A robot drives for long in an office of equal rooms, among people: now and then it is carried away,
the map changes, an option does, or somebody asks for a search of the whole map. The node keeps its
memory, answers, and, where these are a minute apart, calls no wrong place tracking for long. Prints a
row after each of them."""
import itertools
import sys

import rospy
import rostest
from amcl_protocol import Programs
from diagnostic_msgs.msg import DiagnosticArray
from dynamic_reconfigure.client import Client
from localization_case import AT_LAST, LocalizationCase, values_of
from std_srvs.srv import Empty

FAR, TURNED = 0.5, 20.0  # m and degrees: a wrong pose
MOST_WRONG = 5.0  # s in a row,
REST = 60.0  # if so many are between two events: the robot has left its room, which has twins
GAP = 1.0  # s: after so long without a pose another row begins
MOST_GROWTH = 1.25  # of memory, from the second quarter of the rows to the last
ROW = "%8s  %-20s %10s %12s %12s %12s %14s"
TITLES = ("time, s", "after", "memory, MB", "p99, ms", "of a core", "tracking, %", "wrongly, s")


class Soak(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.latency = {}
        self.subscribers.append(rospy.Subscriber("/diagnostics", DiagnosticArray, self.on_diagnostics))
        self.programs = Programs()
        self.addCleanup(self.programs.end)
        self.publisher = None
        self.maps = itertools.cycle(["office", "office_moved"])
        self.beams = itertools.cycle([45, 60])
        self.change_the_map()
        self.node = self.programs.start("adaptive_localization", filter=rospy.get_param("~filter"),
                                        use_map_topic="true", start="wait", seed=1)
        self.tell_where_it_is()
        self.wait_for(lambda: self.is_accurate(0.0), "right poses")
        self.client = Client("adaptive_localization", timeout=AT_LAST)

    def on_diagnostics(self, message):
        for status in message.status:
            if status.name.endswith("Latency"):
                self.latency = values_of(status)

    def carry_away(self):
        rospy.ServiceProxy("kidnap_random", Empty)()

    def change_the_map(self):
        if self.publisher:
            self.publisher.terminate()
            self.publisher.wait(AT_LAST)
        path = "%s/%s/map.yaml" % (rospy.get_param("~maps"), next(self.maps))
        self.publisher = self.programs.start("map_publisher", path)

    def change_an_option(self):
        beams = next(self.beams)
        self.assertEqual(self.client.update_configuration({"laser_max_beams": beams})["laser_max_beams"], beams)

    def look_anywhere(self):
        rospy.ServiceProxy("global_localization", Empty)()

    def test_the_node_lives_on(self):
        minutes, every = rospy.get_param("~minutes"), rospy.get_param("~every")
        begin = rospy.get_time()
        megabytes, longest = [], 0.0
        print(ROW % TITLES, flush=True)
        happenings = itertools.cycle(
            [self.carry_away, self.change_the_map, self.change_an_option, self.look_anywhere])
        while rospy.get_time() < begin + 60.0 * minutes:
            happening = next(happenings)
            since = rospy.get_time()
            happening()
            self.wait_for_answers(every)
            self.assertIsNone(self.node.poll(), "the node ended")
            megabytes.append(self.megabytes())
            share, wrongly = self.tracking(since)
            longest = max(longest, wrongly)
            print(ROW % ("%.0f" % (rospy.get_time() - begin), happening.__name__.replace("_", " "),
                         "%.1f" % megabytes[-1], self.latency.get("ms from arrival, p99"),
                         self.latency.get("share of a core"), "%.0f" % (100.0 * share),
                         "%.1f" % wrongly), flush=True)
            self.forget_before(rospy.get_time() - every)
        quarter = len(megabytes) // 4  # of the rows, in the first of which much is new
        self.assertLess(max(megabytes[-quarter:]), MOST_GROWTH * max(megabytes[quarter:2 * quarter]))
        if every >= REST:
            self.assertLess(longest, MOST_WRONG, "s of tracking at a wrong place")

    def megabytes(self):
        with open("/proc/%d/status" % self.node.pid) as status:
            return next(int(line.split()[1]) for line in status if line.startswith("RssAnon:")) / 1024.0

    def tracking(self, since):
        """Of the scans since a stamp, the share that said so, and for how long in a row of a wrong
        pose, s."""
        words = self.words(since)
        self.assertGreater(len(words), 0, "no scan was answered")
        tracking = {round(stamp, 3) for stamp, word in words if word == "tracking"}
        longest, first, last = 0.0, None, since
        for stamp, metres, degrees in self.errors(since):
            is_wrong = round(stamp, 3) in tracking and (metres > FAR or degrees > TURNED)
            first = None if not is_wrong else stamp if first is None or stamp > last + GAP else first
            longest = max(longest, stamp - first) if is_wrong else longest
            last = stamp
        return len(tracking) / len(words), longest

    def forget_before(self, stamp):
        """What an hour leaves would make each row slower than the one before."""
        for kept in [self.poses, self.truths]:
            kept[:] = [entry for entry in kept if entry[0] >= stamp]
        del self.statuses[:-len(self.words(stamp)) or None]


if __name__ == "__main__":
    rospy.init_node("soak_test")
    rostest.rosrun("adaptive_localization", "soak", Soak, sys.argv)
