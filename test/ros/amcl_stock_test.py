#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A launch file for amcl in which one word was changed: the node localizes, complains about nothing
and shows the same names to rosnode, rostopic, rosservice and rosparam as amcl does."""
import sys

import rosgraph
import rospy
import rostest
from geometry_msgs.msg import PoseArray, PoseWithCovarianceStamped
from localization_case import AT_LAST, LocalizationCase
from rosgraph_msgs.msg import Log

# What 'rosnode info' of a running amcl lists, and the types.
PUBLISHED = {
    "/amcl_pose": "geometry_msgs/PoseWithCovarianceStamped",
    "/particlecloud": "geometry_msgs/PoseArray",
    "/tf": "tf2_msgs/TFMessage",
    "/diagnostics": "diagnostic_msgs/DiagnosticArray",
    "/amcl/parameter_descriptions": "dynamic_reconfigure/ConfigDescription",
    "/amcl/parameter_updates": "dynamic_reconfigure/Config",
    "/rosout": "rosgraph_msgs/Log",
}
SUBSCRIBED = {
    "/scan": "sensor_msgs/LaserScan",
    "/initialpose": "geometry_msgs/PoseWithCovarianceStamped",
    "/tf": "tf2_msgs/TFMessage",
    "/tf_static": "tf2_msgs/TFMessage",
    "/clock": "rosgraph_msgs/Clock",
}
SERVED = {"/global_localization", "/request_nomotion_update", "/set_map", "/amcl/set_parameters",
          "/amcl/get_loggers", "/amcl/set_logger_level"}
KEPT = {"initial_pose_x", "initial_pose_y", "initial_pose_a", "initial_cov_xx", "initial_cov_yy",
        "initial_cov_aa"}
FIELDS = set("""use_map_topic first_map_only gui_publish_rate save_pose_rate laser_min_range
    laser_max_range laser_max_beams min_particles max_particles kld_err kld_z odom_alpha1 odom_alpha2
    odom_alpha3 odom_alpha4 odom_alpha5 do_beamskip beam_skip_distance beam_skip_threshold laser_z_hit
    laser_z_short laser_z_max laser_z_rand laser_sigma_hit laser_lambda_short laser_model_type
    laser_likelihood_max_dist odom_model_type update_min_d update_min_a odom_frame_id base_frame_id
    global_frame_id resample_interval transform_tolerance recovery_alpha_slow recovery_alpha_fast
    tf_broadcast force_update_after_initialpose force_update_after_set_map
    restore_defaults""".split())  # of amcl's dynamic_reconfigure


class AmclStock(LocalizationCase):
    def setUp(self):
        super().setUp()
        self.logs = []
        self.subscribers.append(rospy.Subscriber("/rosout_agg", Log, self.on_log))

    def on_log(self, message):
        if message.name == "/amcl":
            self.logs.append(message)

    def test_it_localizes_and_complains_about_nothing(self):
        self.wait_for(lambda: self.errors(), "a first pose")
        self.wait_for_time(5)  # the robot drives on from the initial pose while the node starts
        begin = rospy.get_time()
        self.wait_for_time(25)
        errors = self.errors(begin)
        self.assertGreater(len(errors), 20)
        for stamp, metres, degrees in errors:
            self.assertLess(metres, 0.25, "at %.1f s" % stamp)
            self.assertLess(degrees, 14.3, "at %.1f s" % stamp)
        warnings = [log.msg for log in self.logs if log.level >= Log.WARN]
        self.assertEqual(warnings, [])

    def test_the_same_names_are_seen_from_outside(self):
        self.wait_for(lambda: self.poses, "a first pose")
        master = rosgraph.Master("/amcl_stock_test")
        publishers, subscribers, services = [
            {name for name, nodes in group if "/amcl" in nodes} for group in master.getSystemState()]
        types = dict(master.getTopicTypes())
        for wanted, found in [(PUBLISHED, publishers), (SUBSCRIBED, subscribers)]:
            self.assertEqual(set(wanted) - found, set())
            for name in wanted:
                self.assertEqual(types[name], wanted[name], name)
        self.assertEqual(SERVED - services, set())
        # What is ours is private, so that it gets in nobody's way.
        ours = (publishers - set(PUBLISHED)) | (services - SERVED)
        self.assertEqual({name for name in ours if not name.startswith("/amcl/")}, set())
        self.assertEqual(subscribers - set(SUBSCRIBED), set())

    def test_pose_and_cloud_are_latched(self):
        self.wait_for(lambda: self.poses, "a first pose")
        for topic, kind in [("amcl_pose", PoseWithCovarianceStamped), ("particlecloud", PoseArray)]:
            message = rospy.wait_for_message(topic, kind, AT_LAST)
            self.assertEqual(message.header.frame_id, "map")
            self.assertEqual(message._connection_header["latching"], "1", topic)

    def test_parameters_are_left_as_given_and_the_pose_is_kept(self):
        self.wait_for(lambda: KEPT <= set(rospy.get_param("/amcl")), "the kept pose")
        self.wait_for(lambda: FIELDS <= set(rospy.get_param("/amcl")), "the options in effect")
        found = rospy.get_param("/amcl")
        self.assertEqual((len(FIELDS), FIELDS - set(found)), (41, set()))
        for key, value in {"laser_max_beams": 30, "max_particles": 5000, "odom_alpha3": 0.8,
                           "laser_z_rand": 0.5, "gui_publish_rate": 10.0, "kld_z": 0.99,
                           "recovery_alpha_slow": 0.0, "odom_frame_id": "odom"}.items():
            self.assertEqual(found[key], value, key)


if __name__ == "__main__":
    rospy.init_node("amcl_stock_test")
    rostest.rosrun("adaptive_localization", "amcl_stock", AmclStock, sys.argv)
