# SPDX-License-Identifier: BSD-3-Clause
"""What the ROS tests share: listening to the node, the truth and tf, and waiting."""
import bisect
import contextlib
import copy
import math
import os
import time
import unittest

import rospy
import tf2_ros
from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from nav_msgs.msg import Odometry

# Not what a test is about: so that one in which something never comes ends at all. What has to come
# soon is checked by the stamps of messages, whatever the machine has to do besides.
AT_LAST = 600.0  # s of real time


def yaw_of(q):
    return math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))


def wrap(angle):
    return math.atan2(math.sin(angle), math.cos(angle))


def planar(pose):
    """(x, y, yaw) of a geometry_msgs/Pose."""
    return pose.position.x, pose.position.y, yaw_of(pose.orientation)


def initial_pose(x, y, yaw, stamp=None, frame="map", variances=(0.05, 0.05, 0.02)):
    message = PoseWithCovarianceStamped()
    message.header.frame_id = frame
    message.header.stamp = stamp or rospy.Time(0)
    message.pose.pose.position.x = x
    message.pose.pose.position.y = y
    message.pose.pose.orientation.z = math.sin(yaw / 2)
    message.pose.pose.orientation.w = math.cos(yaw / 2)
    message.pose.covariance[0], message.pose.covariance[7], message.pose.covariance[35] = variances
    return message


def values_of(status):
    return {v.key: v.value for v in status.values}


def stamp_of(status):
    """The stamp of the scan that a status of the node answers, s."""
    return float(values_of(status)["stamp"])


class LocalizationCase(unittest.TestCase):
    """Keeps the poses, the status and the truth that are published."""

    def setUp(self):
        self.poses = []  # (stamp, x, y, yaw)
        self.truths = []
        self.statuses = []
        self.tf = tf2_ros.Buffer(rospy.Duration(60))
        self.subscribers = [
            tf2_ros.TransformListener(self.tf),
            rospy.Subscriber("amcl_pose", PoseWithCovarianceStamped, self.on_pose),
            rospy.Subscriber("base_pose_ground_truth", Odometry, self.on_truth),
            rospy.Subscriber("adaptive_localization/status", DiagnosticStatus,
                             self.statuses.append),
        ]

    def tearDown(self):
        for subscriber in self.subscribers:
            subscriber.unregister()

    @contextlib.contextmanager
    def subTest(self, **what):
        """Ends the test when it fails: rosunit would count the failure and not say what it is."""
        try:
            yield
        except AssertionError as error:
            raise AssertionError("%s: %s" % (what, error)) from error

    def on_pose(self, message):
        self.poses.append((message.header.stamp.to_sec(),) + planar(message.pose.pose))

    def on_truth(self, message):
        self.truths.append((message.header.stamp.to_sec(),) + planar(message.pose.pose))

    def truth_at(self, stamp):
        """(x, y, yaw), interpolated."""
        truths = self.truths
        after = bisect.bisect_left(truths, (stamp,))
        if after == 0 or after == len(truths):
            return None
        a, b = truths[after - 1], truths[after]
        share = (stamp - a[0]) / (b[0] - a[0])
        return (a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2]),
                a[3] + share * wrap(b[3] - a[3]))

    def errors(self, since=0.0):
        """(stamp, metres, degrees) of all poses since a stamp that the truth covers."""
        errors = []
        for stamp, x, y, yaw in list(self.poses):
            truth = self.truth_at(stamp) if stamp >= since else None
            if truth:
                errors.append((stamp, math.hypot(x - truth[0], y - truth[1]),
                               abs(math.degrees(wrap(yaw - truth[2])))))
        return errors

    def wait_for(self, condition, what, pause=0.05):
        """Waits until a condition holds, however long that takes."""
        end = time.time() + AT_LAST
        while time.time() < end and not rospy.is_shutdown():
            result = condition()
            if result:
                return result
            time.sleep(pause)
        self.fail("waited %.0f s for %s; status: %s" % (AT_LAST, what, self.status() or "none"))

    def wait_for_time(self, seconds):
        """Simulated ones."""
        end = rospy.get_time() + seconds
        self.wait_for(lambda: rospy.get_time() >= end, "time to pass")

    def wait_for_answers(self, seconds):
        """To all scans of so many simulated seconds from now on, and for the truth of them."""
        end = rospy.get_time() + seconds
        self.wait_for(lambda: self.statuses and stamp_of(self.statuses[-1]) >= end, "answers")
        self.wait_for(lambda: not self.truths or self.truths[-1][0] >= end, "the truth")

    def wait_for_param(self, name, is_wanted=lambda value: True):
        """The parameter's value; the node writes parameters when it finds the time."""
        def is_written():
            value = rospy.get_param(name, None)
            return value is not None and is_wanted(value)
        self.wait_for(is_written, "parameter " + name)
        return rospy.get_param(name)

    def status(self):
        return self.statuses[-1].message if self.statuses else ""

    def status_values(self):
        return values_of(self.statuses[-1]) if self.statuses else {}

    def assert_latency_is_told(self, level, message, values):
        """The status "Latency" after scans, however busy the machine is; returns median, p99 and
        max from a scan's stamp, ms."""
        figures = {since: [float(values["ms from %s, %s" % (since, what)])
                           for what in ["median", "p99", "max"]] for since in ["stamp", "arrival"]}
        for since, times in figures.items():
            self.assertEqual(times, sorted(times), since)
        self.assertGreater(figures["arrival"][0], 0.0)
        self.assertLess(figures["arrival"][2], 60e3)
        self.assertGreater(float(values["share of a core"]), 0.0)
        self.assertLess(float(values["share of a core"]), os.cpu_count() + 0.5)
        wrong = int(values["scans from the future"]) + int(values["scans that are old"])
        is_other_clock = 2 * wrong > int(values["scans"])
        self.assertEqual("Stamps are not of this clock" in message, is_other_clock, message)
        excess = figures["arrival"][1] - float(values["ms between scans"])
        if abs(excess) > 0.1:  # figures are rounded
            self.assertEqual("Late" in message, excess > 0.0, message)
        self.assertEqual(level, DiagnosticStatus.OK if message == "OK" else DiagnosticStatus.WARN)
        return figures["stamp"]

    def carry(self, kidnaps, x, y, yaw=0.0):
        """The robot is lifted and put down there; returns from which stamp on, s."""
        message = PoseStamped()
        message.header.frame_id = "map"
        message.pose.position.x, message.pose.position.y = x, y
        message.pose.orientation.z = math.sin(yaw / 2)
        message.pose.orientation.w = math.cos(yaw / 2)
        self.wait_for(lambda: kidnaps.get_num_connections() > 0, "the simulator")
        known = len(self.truths)
        kidnaps.publish(message)

        def stamp_there():
            return next((truth[0] for truth in self.truths[known:]
                         if math.dist(truth[1:3], (x, y)) < 0.3), None)

        return self.wait_for(stamp_there, "the robot carried")

    def words(self, since):
        """(stamp, status) of the scans since a stamp."""
        words = []
        for status in reversed(list(self.statuses)):
            stamp = stamp_of(status)
            if stamp < since:
                break
            words.append((stamp, status.message))
        return words[::-1]

    def is_accurate(self, since, metres=0.15, degrees=5.0, count=5):
        """The last few poses are right."""
        errors = self.errors(since)[-count:]
        return len(errors) == count and all(m < metres and d < degrees for _, m, d in errors)

    def tell_where_it_is(self):
        """As somebody does who sees the robot, which drives on while the node starts."""
        poses = rospy.Publisher("initialpose", PoseWithCovarianceStamped, queue_size=1)

        def is_told():
            if self.status() not in [None, "", "uninitialised"]:
                return True
            if self.truths:
                stamp, *pose = self.truths[-1]
                poses.publish(initial_pose(*pose, stamp=rospy.Time.from_sec(stamp)))
            return False

        self.wait_for(is_told, "the initial pose to be taken", pause=0.5)

    def spoil_in_turn(self, changes, dropped):
        """Half of the messages that the test hands on, through spoil, are changed by each of some
        functions, until some more were dropped."""
        for change in changes:
            with self.subTest(change=change.__name__):
                before = dropped()

                def spoilt(message, change=change):
                    message = copy.deepcopy(message)
                    change(message)
                    return message

                self.spoil = lambda message, spoilt=spoilt: \
                    spoilt(message) if rospy.get_time() % 1.0 < 0.5 else message
                self.wait_for(lambda: dropped() > before + 5, "messages to be dropped")
        self.spoil = lambda message: message
