#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a swarm shows: its bats, and its leaders, which are gone with the swarm."""
import sys

import rospy
import rostest
from dynamic_reconfigure.client import Client
from geometry_msgs.msg import PoseArray
from localization_case import AT_LAST, LocalizationCase, planar

NODE = "adaptive_localization"


class Swarm(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.leaders = []
        self.clouds = []
        self.subscribers.append(
            rospy.Subscriber(NODE + "/leaders", PoseArray, self.leaders.append))
        self.subscribers.append(rospy.Subscriber("particlecloud", PoseArray, self.clouds.append))
        self.client = Client(NODE, timeout=AT_LAST)
        self.wait_for(lambda: self.is_accurate(0.0), "the robot to be tracked")

    def tearDown(self):
        self.client.update_configuration({"restore_defaults": True})
        self.client.close()
        super().tearDown()

    def latched_leaders(self):
        """What somebody gets who comes later."""
        return rospy.wait_for_message(NODE + "/leaders", PoseArray, AT_LAST).poses

    def test_bats_and_leaders_are_shown(self):
        self.client.update_configuration({"swarm_size": 300, "leaders_per_bats": 30})
        self.wait_for(lambda: self.leaders and len(self.leaders[-1].poses) == 10, "ten leaders")
        self.wait_for(lambda: self.clouds and len(self.clouds[-1].poses) == 300, "300 bats")
        leaders = self.leaders[-1]
        self.assertEqual(leaders.header.frame_id, "map")
        clouds = [set(map(planar, cloud.poses)) for cloud in self.clouds]
        self.assertTrue(any(set(map(planar, leaders.poses)) <= cloud for cloud in clouds))

    def test_leaders_are_gone_with_the_swarm(self):
        self.wait_for(lambda: self.leaders and self.leaders[-1].poses, "leaders")
        self.client.update_configuration({"filter": "sa_kld"})
        self.wait_for(lambda: not self.leaders[-1].poses, "no leaders")
        self.assertEqual(self.latched_leaders(), [])
        count, poses = len(self.leaders), len(self.poses)
        self.wait_for(lambda: len(self.poses) > poses + 3, "more poses")
        self.assertEqual(len(self.leaders), count)
        self.client.update_configuration({"filter": "lbba"})
        self.wait_for(lambda: self.leaders[-1].poses, "leaders again")


if __name__ == "__main__":
    rospy.init_node("swarm_test")
    rostest.rosrun("adaptive_localization", "swarm", Swarm, sys.argv)
