#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Transforms that come late, twice, or from two nodes: scans wait for theirs, what comes twice
changes nothing, and two nodes that publish the same frame are named."""
import subprocess
import sys
import time

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticStatus
from tf2_msgs.msg import TFMessage
from toy_robot import ToyRobotCase, transform

TURN = (0.04, 0.0, 0.1)  # in each step: a circle within the room
LATE = 0.3  # s of real time
AHEAD = rospy.Duration(0.03)  # of the scans, odometry as a robot sends it that knows of no scans
BEHIND = rospy.Duration(0.04)  # of odometry, what contradicts it
MOST_WRONG = 10  # scans in a row, a second


def contradict(frame):
    """Of another node: every second transform of a frame is answered by one to another place."""
    rospy.init_node("rival")
    broadcaster = tf2_ros.TransformBroadcaster()
    heard = 0

    def on_tf(message):
        nonlocal heard
        if message._connection_header["callerid"] == rospy.get_name():
            return
        for answer in message.transforms:
            if answer.child_frame_id != frame:
                continue
            heard += 1
            if heard % 2 == 0:
                answer.header.stamp += BEHIND
                answer.transform.translation.x += 1.0
                answer.transform.translation.y += 0.5
                broadcaster.sendTransform(answer)

    rospy.Subscriber("/tf", TFMessage, on_tf)
    rospy.spin()


class Transforms(ToyRobotCase):
    def test_transforms(self):
        self.localize()
        self.scans_wait_for_those_that_come_late()
        self.those_that_come_twice_change_nothing()
        self.another_publisher_of_the_correction_is_named()
        self.another_publisher_of_odometry_is_named()

    def scans_wait_for_those_that_come_late(self):
        def send():
            self.scans.publish(self.scan_message())
            time.sleep(LATE)
            self.send_odometry()
            return time.time()

        self.drive_well(send)

    def those_that_come_twice_change_nothing(self):
        def send():
            self.send_odometry()
            self.send_odometry()
            self.scans.publish(self.scan_message())
            self.send_odometry()
            return time.time()

        self.drive_well(send)

    def another_publisher_of_the_correction_is_named(self):
        self.contradicted("odom", "/adaptive_localization and by /rival")
        self.assertEqual(self.status(), "tracking")

    def another_publisher_of_odometry_is_named(self):
        def send():
            self.broadcaster.sendTransform(
                transform("odom", "base_link", self.odometry, self.time + AHEAD))
            self.scans.publish(self.scan_message())
            return time.time()

        self.drive_well(send)
        self.contradicted("base_link", "/rival and by " + rospy.get_name())

    def contradicted(self, frame, nodes):
        """Log and diagnostics name the two; no wrong place is said to be tracked for long."""
        self.forget()
        text = "'%s' is published by %s" % (frame, nodes)
        rival = subprocess.Popen([sys.executable, __file__, "--contradict", frame])
        self.addCleanup(rival.kill)
        wrong = 0

        def is_told():
            nonlocal wrong
            self.step(TURN)
            is_wrong = self.status() == "tracking" and self.poses and self.error() > 0.5
            wrong = wrong + 1 if is_wrong else 0
            self.assertLess(wrong, MOST_WRONG, "scans at a wrong place")
            return self.trouble() == text and self.logged(text)

        self.wait_for(is_told, "the two to be named")
        rival.terminate()
        rival.wait()
        self.wait_for(lambda: self.step(TURN) or self.trouble() == "", "an end of it")
        self.wait_for(lambda: self.step(TURN) or self.status() == "tracking", "tracking")
        self.drive_well(self.send)

    def trouble(self):
        """What the newest diagnostics warn of, of transforms; None before there are any."""
        told = self.diagnostic("Transforms")
        if not told:
            return None
        return told[1] if told[0] == DiagnosticStatus.WARN else ""

    def drive_well(self, send):
        """Some steps from now on with these transforms: all scans are used, the robot is tracked."""
        self.send = send
        self.lost = 0
        self.steps(10, TURN)
        self.assertEqual(self.lost, 0)
        self.assertEqual(self.status(), "tracking")
        self.assertLess(self.error(), 0.1)


if __name__ == "__main__":
    if "--contradict" in sys.argv:
        contradict(sys.argv[sys.argv.index("--contradict") + 1])
    else:
        rospy.init_node("transforms_test")
        rostest.rosrun("adaptive_localization", "transforms", Transforms, sys.argv)
