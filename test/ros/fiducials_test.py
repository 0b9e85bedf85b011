#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A robot stands before three markers, whose picture is computed here. The node fiducials tells
where they are, and the robot, which has no laser, knows by them alone where it is. Pictures that
cannot be read are named and dropped."""
import math
import os
import subprocess
import sys

import roslib.packages
import rospkg
import rospy
import rostest
import tf2_ros
import yaml
from localization_case import AT_LAST, LocalizationCase, wrap
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import CameraInfo, Image, PointCloud
from std_srvs.srv import Empty
from toy_robot import transform

ROBOT = (7.0, 2.0, 1.4)  # in the map: m, m, rad
MOUNT = (0.2, 0.0, 0.4)  # of the camera, which looks ahead, m
HEIGHT = 0.7  # of the markers, m
SIDE = 0.15  # of their black squares, m
COLUMNS, ROWS, FOCAL = 640, 480, 500.0  # px
CELLS = 6  # along a side, black margins and all
CODES = {0: "1011010100110010", 1: "0000111110011010", 2: "0011001100101101"}  # DICT_4X4_50
WALL, BLACK, WHITE = 120, 30, 220


def landmarks():
    """(x, y) in the map, by id."""
    path = os.path.join(rospkg.RosPack().get_path("adaptive_localization"),
                        "test/ros/fiducials.yaml")
    with open(path) as file:
        return {entry["id"]: entry["at"] for entry in yaml.safe_load(file)["landmarks"]}


def in_camera(place):
    """(right, down, ahead), m."""
    x, y = place[0] - ROBOT[0], place[1] - ROBOT[1]
    c, s = math.cos(ROBOT[2]), math.sin(ROBOT[2])
    return s * x - c * y, MOUNT[2] - HEIGHT, c * x + s * y - MOUNT[0]


def grey_of(code, column, row):
    """At a place on a marker that faces the camera, in cells from its corner; none beside it."""
    if not (-1 < column < CELLS + 1 and -1 < row < CELLS + 1):
        return None
    if not (0 <= column < CELLS and 0 <= row < CELLS):
        return WHITE
    i, j = int(column) - 1, int(row) - 1
    is_code = 0 <= i < CELLS - 2 and 0 <= j < CELLS - 2
    return WHITE if is_code and code[(CELLS - 2) * j + i] == "1" else BLACK


def draw(pixels, code, centre):
    """Each pixel is the mean of 4 x 4 of its points."""
    right, down, ahead = centre
    scale = FOCAL / ahead  # px per m
    u, v = (COLUMNS - 1) / 2 + scale * right, (ROWS - 1) / 2 + scale * down
    cell = scale * SIDE / CELLS
    reach = int(cell * CELLS) + 2
    for y in range(int(v) - reach, int(v) + reach):
        for x in range(int(u) - reach, int(u) + reach):
            total = 0
            for k in range(16):
                column = (x + (k % 4 - 1.5) / 4 - u) / cell + CELLS / 2
                row = (y + (k // 4 - 1.5) / 4 - v) / cell + CELLS / 2
                grey = grey_of(code, column, row)
                total += pixels[y * COLUMNS + x] if grey is None else grey
            pixels[y * COLUMNS + x] = total // 16


def image(pixels, channels=1):
    message = Image()
    message.width, message.height, message.step = COLUMNS, ROWS, COLUMNS * channels
    message.encoding = "mono8" if channels == 1 else "bgr8"
    message.data = bytes(p for p in pixels for _ in range(channels))
    return message


def picture(places):
    pixels = bytearray([WALL] * (COLUMNS * ROWS))
    for identity, place in places.items():
        draw(pixels, CODES[identity], in_camera(place))
    return pixels


PICTURE = picture(landmarks())


def camera_info():
    message = CameraInfo()
    message.width, message.height = COLUMNS, ROWS
    message.distortion_model = "plumb_bob"
    message.D = [0.0] * 5
    message.K = [FOCAL, 0, (COLUMNS - 1) / 2, 0, FOCAL, (ROWS - 1) / 2, 0, 0, 1]
    return message


class Fiducials(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.seen, self.logs = {}, []  # by stamp
        self.subscribers += [
            rospy.Subscriber("landmarks", PointCloud, self.on_landmarks),
            rospy.Subscriber("/rosout", Log, lambda log: self.logs.append(log.msg))]
        self.images = rospy.Publisher("camera/image_raw", Image, queue_size=1)
        self.infos = rospy.Publisher("camera/camera_info", CameraInfo, queue_size=1)
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.fixed = tf2_ros.StaticTransformBroadcaster()
        mount = transform("base_link", "camera", MOUNT[:2] + (0.0,), rospy.Time.now())
        mount.transform.translation.z = MOUNT[2]
        turn = mount.transform.rotation
        turn.x, turn.y, turn.z, turn.w = -0.5, 0.5, -0.5, 0.5  # to right, down and ahead
        self.fixed.sendTransform(mount)

    def tearDown(self):
        super().tearDown()
        for publisher in [self.images, self.infos, self.broadcaster.pub_tf, self.fixed.pub_tf]:
            publisher.unregister()

    def on_landmarks(self, message):
        self.seen[message.header.stamp] = message

    def show(self, message, info=None, frame="camera"):
        """Sends a picture of now, with the odometry of a robot that stands."""
        stamp = rospy.Time.now()
        self.broadcaster.sendTransform(transform("odom", "base_link", (0.0, 0.0, 0.0), stamp))
        message.header.frame_id, message.header.stamp = frame, stamp
        self.infos.publish(info or camera_info())
        self.images.publish(message)
        return stamp

    def sightings_of(self, message):
        """Shows a picture again and again until there is an answer to it."""
        shown = []

        def is_answered():
            shown.append(self.show(message))
            return next((self.seen[stamp] for stamp in shown if stamp in self.seen), None)

        return self.wait_for(is_answered, "an answer to a picture", pause=0.2)

    def check_sightings(self, message):
        self.assertEqual(message.header.frame_id, "camera")
        self.assertEqual([channel.name for channel in message.channels],
                         ["id", "range_std", "bearing_std"])
        ids, range_stds, bearing_stds = [channel.values for channel in message.channels]
        self.assertEqual(sorted(ids), [0, 1, 2])
        for identity, point, range_std, bearing_std in zip(ids, message.points, range_stds,
                                                           bearing_stds):
            right, _, ahead = in_camera(landmarks()[int(identity)])
            distance = math.hypot(right, ahead)
            self.assertLess(abs(math.hypot(point.x, point.z) - distance), 0.02 * distance)
            self.assertLess(abs(math.atan2(point.x, point.z) - math.atan2(right, ahead)), 2e-3)
            self.assertTrue(0.02 < range_std < 0.1, range_std)
            self.assertTrue(0.02 / distance - 1e-4 < bearing_std < 0.02, bearing_std)

    def test_1_markers_are_sighted(self):
        self.check_sightings(self.sightings_of(image(PICTURE)))
        self.check_sightings(self.sightings_of(image(PICTURE, channels=3)))

    def test_2_none_in_sight_is_told(self):
        message = self.sightings_of(image(picture({})))
        self.assertEqual(len(message.points), 0)
        self.assertEqual([(channel.name, len(channel.values)) for channel in message.channels],
                         [("id", 0), ("range_std", 0), ("bearing_std", 0)])

    def test_3_they_localize_the_robot(self):
        update = rospy.ServiceProxy("request_nomotion_update", Empty)  # it stands
        update.wait_for_service()

        def is_known():
            update()
            self.show(image(PICTURE))
            if self.status() != "tracking" or not self.poses:
                return False
            _, x, y, yaw = self.poses[-1]
            off = math.hypot(x - ROBOT[0], y - ROBOT[1])
            turned = abs(math.degrees(wrap(yaw - ROBOT[2])))
            print("%.0f mm and %.1f degrees off" % (1e3 * off, turned))
            return off < 0.05 and turned < 2.0

        self.wait_for(is_known, "the robot where it stands", pause=0.2)
        self.assertEqual(self.status_values()["landmarks"], "used")

    def check_refusal(self, text, message, info=None, frame="camera"):
        """The node says what is wrong, and looks at the next picture."""
        known = len(self.logs)

        def is_refused():
            self.show(message, info, frame)
            return any(text in log for log in self.logs[known:])

        self.wait_for(is_refused, "'%s' in the log" % text, pause=0.2)
        stamp = self.show(message, info, frame)
        self.check_sightings(self.sightings_of(image(PICTURE)))
        self.assertNotIn(stamp, self.seen)

    def test_4_pictures_that_cannot_be_read_are_named_and_dropped(self):
        self.check_sightings(self.sightings_of(image(PICTURE)))
        bayer = image(PICTURE)
        bayer.encoding = "bayer_rggb8"
        self.check_refusal("encoding of an image: got 'bayer_rggb8', expected mono8", bayer)
        short = image(PICTURE)
        short.data = short.data[:-1]
        self.check_refusal("bytes of an image: got 307199, expected at least 307200", short)
        small = image(PICTURE)
        small.width, small.height = 320, 240
        self.check_refusal("got 320 x 240 pixels, expected 640 x 480", small)
        nothing = Image()
        nothing.encoding = "mono8"
        self.check_refusal("size of an image: got 0 x 0", nothing)
        self.check_refusal("tf does not know how frame 'nowhere' lies", image(PICTURE),
                           frame="nowhere")

    def test_5_a_camera_that_is_not_calibrated_is_named(self):
        self.check_sightings(self.sightings_of(image(PICTURE)))
        self.check_refusal("focal length in camera_info's K: got 0, expected one above 0",
                           image(PICTURE), CameraInfo(width=COLUMNS, height=ROWS))
        info = camera_info()
        info.K = [math.nan] * 9
        self.check_refusal("focal length in camera_info's K: got nan", image(PICTURE), info)
        info = camera_info()
        info.distortion_model = "equidistant"
        self.check_refusal("distortion_model of camera_info: got 'equidistant'", image(PICTURE),
                           info)

    def test_6_a_parameter_that_cannot_be_is_named_at_the_start(self):
        program = roslib.packages.find_node("adaptive_localization", "fiducials")[0]
        for argument, text in [("_dictionary:=DICT_3X3", "'dictionary': got 'DICT_3X3', expected"),
                               ("_marker_size:=-1", "'marker_size': got '-1', expected")]:
            run = subprocess.run([program, "__name:=refused", argument], stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, timeout=AT_LAST, check=False)
            rospy.delete_param("/refused")
            self.assertEqual(run.returncode, 1)
            self.assertIn(text, run.stdout.decode())


if __name__ == "__main__":
    rospy.init_node("fiducials_test")
    rostest.rosrun("adaptive_localization", "fiducials_test", Fiducials, sys.argv)
