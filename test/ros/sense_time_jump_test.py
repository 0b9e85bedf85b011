#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Time jumps back for a robot without a laser, which landmarks or sonars localize: the simulator is
started again."""
import os
import sys
import time
import unittest

import rospkg
import rospy
import rostest
from amcl_protocol import PACKAGE, Programs
from diagnostic_msgs.msg import DiagnosticStatus
from localization_case import AT_LAST, stamp_of
from rosgraph_msgs.msg import Log

MAPS = os.path.join(rospkg.RosPack().get_path(PACKAGE), "maps")


class SenseTimeJump(unittest.TestCase):
    def setUp(self):
        rospy.set_param("/use_sim_time", True)  # of the nodes; this one needs no clock
        for node in ["/adaptive_localization", "/p3dx_simulator"]:
            if rospy.has_param(node):
                rospy.delete_param(node)
        self.stamps, self.logs = [], []
        for subscriber in [rospy.Subscriber("adaptive_localization/status", DiagnosticStatus, self.on_status),
                           rospy.Subscriber("/rosout", Log, lambda log: self.logs.append(log.msg))]:
            self.addCleanup(subscriber.unregister)
        self.programs = Programs()
        self.addCleanup(self.programs.end)

    def on_status(self, message):
        self.stamps.append(stamp_of(message))

    def wait(self, condition, what):
        end = time.time() + AT_LAST
        while not condition():
            self.assertLess(time.time(), end, "waited for " + what)
            time.sleep(0.01)

    def check(self, world, sense, **parameters):
        def simulate():
            return self.programs.start("p3dx_simulator", world=os.path.join(MAPS, world, "world.yaml"), drive="true",
                                       start="0.8,0.8,1.57", lasers=0, speed=4, seed=3, **{sense: "true"})
        self.programs.start("map_publisher", os.path.join(MAPS, world, "map.yaml"))
        simulator = simulate()
        self.programs.start("adaptive_localization", initial_pose_x=0.8, initial_pose_y=0.8, initial_pose_a=1.57,
                            **parameters)
        self.wait(lambda: self.stamps and self.stamps[-1] > self.stamps[0] + 10.0, "answers")
        simulator.terminate()
        simulator.wait(AT_LAST)
        before = self.stamps[-1]
        simulate()
        self.wait(lambda: [log for log in self.logs if "Time jumped back" in log], "the jump in the log")
        self.wait(lambda: self.stamps[-1] < before, "an answer after the jump")
        again = self.stamps[-1]
        self.wait(lambda: again + 2.0 < self.stamps[-1], "more answers")

    def test_of_landmarks(self):
        self.check("robocup", "camera", scan_topics="", landmark_topic="landmarks",
                   landmark_map=os.path.join(MAPS, "robocup", "world.yaml"))

    def test_of_sonars(self):
        self.check("maze", "sonars", scan_topics="", sonar_topics="sonar")


if __name__ == "__main__":
    rospy.init_node("sense_time_jump_test")
    rostest.rosrun(PACKAGE, "sense_time_jump", SenseTimeJump, sys.argv)
