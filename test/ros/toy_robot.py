# SPDX-License-Identifier: BSD-3-Clause
"""A robot without a simulator: transforms, scans and the map of an L-shaped room are computed and
published by the test, with stamps of its own choice. It does not go on before the node has answered
a scan, so that a test is quick and exact, whatever the machine has to do besides."""
import math
import time

import rospy
import tf2_ros
from geometry_msgs.msg import PoseArray, PoseWithCovarianceStamped, TransformStamped
from diagnostic_msgs.msg import DiagnosticArray
from localization_case import LocalizationCase, initial_pose, stamp_of
from nav_msgs.msg import OccupancyGrid
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

CORNERS = [(0, 0), (8, 0), (8, 3), (3, 3), (3, 6), (0, 6)]  # m
RESOLUTION = 0.05


def inside(x, y):
    return 0 < x < 8 and 0 < y < 3 or 0 < x < 3 and 0 < y < 6


def room(frame="map"):
    """The room with walls in the middle of cells."""
    grid = OccupancyGrid()
    grid.header.frame_id = frame
    grid.info.resolution, grid.info.width, grid.info.height = RESOLUTION, 165, 125
    grid.info.origin.position.x = grid.info.origin.position.y = -2.5 * RESOLUTION
    grid.info.origin.orientation.w = 1.0
    grid.data = [0 if inside((i - 2) * RESOLUTION, (j - 2) * RESOLUTION) else 100
                 for j in range(125) for i in range(165)]
    return grid


def distance_to_wall(x, y, yaw):
    c, s = math.cos(yaw), math.sin(yaw)
    nearest = 30.0
    for (x1, y1), (x2, y2) in zip(CORNERS, CORNERS[1:] + CORNERS[:1]):
        if x1 == x2 and abs(c) > 1e-9:
            r = (x1 - x) / c
            if 0 < r < nearest and min(y1, y2) <= y + r * s <= max(y1, y2):
                nearest = r
        elif y1 == y2 and abs(s) > 1e-9:
            r = (y1 - y) / s
            if 0 < r < nearest and min(x1, x2) <= x + r * c <= max(x1, x2):
                nearest = r
    return nearest


def compose(a, b):
    c, s = math.cos(a[2]), math.sin(a[2])
    return (a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2])


def transform(parent, child, pose, stamp):
    message = TransformStamped()
    message.header.frame_id, message.child_frame_id = parent, child
    message.header.stamp = stamp
    message.transform.translation.x, message.transform.translation.y = pose[0], pose[1]
    message.transform.rotation.z = math.sin(pose[2] / 2)
    message.transform.rotation.w = math.cos(pose[2] / 2)
    return message


class ToyRobotCase(LocalizationCase):
    """The robot stands at `pose` in the map; its odometry says `odometry`."""

    MOUNT = (0.2, 0.0, 0.0)
    view = math.pi  # of the laser, rad
    MOST_LOST = 2  # scans: after a jump of time, or before a node listens that was started anew

    def setUp(self):
        super().setUp()
        self.pose = (1.5, 1.0, 0.3)
        self.odometry = (0.0, 0.0, 0.0)
        self.time = rospy.Time(rospy.Time.now().secs)
        self.way = {}  # where the robot was, by stamp
        self.lost = 0  # scans without an answer
        self.logs, self.clouds, self.corrections, self.diagnostics = [], [], [], []
        self.subscribers += [
            rospy.Subscriber("/rosout", Log, lambda log: self.logs.append(log.msg)),
            rospy.Subscriber("particlecloud", PoseArray, self.clouds.append),
            rospy.Subscriber("/tf", TFMessage, self.on_tf),
            rospy.Subscriber("/diagnostics", DiagnosticArray, self.diagnostics.append)]
        self.maps = rospy.Publisher("map", OccupancyGrid, queue_size=1, latch=True)
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.static_broadcaster = tf2_ros.StaticTransformBroadcaster()
        self.static_broadcaster.sendTransform(
            transform("base_link", "laser", self.MOUNT, rospy.Time.now()))
        self.publishers = [self.maps, self.broadcaster.pub_tf, self.static_broadcaster.pub_tf]
        self.scans = self.publisher("scan", LaserScan)
        self.initial_poses = self.publisher("initialpose", PoseWithCovarianceStamped)
        heard = [s for s in self.subscribers if isinstance(s, rospy.Subscriber)]
        for topic in self.publishers + heard:
            if topic.name != "/base_pose_ground_truth":  # nobody knows it but we
                self.wait_for_connections(topic)

    def tearDown(self):
        """A node that is started next gets none of this."""
        super().tearDown()
        for publisher in self.publishers:
            publisher.unregister()

    def publisher(self, topic, kind):
        publisher = rospy.Publisher(topic, kind, queue_size=100)
        self.publishers.append(publisher)
        return publisher

    def wait_for_connections(self, topic):
        """To the node, and to ourselves where we listen to what we publish."""
        ours = ["/tf", "/tf_static", "/rosout"]
        self.wait_for(lambda: topic.get_num_connections() >= 1 + (topic.name in ours),
                      "the node on " + topic.name)

    def on_tf(self, message):
        self.corrections += [t for t in message.transforms if t.header.frame_id == "map"]

    def scan_message(self, mount=None, frame="laser", beams=181):
        message = LaserScan()
        message.header.frame_id, message.header.stamp = frame, self.time
        message.angle_min, message.angle_max = -self.view / 2, self.view / 2
        message.angle_increment = self.view / (beams - 1)
        message.range_max = 20.0
        x, y, yaw = compose(self.pose, mount or self.MOUNT)
        message.ranges = [distance_to_wall(x, y, yaw + message.angle_min + i * message.angle_increment)
                          for i in range(beams)]
        return message

    def send_odometry(self):
        self.broadcaster.sendTransform(transform("odom", "base_link", self.odometry, self.time))

    def move(self, motion=(0.0, 0.0, 0.0), seconds=0.1):
        self.time += rospy.Duration(seconds)
        self.pose = compose(self.pose, motion)
        self.odometry = compose(self.odometry, motion)
        self.way[round(self.time.to_sec(), 3)] = self.pose

    def step(self, motion=(0.0, 0.0, 0.0), seconds=0.1):
        """Moves, sends odometry and a scan, and waits for all that the node answers."""
        self.move(motion, seconds)
        received = [len(messages) for messages in self.answers()]
        sent = self.send()

        def is_answered():
            nonlocal sent
            if time.time() > sent + 3.0 and self.MOST_LOST > 0:
                self.lost += 1
                self.assertLessEqual(self.lost, self.MOST_LOST, "scans without an answer")
                self.move()
                sent = self.send()
            return self.has_answered(received, seconds > 0.0)

        self.wait_for(is_answered, "the answer to a scan", pause=0.002)

    def send(self):
        """Odometry and scan; returns when, s of real time."""
        self.send_odometry()
        self.scans.publish(self.scan_message())
        return time.time()

    def answers(self):
        return self.statuses, self.corrections, self.poses, self.clouds

    def has_answered(self, received, is_new):
        """Each scan is answered by a status, which says whether a pose comes with it; a new stamp
        by a transform as well, once the robot is somewhere."""
        statuses, corrections, poses, clouds = [
            len(now) - before for now, before in zip(self.answers(), received)]
        if statuses == 0 or abs(stamp_of(self.statuses[-1]) - self.time.to_sec()) > 1e-6:
            return False
        is_updated = self.status_values()["updated"] == "yes"
        is_placed = is_new and self.status() != "uninitialised"
        return corrections >= is_placed and poses >= is_updated and clouds >= is_updated

    def steps(self, count, motion=(0.0, 0.0, 0.0)):
        for _ in range(count):
            self.step(motion)

    def localize(self):
        """The node gets the map and is told where the robot is; then it knows of other places."""
        self.maps.publish(room())
        self.wait_for_log("Map of")
        self.initial_poses.publish(initial_pose(*self.pose))
        self.wait_for_log("Initial pose")
        self.step()
        self.wait_for_log("Energy grid ready")

    def forget(self):
        """Forgets what was received."""
        for messages in [self.poses, self.clouds, self.corrections, self.logs, self.diagnostics]:
            messages.clear()

    def logged(self, text):
        return [log for log in self.logs if text in log]

    def wait_for_log(self, text):
        self.wait_for(lambda: self.logged(text), "'%s' in the log" % text)

    def diagnostic(self, what):
        """The newest status of this name, as (level, message, values)."""
        for array in reversed(self.diagnostics):
            for status in array.status:
                if status.name == "adaptive_localization: " + what:
                    return status.level, status.message, {v.key: v.value for v in status.values}
        return None

    def error(self):
        """Metres from the last pose to where the robot was then."""
        stamp, x, y, _ = self.poses[-1]
        truth = self.way[round(stamp, 3)]
        return math.hypot(x - truth[0], y - truth[1])
