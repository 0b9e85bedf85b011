// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Empty.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <string>

#include "sim/simulation.hpp"

namespace adaptive_localization {

struct SimulatorNodeOptions {
  bool publish_clock{false};
  double speed{1.0};
  bool lock_step{false};
  bool publish_laser_tf{true};
  double laser_z{0.30};
  std::string laser_frame{"laser"};
  std::string second_laser_frame{"laser_2"};
  std::string imu_frame{"imu"};
  std::string camera_frame{"camera"};
  std::string sonar_frame_prefix{"sonar_"};
  std::string odom_frame_id{"odom"};
  std::string base_frame_id{"base_link"};
  std::string global_frame_id{"map"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("publish_clock", publish_clock,
           "Make the time: publish /clock. On by itself where /use_sim_time is true.");
    option("speed", speed, Range{0.01, 100}, "",
           "Simulated over real time; other than 1 only with publish_clock.");
    option("lock_step", lock_step,
           "Time stops while the transforms of whoever localizes the robot lag, so that a slow "
           "machine loses none of its scans; with publish_clock.");
    option("publish_laser_tf", publish_laser_tf,
           "Publish the laser's place on /tf_static; off where a robot_state_publisher does.");
    option("laser_z", laser_z, Range{-10, 10}, "m", "The laser's height above the floor.");
    option("laser_frame", laser_frame, Choices{}, "Frame of the scans.");
    option("second_laser_frame", second_laser_frame, Choices{}, "The same of the second laser.");
    option("camera_frame", camera_frame, Choices{}, "Frame of the sightings of landmarks.");
    option("imu_frame", imu_frame, Choices{}, "Frame of the compass and the gyroscope.");
    option("sonar_frame_prefix", sonar_frame_prefix, Choices{},
           "Sonar i is in the frame with this name and i.");
    option("odom_frame_id", odom_frame_id, Choices{}, "Frame of the odometry.");
    option("base_frame_id", base_frame_id, Choices{}, "Frame of the robot.");
    option("global_frame_id", global_frame_id, Choices{}, "Frame of the truth.");
  }
};

/// The simulated Pioneer as its drivers would show it: cmd_vel in; odom, tf, scan, and imu,
/// landmarks and sonar if it has what they take; the truth. Topic kidnap carries the robot to a
/// pose, disturb_compass turns what the compass tells by an angle, service kidnap_random anywhere,
/// reset_positions to the start. One thread, no locks.
class SimulatorNode {
 public:
  /// Throws std::invalid_argument naming what is wrong with a parameter or the world.
  SimulatorNode(ros::NodeHandle node, ros::NodeHandle private_node);

 private:
  explicit SimulatorNode(ros::NodeHandle node, ros::NodeHandle private_node,
                         const Parameters& parameters);
  void advance();
  void publish(const Sensed& sensed);
  template <class Make>
  void send(const ros::Publisher& publisher, double stamp, const std::string& frame,
            const Make& make);
  void publishOdometry(const OdometryReading& reading);
  void publishScan(const LaserScan& scan, const std::string& frame);
  void publishPing(const Ping& ping);
  void publishMarkers();
  void publishPaint();
  void publishSensorFrames();
  bool mustWait() const;
  void onTransforms(const tf2_msgs::TFMessage& message);
  void onCommand(const geometry_msgs::Twist& message);
  void onKidnap(const geometry_msgs::PoseStamped& message);
  void onDisturbance(const std_msgs::Float64& message);
  bool onKidnapRandom();
  bool onReset();
  void reportPlace(const char* what) const;
  ros::Time toRosTime(double simulated) const { return epoch_ + ros::Duration(simulated); }

  SimulatorNodeOptions options_;
  Simulation simulation_;
  ros::Time epoch_;             // when simulated time was 0
  ros::WallTime wall_epoch_;    // when it should have been, at the speed asked for
  ros::Time localized_;         // stamp of the newest transform of who localizes the robot
  ros::WallTime localized_at_;  // when that came
  tf2_ros::TransformBroadcaster tf_;
  tf2_ros::StaticTransformBroadcaster static_tf_;
  ros::Publisher clock_;
  ros::Publisher odometry_;
  ros::Publisher scan_;
  ros::Publisher imu_;        // where there is one,
  ros::Publisher landmarks_;  // as of the camera
  ros::Publisher sonar_;      // and of sonars
  ros::Publisher truth_;
  ros::Publisher markers_;
  ros::Publisher paint_;  // where there is some
  ros::Subscriber transforms_;
  ros::Subscriber command_;
  ros::Subscriber kidnap_;
  ros::Subscriber disturbance_;
  ros::ServiceServer kidnap_random_;
  ros::ServiceServer reset_;
  ros::WallTimer timer_;
};

}  // namespace adaptive_localization
