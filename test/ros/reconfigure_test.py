#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Options change through dynamic_reconfigure while the simulated robot drives."""
import math
import os
import signal
import subprocess
import sys
import tempfile

import roslib.packages
import rospy
import rostest
from dynamic_reconfigure import DynamicReconfigureParameterException
from dynamic_reconfigure.client import Client
from geometry_msgs.msg import PoseArray
from localization_case import AT_LAST, LocalizationCase, wrap, yaw_of
from tf2_msgs.msg import TFMessage

NODE = "adaptive_localization"
AMCL_FIELDS = """use_map_topic first_map_only gui_publish_rate save_pose_rate laser_min_range
    laser_max_range laser_max_beams min_particles max_particles kld_err kld_z odom_alpha1 odom_alpha2
    odom_alpha3 odom_alpha4 odom_alpha5 do_beamskip beam_skip_distance beam_skip_threshold
    laser_z_hit laser_z_short laser_z_max laser_z_rand laser_sigma_hit laser_lambda_short
    laser_likelihood_max_dist laser_model_type odom_model_type update_min_d update_min_a
    odom_frame_id base_frame_id global_frame_id resample_interval transform_tolerance
    recovery_alpha_slow recovery_alpha_fast tf_broadcast force_update_after_initialpose
    force_update_after_set_map restore_defaults""".split()


class Reconfigure(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.corrections = []  # (stamp, x, y, yaw) of map -> odom
        self.subscribers.append(rospy.Subscriber("/tf", TFMessage, self.on_tf))
        self.subscribers.append(rospy.Subscriber("particlecloud", PoseArray, self.on_cloud))
        self.clouds = []  # their sizes
        self.client = Client(NODE, timeout=AT_LAST)
        self.at_start = self.client.get_configuration(timeout=AT_LAST)
        self.wait_for(lambda: self.is_accurate(0) and self.clouds, "the robot to be tracked")
        self.since = rospy.get_time()

    def tearDown(self):
        self.set(restore_defaults=True)
        self.client.close()
        super().tearDown()

    def on_tf(self, message):
        for t in message.transforms:
            if t.header.frame_id == "map":
                moved, turned = t.transform.translation, yaw_of(t.transform.rotation)
                self.corrections.append((t.header.stamp.to_sec(), moved.x, moved.y, turned))

    def on_cloud(self, message):
        self.clouds.append(len(message.poses))

    def set(self, **values):
        """The configuration that the node answers with."""
        return self.client.update_configuration(values)

    def wait_for_value(self, name, value):
        self.wait_for_param(name, lambda found: found == value)

    def jumps(self):
        """How far each new transform moves the robot, in m and rad."""
        for (_, *old), (stamp, *new) in zip(self.corrections, self.corrections[1:]):
            truth = self.truth_at(stamp)
            if truth and stamp > self.since:
                turned = wrap(new[2] - old[2])
                x, y = truth[0] - old[0], truth[1] - old[1]
                moved = (new[0] + math.cos(turned) * x - math.sin(turned) * y,
                         new[1] + math.sin(turned) * x + math.cos(turned) * y)
                yield math.dist(moved, truth[:2]), abs(turned)

    def expect_smooth_tracking(self, seconds):
        """Goes on for so long; since the test began the pose is right and nothing jumped."""
        clouds, poses = len(self.clouds), len(self.poses)
        end = rospy.get_time() + seconds
        self.wait_for_answers(seconds)
        self.wait_for(lambda: self.corrections[-1][0] >= end, "the transforms")
        self.wait_for(lambda: len(self.poses) > poses and len(self.clouds) > clouds, "poses")
        for _, metres, degrees in self.errors(self.since):
            self.assertLess(metres, 0.1)
            self.assertLess(degrees, 4.0)
        jumps = list(self.jumps())
        self.assertGreater(len(jumps), 5)
        for metres, turned in jumps:
            self.assertLess(metres, 0.08)
            self.assertLess(turned, math.radians(6))
        self.assertEqual(self.status(), "tracking")

    def test_fields_of_amcl_exist(self):
        self.assertEqual(len(AMCL_FIELDS), 41)
        described = {p["name"] for p in self.client.get_parameter_descriptions(timeout=AT_LAST)}
        self.assertEqual([f for f in AMCL_FIELDS if f not in self.at_start], [])
        self.assertEqual(described, set(self.at_start) - {"groups"})
        self.assertIn("filter", described)
        self.assertNotIn("initial_pose_x", described)

    def test_values_are_those_that_the_node_runs_with(self):
        self.assertEqual(self.at_start["max_particles"], 50000)
        self.assertEqual(self.at_start["laser_z_hit"], 1.0)
        self.assertEqual(self.at_start["recovery_alpha_slow"], 0.001)
        self.assertEqual(self.at_start["laser_max_beams"], 180)
        for field in AMCL_FIELDS:
            self.wait_for_value(NODE + "/" + field, self.at_start[field])

    def test_options_change_while_the_robot_is_tracked(self):
        self.expect_smooth_tracking(4)
        answer = self.set(laser_max_beams=40, max_particles=300, min_particles=200)
        self.assertEqual(answer["laser_max_beams"], 40)
        self.wait_for(lambda: self.clouds[-1] <= 300, "a smaller cloud")
        self.wait_for_value(NODE + "/max_particles", 300)
        self.expect_smooth_tracking(6)
        for core in ["mcl", "kld", "amcl", "samcl", "sa_kld"]:
            self.assertEqual(self.set(filter=core)["filter"], core)
            self.expect_smooth_tracking(5)
        self.set(laser_model_type="beam", odom_model_type="omni-corrected")
        self.expect_smooth_tracking(5)

    def test_another_core_has_its_own_presets(self):
        self.assertEqual(self.set(min_particles=400)["max_particles"], 50000)
        answer = self.set(filter="amcl", preset="seed")
        self.assertEqual(answer["resample_interval"], 2)
        self.assertEqual(answer["min_particles"], 400)
        answer = self.set(preset="recommended", resample_interval=2)
        self.assertEqual(answer["resample_interval"], 2)
        self.assertEqual(answer["kld_z"], self.at_start["kld_z"])

    def test_transform_tolerance_and_broadcast_change(self):
        self.set(tf_broadcast=False)
        self.wait_for_answers(1)
        count = len(self.corrections)
        self.wait_for_answers(2)
        self.assertEqual(len(self.corrections), count)
        self.set(tf_broadcast=True, transform_tolerance=2.0)
        self.wait_for(lambda: len(self.corrections) > count, "the transform")
        scan = self.corrections[-1][0] - 2.0
        self.wait_for(lambda: [stamp for stamp, _ in self.words(scan - 0.01)
                               if abs(stamp - scan) < 1e-6], "the scan of this transform")

    def test_wrong_values_do_no_harm(self):
        before = self.client.get_configuration()
        answer = self.set(laser_max_beams=-5, laser_z_hit=3.5, transform_tolerance=float("inf"))
        self.assertEqual(answer["laser_max_beams"], 2)
        self.assertEqual(answer["laser_z_hit"], 1.0)
        self.assertEqual(answer["transform_tolerance"], 60.0)
        self.set(restore_defaults=True)
        for wrong in [{"filter": "mlc"}, {"laser_model_type": "radar"}, {"kld_z": float("nan")},
                      {"confidence_low_inliers": 0.9}]:
            wrong["max_particles"] = 400
            answer = self.set(**wrong)
            self.assertEqual(answer["max_particles"], before["max_particles"], wrong)
            for key in wrong:
                self.assertEqual(answer[key], before[key])
        for unknown in ["no_such_field", "plugins", "cache_dir", "line_map", "pose_file"]:
            with self.assertRaises(DynamicReconfigureParameterException):
                self.set(**{unknown: "/nowhere.so"})
        answer = self.set(max_particles=100)  # below min_particles
        self.assertEqual(answer["max_particles"], answer["min_particles"])
        self.expect_smooth_tracking(2)

    def test_restore_defaults_goes_back_to_the_start(self):
        self.set(filter="mcl", odom_alpha1=0.7, max_particles=700, save_pose_rate=-1.0)
        answer = self.set(restore_defaults=True)
        self.assertFalse(answer["restore_defaults"])
        for key, value in self.at_start.items():
            if key != "groups":
                self.assertEqual(answer[key], value, key)

    def test_only_what_was_given_or_set_outlives_the_node(self):
        # Where no scans are: it would localize the same robot, and keep its pose as well.
        rospy.set_param("apart/other", {"odom_alpha1": 0.5})
        program = roslib.packages.find_node(NODE, NODE)[0]
        node = subprocess.Popen([program, "__name:=other", "__ns:=apart"],
                                stdout=subprocess.DEVNULL)
        try:
            client = Client("apart/other", timeout=AT_LAST)
            client.update_configuration({"filter": "mcl", "laser_max_beams": 60})
            self.wait_for_value("apart/other/max_particles", 2000)
            client.close()
        finally:
            node.send_signal(signal.SIGINT)
            self.assertEqual(node.wait(AT_LAST), 0)
        self.assertEqual(rospy.get_param("apart/other"),
                         {"odom_alpha1": 0.5, "filter": "mcl", "laser_max_beams": 60})

    def test_command_line_client_works(self):
        def dynparam(*arguments):
            command = ["rosrun", "dynamic_reconfigure", "dynparam", *arguments]
            return subprocess.run(command, timeout=AT_LAST, check=True,
                                  stdout=subprocess.PIPE).stdout.decode()

        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "dump.yaml")
            self.set(filter="kld", max_particles=20000, odom_alpha1=0.33)
            dynparam("dump", NODE, path)
            self.set(restore_defaults=True)
            dynparam("load", NODE, path)
        answer = dynparam("get", NODE)
        for expected in ["'filter': 'kld'", "'max_particles': 20000", "'odom_alpha1': 0.33"]:
            self.assertIn(expected, answer)


if __name__ == "__main__":
    rospy.init_node("reconfigure_test")
    rostest.rosrun("adaptive_localization", "reconfigure", Reconfigure, sys.argv)
