#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""With ~pose_file, a node that was cut off resumes where it was, even with a new parameter server;
a broken file is warned about."""
import math
import os
import shutil
import signal
import subprocess
import sys
import tempfile

import roslib.packages
import rospy
import rostest
import yaml
from localization_case import initial_pose
from toy_robot import ToyRobotCase, room

PROGRAM = roslib.packages.find_node("adaptive_localization", "adaptive_localization")[0]


class PowerFailure(ToyRobotCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.file = os.path.join(self.folder, "pose.yaml")
        self.start()
        super().setUp()
        self.maps.publish(room())
        self.wait_for_log("Map of")

    def tearDown(self):
        self.process.kill()
        self.process.wait()
        shutil.rmtree(self.folder)
        super().tearDown()

    def start(self):
        with open(os.path.join(self.folder, "output"), "w") as output:
            self.process = subprocess.Popen(
                [PROGRAM, "_start:=wait", "_use_map_topic:=true", "_save_pose_rate:=5",
                 "_pose_file:=" + self.file], stdout=output, stderr=output,
                env=dict(os.environ, ROSCONSOLE_STDOUT_LINE_BUFFERED="1"))

    def output(self):
        """What the node said since its last start."""
        with open(os.path.join(self.folder, "output")) as output:
            return output.read()

    def restart(self, number):
        """As after a power failure: nothing is left but the file."""
        self.process.send_signal(number)
        self.process.wait()
        rospy.delete_param("adaptive_localization")
        self.forget()
        self.start()
        self.wait_for(lambda: "Map of" in self.output(), "the node again")

    def is_kept(self):
        """The file says where the robot is; called again and again it lets the robot stand."""
        self.step()
        with open(self.file) as file:
            kept = yaml.safe_load(file)
        return math.dist((kept["initial_pose_x"], kept["initial_pose_y"]), self.pose[:2]) < 0.1

    def test_node_resumes_from_the_file(self):
        self.initial_poses.publish(initial_pose(*self.pose))
        self.wait_for_log("Initial pose")
        self.steps(30, (0.05, 0.0, 0.08))
        self.assertLess(self.error(), 0.1)

        self.wait_for(self.is_kept, "the pose in the file")
        self.restart(signal.SIGKILL)
        self.assertIn("kept in " + self.file, self.output())
        self.steps(5)
        self.assertEqual(len(self.poses), 1)
        self.assertLess(self.error(), 0.15)

        self.steps(20, (0.05, 0.0, 0.08))
        for number in [signal.SIGTERM, signal.SIGINT]:
            self.restart(number)
            self.steps(5)
            self.assertLess(self.error(), 0.15)

        with open(self.file, "w") as file:
            file.write("initial_pose_x: 1.0\ninitial_pose_y: .nan\n")
        self.restart(signal.SIGKILL)
        self.assertIn("Pose file ignored", self.output())
        self.steps(5)
        self.assertEqual(self.poses, [])


if __name__ == "__main__":
    rospy.init_node("power_failure_test")
    rostest.rosrun("adaptive_localization", "power_failure", PowerFailure, sys.argv)
