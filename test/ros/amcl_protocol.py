# SPDX-License-Identifier: BSD-3-Clause
"""The parts of amcl's test protocol: programs, a drive, a robot with two lasers."""
import collections
import copy
import math
import subprocess

import roslib.packages
import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped, Twist
from localization_case import AT_LAST, planar, wrap
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

PACKAGE = "adaptive_localization"


class Programs:
    """Starts programs of the package and ends them."""

    def __init__(self):
        self.running = []

    def start(self, program, *arguments, **parameters):
        path = roslib.packages.find_node(PACKAGE, program)[0]
        given = ["_%s:=%s" % item for item in parameters.items()]
        self.running.append(subprocess.Popen([path] + list(arguments) + given))
        return self.running[-1]

    def end(self):
        for process in reversed(self.running):
            process.terminate()
        for process in self.running:
            process.wait(AT_LAST)


class Drive:
    """Drives from way-point to way-point by cmd_vel, knowing the truth, and notes once a simulated
    second where the robot is."""

    MAX_SPEED, MAX_TURN = 0.8, 1.0  # m/s, rad/s
    REACHED = 0.3  # m
    NOTE_EVERY = 1.0  # s
    STUCK = 4.0  # s

    def __init__(self, route):
        self.route = collections.deque(route)
        self.reached = None  # the last way-point, or where it started
        self.now = None  # (stamp, x, y, yaw)
        self.notes = []
        self.travelled = 0.0
        self.moved = None  # (stamp, x, y, yaw) when it last was elsewhere
        self.command = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        self.subscriber = rospy.Subscriber("base_pose_ground_truth", Odometry, self.on_truth)

    def end(self):
        self.subscriber.unregister()

    def on_truth(self, message):
        now = (message.header.stamp.to_sec(),) + planar(message.pose.pose)
        self.reached = self.reached or now[1:3]
        if self.now:
            self.travelled += math.dist(now[1:3], self.now[1:3])
        if not self.notes or now[0] >= self.notes[-1][0] + self.NOTE_EVERY:
            self.notes.append(now)
        self.now = now
        if self.route and math.dist(self.route[0], now[1:3]) < self.REACHED:
            self.reached = self.route.popleft()
        if self.route and self.reached != self.route[0] and self.is_stuck(now):
            self.route.appendleft(self.reached)  # from there the way is free
        self.command.publish(self.steer(now))

    def is_stuck(self, now):
        """Where this process is slow its commands come late, and the robot may end at a wall."""
        if not self.moved or math.dist(self.moved[1:3], now[1:3]) > 0.1 or \
                abs(wrap(self.moved[3] - now[3])) > 0.2:
            self.moved = now
        return now[0] > self.moved[0] + self.STUCK

    def steer(self, now):
        twist = Twist()
        if self.route:
            x, y = self.route[0]
            aside = wrap(math.atan2(y - now[2], x - now[1]) - now[3])
            twist.angular.z = max(-self.MAX_TURN, min(self.MAX_TURN, 2.0 * aside))
            twist.linear.x = self.MAX_SPEED * max(0.0, math.cos(aside)) ** 3
        return twist


class TwoLasers:
    """Makes two lasers of one: what lies to the right goes out in one frame and what lies to the
    left in another, both on topic 'scan' with the same stamps."""

    MOUNT = (0.021, 0.0, 0.3)  # m; of the one laser

    def __init__(self):
        self.broadcaster = tf2_ros.StaticTransformBroadcaster()
        self.broadcaster.sendTransform([self.mount("laser_right", -math.pi / 2),
                                        self.mount("laser_left", math.pi / 2)])
        self.publisher = rospy.Publisher("scan", LaserScan, queue_size=100)
        self.subscriber = rospy.Subscriber("whole_scan", LaserScan, self.on_scan)

    def end(self):
        self.subscriber.unregister()

    def mount(self, frame, yaw):
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = "base_link", frame
        translation, rotation = transform.transform.translation, transform.transform.rotation
        translation.x, translation.y, translation.z = self.MOUNT
        rotation.z, rotation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        return transform

    def on_scan(self, whole):
        middle = len(whole.ranges) // 2
        for frame, begin, end, yaw in [("laser_right", 0, middle, -math.pi / 2),
                                       ("laser_left", middle, len(whole.ranges), math.pi / 2)]:
            part = copy.copy(whole)
            part.header = copy.copy(whole.header)
            part.header.frame_id = frame
            part.angle_min = whole.angle_min + begin * whole.angle_increment - yaw
            part.angle_max = part.angle_min + (end - begin - 1) * whole.angle_increment
            part.ranges = whole.ranges[begin:end]
            self.publisher.publish(part)
