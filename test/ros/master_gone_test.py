#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""roscore ends and comes back, or does not answer: the node says so, idles as before, goes on and
still ends when asked to. All in a ROS world of its own."""
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

import rosgraph
import roslib.packages
import rospkg
import rostest
from localization_case import AT_LAST

PACKAGE = "adaptive_localization"
MAZE = os.path.join(rospkg.RosPack().get_path(PACKAGE), "maps", "maze")


def free_port():
    with socket.socket() as found:
        found.bind(("localhost", 0))
        return found.getsockname()[1]


class MasterGone(unittest.TestCase):
    def setUp(self):
        self.port = str(free_port())
        self.uri = "http://localhost:" + self.port
        self.environment = dict(os.environ, ROS_MASTER_URI=self.uri)
        self.output = tempfile.TemporaryFile("w+")

    def run_until_clean_up(self, *command, **options):
        process = subprocess.Popen(command, env=self.environment, **options)
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        return process

    def start(self, program, *arguments):
        path = roslib.packages.find_node(PACKAGE, program)[0]
        return self.run_until_clean_up(path, *arguments, stdout=self.output, stderr=self.output)

    def start_master(self):
        process = self.run_until_clean_up("rosmaster", "--core", "-p", self.port,
                                          stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.wait(lambda: rosgraph.is_master_online(self.uri), "the master")
        return process

    def wait(self, condition, what):
        end = time.time() + AT_LAST
        while not condition():
            self.assertLess(time.time(), end, "waited for %s:\n%s" % (what, self.said()))
            time.sleep(0.05)

    def said(self):
        self.output.seek(0)
        return self.output.read()

    def kept(self):
        master = rosgraph.Master("/master_gone_test", self.uri)
        return master.getParam("/adaptive_localization/initial_pose_x") \
            if master.hasParam("/adaptive_localization/initial_pose_x") else None

    def share_of_a_core(self, process, seconds):
        def spent():
            with open("/proc/%d/stat" % process.pid) as stat:
                fields = stat.read().rsplit(")", 1)[1].split()
            return sum(map(int, fields[11:13])) / os.sysconf("SC_CLK_TCK")
        begin = spent()
        time.sleep(seconds)
        return (spent() - begin) / seconds

    def start_robot(self):
        """The node among a simulated robot and a map, once it has kept a pose."""
        self.start("map_publisher", os.path.join(MAZE, "map.yaml"))
        self.start("p3dx_simulator", "_world:=" + os.path.join(MAZE, "world.yaml"), "_drive:=true",
                   "_start:=0.8,0.8,1.57")
        node = self.start("adaptive_localization", "_save_pose_rate:=2")
        self.wait(lambda: self.kept() is not None, "a kept pose")
        return node

    def test_node_outlives_the_master(self):
        master = self.start_master()
        node = self.start_robot()
        master.send_signal(signal.SIGINT)
        master.wait()
        self.wait(lambda: "No ROS master at " + self.uri in self.said(), "what the node says")
        self.assertLess(self.share_of_a_core(node, 2.0), 0.5)

        # The node goes on with the connections it has, so that it keeps poses again.
        self.start_master()
        self.wait(lambda: self.kept() is not None, "a kept pose")

        self.assertIsNone(node.poll())
        node.send_signal(signal.SIGINT)
        self.assertEqual(node.wait(AT_LAST), 0)

    def test_node_localizes_while_the_master_is_frozen(self):
        """As behind a wireless link that is lost: what is written to it waits, scans do not."""
        master = self.start_master()
        node = self.start_robot()
        poses = tempfile.TemporaryFile("w+")
        self.run_until_clean_up("rostopic", "echo", "-p", "/amcl_pose/header/stamp", stdout=poses)

        def count():
            poses.seek(0)
            return len(poses.readlines())

        self.wait(lambda: count() > 5, "poses")
        master.send_signal(signal.SIGSTOP)
        self.addCleanup(master.send_signal, signal.SIGCONT)
        before = count()
        self.wait(lambda: count() > before + 100, "poses without a master")
        master.send_signal(signal.SIGCONT)
        old = self.kept()
        self.wait(lambda: self.kept() != old, "a pose kept anew")
        node.send_signal(signal.SIGINT)
        self.assertEqual(node.wait(AT_LAST), 0)

    def test_node_ends_while_the_master_is_frozen(self):
        """roscpp alone would wait for its answer."""
        master = self.start_master()
        node = self.start_robot()
        master.send_signal(signal.SIGSTOP)
        self.addCleanup(master.send_signal, signal.SIGCONT)
        node.send_signal(signal.SIGINT)
        self.assertEqual(node.wait(AT_LAST), 1)
        self.assertIn("ended without the ROS master's answer", self.said())


if __name__ == "__main__":
    rostest.rosrun(PACKAGE, "master_gone", MasterGone, sys.argv)
