#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Messages and requests that used to end the node, or to hold it up: stamps at the end of time, maps
that no memory holds, sizes that no computer can work through, code to be loaded."""
import io
import resource
import struct
import sys
import xmlrpc.client

import rosgraph
import rospy
import rostest
from dynamic_reconfigure.msg import Config, IntParameter, StrParameter
from dynamic_reconfigure.srv import Reconfigure
from localization_case import initial_pose
from nav_msgs.msg import OccupancyGrid
from toy_robot import ToyRobotCase, room, transform

NODE = "/adaptive_localization"
LAST = rospy.Time(2**32 - 1, 999999999)


class RawGrid(rospy.AnyMsg):
    """A map whose cells are bytes: a list of so many numbers would take minutes."""
    _type, _md5sum, _full_text = (
        OccupancyGrid._type, OccupancyGrid._md5sum, OccupancyGrid._full_text)

    def __init__(self, grid, cells):
        super().__init__()
        buffer = io.BytesIO()
        grid.data = []
        grid.serialize(buffer)
        self._buff = buffer.getvalue()[:-4] + struct.pack("<I", len(cells)) + cells


class HostileMessages(ToyRobotCase):
    reached = None  # by the tests before: time, pose and odometry go on

    def setUp(self):
        super().setUp()
        self.subscribers.pop(0).unregister()  # our own tf would end the test
        if self.reached:
            self.time, self.pose, self.odometry = self.reached
        self.localize()
        self.steps(5, (0.05, 0.0, 0.1))
        self.check()

    def tearDown(self):
        type(self).reached = self.time, self.pose, self.odometry
        super().tearDown()

    def check(self):
        """The node lives and knows where the robot is."""
        self.steps(5, (0.03, 0.0, 0.05))
        # told near a corner that looks like another one, it may not have been told from that yet
        self.assertIn(self.status(), ["tracking", "ambiguous"])
        self.assertLess(self.error(), 0.1)

    def test_stamps_at_the_end_of_time(self):
        for stamp in [LAST, LAST - rospy.Duration(5), rospy.Time(2**32 - 100)]:
            self.broadcaster.sendTransform(transform("odom", "base_link", self.odometry, stamp))
            self.broadcaster.sendTransform(transform("base_link", "laser", self.MOUNT, stamp))
            other = transform("base_link", "other", self.MOUNT, stamp)
            ignored = "from 'other' to 'base_link' ignored: its stamp is out of range"
            self.wait_for(lambda: self.static_broadcaster.sendTransform(other) or self.logged(
                ignored), "the transform to be ignored", pause=1.0)  # said now and then
            scan = self.scan_message()
            scan.header.stamp = stamp
            self.logs.clear()
            self.wait_for(lambda: self.scans.publish(scan) or self.logged(
                "Scan dropped"), "the scan to be dropped", pause=1.0)
            self.assertIn("its stamp is out of range", self.logged("Scan dropped")[0])
            self.logs.clear()
            self.initial_poses.publish(initial_pose(*self.pose, stamp=stamp))
            self.wait_for_log("Initial pose taken as that of now")
            self.check()

    def test_maps_that_are_none(self):
        tiny, huge, far, tilted = room(), room(), room(), room()
        tiny.info.resolution = 1e-30
        huge.info.resolution = 1e30
        far.info.origin.position.x = 1e300
        tilted.info.origin.orientation.x = 1.0
        for grid, reason in [(tiny, "resolution: got 1e-30"), (huge, "resolution: got 1e+30"),
                             (far, "origin: got (1e+300"), (tilted, "origin: got a rotation")]:
            self.maps.publish(grid)
            self.wait_for_log("Map not used: map " + reason)
            self.check()

    def test_transform_from_the_future(self):
        ahead = self.time + rospy.Duration(3600)
        self.broadcaster.sendTransform(transform("odom", "base_link", self.odometry, ahead))
        for _ in range(15):
            self.move()
            self.send_odometry()
        self.wait_for_log("which came from the future")
        self.check()

    def test_odometry_beyond_the_world(self):
        known = self.odometry
        self.odometry = (1e30, 0.0, 0.0)
        self.wait_for(lambda: self.move() or self.send() and self.logged("Scan dropped"),
                      "the scan to be dropped", pause=0.2)
        self.assertIn("tf has 'base_link' at (1e+30, 0) m in 'odom', expected",
                      self.logged("Scan dropped")[0])
        self.odometry = known
        self.check()

    def test_laser_beyond_the_robot(self):
        self.static_broadcaster.sendTransform(
            transform("base_link", "far", (1e300, 0.0, 0.0), rospy.Time.now()))
        self.wait_for(lambda: self.scans.publish(self.scan_message(frame="far")) or self.logged(
            "Scan dropped"), "the scan to be dropped", pause=0.2)
        self.assertIn("tf has 'far' at (1e+300, 0) m in 'base_link', expected",
                      self.logged("Scan dropped")[0])
        self.check()

    def test_initial_pose_that_is_none(self):
        common = initial_pose(*self.pose)
        common.pose.covariance[1] = common.pose.covariance[6] = 10.0
        self.initial_poses.publish(common)
        self.wait_for_log("0.02 and a covariance of x and y of 10 and 10, expected")
        turned = initial_pose(*self.pose[:2], float("nan"))
        self.initial_poses.publish(turned)
        self.wait_for_log("m, nan rad with variances")
        self.check()

    def test_names_that_are_none(self):
        for text in ["od\nom", "\u00e9", "odom\0"]:
            self.logs.clear()
            answer = self.reconfigure(strs={"odom_frame_id": text})
            self.assertIn("odom", [s.value for s in answer.strs if s.name == "odom_frame_id"])
            self.wait_for_log("Options stay as they were: field 'odom_frame_id'")
        self.check()

    def test_a_map_that_does_not_fit_memory(self):
        """The node is left memory for the message, but not for what is made of it."""
        pid = self.pid()
        with open("/proc/%d/statm" % pid) as statm:
            used = int(statm.read().split()[0]) * resource.getpagesize()
        side = 8000
        unlimited = resource.prlimit(pid, resource.RLIMIT_AS)
        resource.prlimit(pid, resource.RLIMIT_AS, (used + 10 * side * side, unlimited[1]))
        self.addCleanup(resource.prlimit, pid, resource.RLIMIT_AS, unlimited)
        self.maps.unregister()
        maps = rospy.Publisher("map", RawGrid, queue_size=1, latch=True)
        self.addCleanup(maps.unregister)
        grid = room()
        grid.info.width = grid.info.height = side
        maps.publish(RawGrid(grid, bytes(side * side)))
        self.wait_for_log("Map not used: map size: got 8000 x 8000 cells, which take")
        self.check()

    def pid(self):
        node = xmlrpc.client.ServerProxy(rosgraph.Master("/hostile_messages_test").lookupNode(NODE))
        return node.getPid("/hostile_messages_test")[2]

    def test_sizes_that_would_hold_up_the_node(self):
        answer = self.reconfigure(ints={"min_particles": 10000000, "max_particles": 10000000,
                                        "laser_max_beams": 100000})
        sizes = {i.name: i.value for i in answer.ints}
        self.wait_for_log("Options stay as they were: ")
        self.assertIn("look-ups", self.logged("Options stay as they were: ")[0])
        self.assertLess(sizes["min_particles"], 1000)
        self.check()

    def test_code_and_files_are_chosen_at_the_start_alone(self):
        for key in ["plugins", "cache_dir", "line_map", "pose_file"]:
            answer = self.reconfigure(strs={key: "/nowhere/at/all"})
            self.assertNotIn(key, [s.name for s in answer.strs])
            self.wait_for_log("There is no field '%s'" % key)
            self.assertNotEqual(rospy.get_param(NODE + "/" + key, None), "/nowhere/at/all")
        self.check()

    def reconfigure(self, ints=None, strs=None):
        """By hand: a client would check names and ranges before it asks."""
        config = Config()
        config.ints = [IntParameter(*item) for item in (ints or {}).items()]
        config.strs = [StrParameter(*item) for item in (strs or {}).items()]
        return rospy.ServiceProxy(NODE + "/set_parameters", Reconfigure)(config).config


if __name__ == "__main__":
    rospy.init_node("hostile_messages_test")
    rostest.rosrun("adaptive_localization", "hostile_messages", HostileMessages, sys.argv)
