#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""amcl's own test protocol on the maps of Willow Garage: a robot drives, and the transform from map
to base_link is compared with where it really is. amcl's tests look once, at the end, and allow
0.75 m; this looks once a second from --settled on and allows a third of that."""
import argparse
import math
import os
import sys
import time
import unittest

import rospkg
import rospy
import rostest
import tf2_ros
from amcl_protocol import PACKAGE, Drive, Programs, TwoLasers
from geometry_msgs.msg import PoseWithCovarianceStamped
from localization_case import AT_LAST, initial_pose, wrap, yaw_of
from std_srvs.srv import Empty


def numbers(text):
    return tuple(float(number) for number in text.split(","))


def parse(arguments):
    parser = argparse.ArgumentParser()
    parser.add_argument("--map", required=True, help="without .yaml")
    parser.add_argument("--start", required=True, help="x,y,yaw")
    parser.add_argument("--route", nargs="+", required=True, help="x,y of each way-point")
    parser.add_argument("--told", choices=["by_parameter", "by_topic", "late", "nothing"],
                        default="by_parameter", help="how the node learns where it starts")
    parser.add_argument("--settled", type=float, default=2.0, help="s after the start")
    parser.add_argument("--tolerance", type=float, default=0.25, help="m and rad")
    parser.add_argument("--two_lasers", action="store_true")
    parser.add_argument("--speed", type=float, default=8.0, help="simulated seconds per second")
    parser.add_argument("--seed", type=int, default=1)
    return parser.parse_known_args(arguments)[0]


SCENE = parse(rospy.myargv()[1:])
LATE = 5.0  # s after the start the pose is told; that of LATENESS before
LATENESS = 3.0


def map_file():
    beside = os.path.join(rospkg.RosPack().get_path(PACKAGE), "..", "shared", "data")
    data = os.environ.get("ADAPTIVE_LOCALIZATION_DATA", beside)
    return os.path.join(data, "maps", SCENE.map + ".yaml")


class AmclProtocol(unittest.TestCase):
    def setUp(self):
        if not os.path.exists(map_file()):
            print("skipped: there is no %s" % map_file(), file=sys.__stdout__)
            self.skipTest("no map")
        rospy.set_param("/use_sim_time", True)  # of the nodes; this one needs no clock
        self.tf = tf2_ros.Buffer(rospy.Duration(3600))
        self.listener = tf2_ros.TransformListener(self.tf)
        self.pose = rospy.Publisher("initialpose", PoseWithCovarianceStamped, queue_size=1)
        self.programs = Programs()
        self.addCleanup(self.programs.end)

    def start(self):
        self.programs.start("map_publisher", map_file())
        where = {}
        if SCENE.told == "by_parameter":
            where = dict(zip(("initial_pose_x", "initial_pose_y", "initial_pose_a"),
                             numbers(SCENE.start)))
        self.programs.start("adaptive_localization", **where)
        rospy.wait_for_service("global_localization", AT_LAST)
        arguments = []
        if SCENE.two_lasers:
            arguments = ["scan:=whole_scan"]
            self.addCleanup(TwoLasers().end)
        drive = Drive([])
        self.addCleanup(drive.end)
        self.programs.start("p3dx_simulator", *arguments, world=map_file(), start=SCENE.start,
                            seed=SCENE.seed, speed=SCENE.speed, lock_step="true",
                            max_speed=Drive.MAX_SPEED)
        return drive

    def tell(self, drive):
        """Lets the robot drive and says where it is, in the way of the scene."""
        if SCENE.told == "nothing":
            rospy.ServiceProxy("global_localization", Empty)()
        drive.route.extend(map(numbers, SCENE.route))
        if SCENE.told in ["by_topic", "late"]:
            now = drive.now
            if SCENE.told == "late":
                self.wait(lambda: drive.now[0] > now[0] + LATE, "time to pass")
                now = next(n for n in drive.notes if n[0] > drive.now[0] - LATENESS)
            self.pose.publish(initial_pose(*now[1:], rospy.Time.from_sec(now[0]),
                                           variances=(0.25, 0.25, 0.0685)))

    def wait(self, condition, what):
        end = time.time() + AT_LAST
        while not condition():
            self.assertLess(time.time(), end, "waited %.0f s for %s" % (AT_LAST, what))
            time.sleep(0.01)

    def error(self, stamp, x, y, yaw):
        """Metres and radians between tf and the truth at a stamp."""
        found = self.tf.lookup_transform("map", "base_link", rospy.Time.from_sec(stamp)).transform
        return (math.hypot(found.translation.x - x, found.translation.y - y),
                abs(wrap(yaw_of(found.rotation) - yaw)))

    def knows(self, stamp):
        return self.tf.can_transform("map", "base_link", rospy.Time.from_sec(stamp))

    def test_transform_stays_right(self):
        drive = self.start()
        # the simulator waits for a node that localizes; one that starts slowly it would leave behind
        self.wait(lambda: drive.now and self.knows(0.0), "the first transform")
        self.tell(drive)
        told = drive.now[0]
        self.wait(lambda: not drive.route, "the end of the route")
        last = drive.notes[-1][0]
        self.wait(lambda: self.knows(last), "tf at the end")
        begin = next(note[0] for note in drive.notes if note[0] >= told and self.knows(note[0]))
        length = sum(math.dist(a, b) for a, b in zip(
            [numbers(SCENE.start)[:2]] + list(map(numbers, SCENE.route)),
            map(numbers, SCENE.route)))
        self.assertGreater(drive.travelled, 0.8 * length)
        looks = [note for note in drive.notes if begin + SCENE.settled <= note[0] <= last]
        self.assertGreater(len(looks), 5)
        errors = [self.error(*note) for note in looks]
        print("%s, %.0f m in %.0f s: at most %.3f m, %.3f rad; at the end %.3f m, %.3f rad" % (
            SCENE.map, drive.travelled, last - begin, max(e[0] for e in errors),
            max(e[1] for e in errors), *errors[-1]), file=sys.__stdout__, flush=True)
        for note, (metres, radians) in zip(looks, errors):
            where = "after %.0f s at (%.1f, %.1f)" % ((note[0] - begin,) + note[1:3])
            self.assertLess(metres, SCENE.tolerance, where)
            self.assertLess(radians, SCENE.tolerance, where)


if __name__ == "__main__":
    rospy.init_node("amcl_protocol_test")
    rostest.rosrun(PACKAGE, "amcl_protocol", AmclProtocol, sys.argv)
