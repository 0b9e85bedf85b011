#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What p3dx.launch sends on tf where the drivers run elsewhere: the laser's place, once."""
import math
import sys
import time
import unittest

import rospy
import rostest
from tf2_msgs.msg import TFMessage


class P3dx(unittest.TestCase):
    def test_place_of_the_laser_is_sent_once_and_as_told(self):
        transforms = []
        rospy.Subscriber("/tf_static", TFMessage, lambda m: transforms.extend(m.transforms))
        end = time.time() + 20
        while not transforms and time.time() < end:
            time.sleep(0.1)
        time.sleep(2.0)  # for whoever else would send it
        lasers = [t for t in transforms if t.child_frame_id == "laser"]
        self.assertEqual(len(lasers), 1, transforms)
        self.assertEqual(lasers[0].header.frame_id, "base_link")
        place = lasers[0].transform
        self.assertAlmostEqual(place.translation.x, 0.1)
        self.assertAlmostEqual(place.translation.y, -0.02)
        self.assertAlmostEqual(place.translation.z, 0.4)
        self.assertAlmostEqual(2 * math.atan2(place.rotation.z, place.rotation.w), 0.5)


if __name__ == "__main__":
    rospy.init_node("p3dx_test")
    rostest.rosrun("adaptive_localization", "p3dx", P3dx, sys.argv)
