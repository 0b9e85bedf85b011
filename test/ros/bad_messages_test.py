#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A robot standing in a room of 6 x 4 m: messages that make no sense are dropped with a reason, and
the node lives on. tf does not know the laser; robot_description does."""
import math
import sys

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped
from localization_case import LocalizationCase, initial_pose
from nav_msgs.msg import OccupancyGrid
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import LaserScan
from std_srvs.srv import Empty

RESOLUTION, WIDTH, HEIGHT = 0.05, 122, 82  # with a wall one cell thick all round
X, Y, YAW = 2.0, 1.5, 0.5
LASER_X = 0.2


def room():
    grid = OccupancyGrid()
    grid.header.frame_id = "map"
    grid.info.resolution, grid.info.width, grid.info.height = RESOLUTION, WIDTH, HEIGHT
    grid.info.origin.position.x = grid.info.origin.position.y = -RESOLUTION
    grid.info.origin.orientation.w = 1.0
    grid.data = [100 if min(i, WIDTH - 1 - i, j, HEIGHT - 1 - j) == 0 else 0
                 for j in range(HEIGHT) for i in range(WIDTH)]
    return grid


def scan():
    message = LaserScan()
    message.header.frame_id = "laser"
    message.angle_min, message.angle_max = -math.pi / 2, math.pi / 2
    message.angle_increment = math.pi / 180
    message.range_max = 30.0
    x, y = X + LASER_X * math.cos(YAW), Y + LASER_X * math.sin(YAW)
    for i in range(181):
        c = math.cos(YAW + message.angle_min + i * message.angle_increment)
        s = math.sin(YAW + message.angle_min + i * message.angle_increment)
        message.ranges.append(min((6.0 - x) / c if c > 0 else -x / c if c < 0 else 99.0,
                                  (4.0 - y) / s if s > 0 else -y / s if s < 0 else 99.0))
    return message


class BadMessages(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.logs = []
        logs = rospy.Subscriber("rosout", Log, lambda log: self.logs.append(log.msg))
        self.diagnostics = []
        diagnostics = rospy.Subscriber("/diagnostics", DiagnosticArray, self.on_diagnostics)
        self.subscribers += [logs, diagnostics]
        self.wait_for(lambda: logs.get_num_connections() >= 2, "the node's log and our own")
        self.scans = rospy.Publisher("scan", LaserScan, queue_size=10)
        self.initial_poses = rospy.Publisher("initialpose", PoseWithCovarianceStamped, queue_size=1)
        self.maps = rospy.Publisher("map", OccupancyGrid, queue_size=1, latch=True)
        self.broadcaster = tf2_ros.TransformBroadcaster()
        for publisher in [self.scans, self.initial_poses, self.maps]:
            self.wait_for(lambda: publisher.get_num_connections() > 0, "the node")

    def on_diagnostics(self, message):
        self.diagnostics += [status.message for status in message.status if status.level != status.OK]

    def send(self, message, stamp=None):
        message.header.stamp = stamp or rospy.Time.now()
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = "odom", "base_link"
        transform.header.stamp = message.header.stamp
        transform.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(transform)
        self.scans.publish(message)
        rospy.sleep(0.1)

    def wait_for_log(self, text, message=None):
        def seen():
            if message:
                self.send(message)
            return any(text in log for log in self.logs)
        self.wait_for(seen, "'%s' in the log" % text)

    def test_node_says_why_and_lives_on(self):
        empty_map = OccupancyGrid()
        empty_map.header.frame_id = "map"
        self.maps.publish(empty_map)
        self.wait_for_log("Map not used: map size: got 0 x 0 cells")
        self.wait_for_log("waiting for a map on topic /map", scan())
        self.wait_for_log("Laser 'laser' sits at (0.200, 0.000) m, 0.0 deg on 'base_link': "
                          "from robot_description")
        self.maps.publish(room())
        self.wait_for_log("Map of 122 x 82 cells")
        self.initial_poses.publish(initial_pose(X + 0.2, Y - 0.2, YAW + 0.1))

        unknown, nothing, invalid, still, short = (scan() for _ in range(5))
        unknown.header.frame_id = "attic"
        nothing.ranges = []
        invalid.ranges = [float("nan")] * 181
        still.angle_increment = 0.0
        short.range_max = float("nan")
        self.check_dropped(unknown, "neither tf nor robot_description knows where frame 'attic'")
        self.check_dropped(nothing, "scan")
        self.check_dropped(still, "angle_increment")
        self.check_dropped(short, "range_max")

        self.check_covered(invalid)
        self.check_refused(still)
        self.check_pose()
        self.maps.publish(room())  # a new map does not cost the pose
        self.check_pose()

    def check_pose(self):
        self.poses.clear()
        self.wait_for(lambda: self.update() or len(self.poses) >= 10, "poses from good scans")
        _, x, y, yaw = self.poses[-1]
        self.assertLess(math.hypot(x - X, y - Y), 0.1)
        self.assertLess(abs(yaw - YAW), 0.1)

    def update(self):
        """The robot stands still, so scans are used on request only."""
        rospy.ServiceProxy("request_nomotion_update", Empty)()
        self.send(scan())

    def check_covered(self, message):
        """A laser that tells nothing at all: the pose goes on with odometry, and nobody is misled."""
        self.check_pose()
        del self.statuses[:]
        self.wait_for_log("Scan: none of its 181 ranges is valid: the laser is taken to be covered", message)

        def lost():
            rospy.ServiceProxy("request_nomotion_update", Empty)()
            self.send(message)
            return self.statuses and self.statuses[-1].message == "lost"
        self.wait_for(lost, "status 'lost'")
        later = rospy.Time.now() + rospy.Duration(1.0)
        self.wait_for(lambda: self.send(message) or self.tf.can_transform("map", "odom", later),
                      "transforms that go on")

    def check_refused(self, message):
        """Diagnostics say so while nothing else comes."""
        del self.diagnostics[:]
        self.wait_for(lambda: self.send(message) or any("angle_increment" in text for text in self.diagnostics),
                      "the reason in /diagnostics")

    def check_dropped(self, message, reason):
        """The warning is throttled: it is sent until it is said."""
        self.logs.clear()
        self.wait_for_log(reason, message)
        self.assertIn("Scan dropped", [log for log in self.logs if reason in log][0])


if __name__ == "__main__":
    rospy.init_node("bad_messages_test")
    rostest.rosrun("adaptive_localization", "bad_messages", BadMessages, sys.argv)
