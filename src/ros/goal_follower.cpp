// SPDX-License-Identifier: BSD-3-Clause
#include "goal_follower.hpp"

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Path.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "callbacks.hpp"
#include "conversions.hpp"
#include "core/suggestion.hpp"
#include "ros_params.hpp"
#include "sim/world.hpp"

namespace adaptive_localization {
namespace {

constexpr double kPeriod = 0.05;      // s
constexpr double kMargin = 0.01;      // m, for steering
constexpr double kFacing = 0.05;      // rad
constexpr double kStale = 1.0;        // s, of the robot's place
constexpr double kUnreachable = 0.1;  // m from the goal to where the robot can stand

}  // namespace

GoalFollower::GoalFollower(ros::NodeHandle node, ros::NodeHandle private_node)
    : GoalFollower(node, readParameters(private_node)) {}

GoalFollower::GoalFollower(ros::NodeHandle node, const Parameters& parameters)
    : options_(parameters.read(GoalFollowerOptions{})),
      transforms_(tf_),
      command_(node.advertise<geometry_msgs::Twist>("cmd_vel", 1)),
      plan_(node.advertise<nav_msgs::Path>("plan", 1, true)) {
  reportUnknown(parameters.unknownKeys(), keysOf(describe(options_)));
  maps_ = subscribe<nav_msgs::OccupancyGrid>(node, "map", 1,
                                             [this](const auto& message) { onMap(*message); });
  goals_ = subscribe<geometry_msgs::PoseStamped>(node, "move_base_simple/goal", 1,
                                                 [this](const auto& message) { onGoal(*message); });
  timer_ = every(node, ros::Duration(kPeriod), "Following", [this] { advance(); });
  ROS_INFO("Follows goals on %s by tf alone; avoids nothing that the map does not have",
           goals_.getTopic().c_str());
}

void GoalFollower::onMap(const nav_msgs::OccupancyGrid& map) {
  goal_.reset();  // whatever becomes of the new map, the old one holds no more
  free_space_.reset();
  command({});
  const auto grid = std::make_shared<const OccupancyGrid>(toGrid(map));
  free_space_ = std::make_shared<const FreeSpace>(makeWorld(grid), options_.robot_radius + kMargin);
}

std::optional<Pose2> GoalFollower::place() const {
  try {
    const auto transform =
        tf_.lookupTransform(options_.global_frame_id, options_.base_frame_id, ros::Time(0));
    if ((ros::Time::now() - transform.header.stamp).toSec() > kStale) return std::nullopt;
    return toPose2(transform.transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

void GoalFollower::onGoal(const geometry_msgs::PoseStamped& goal) {
  const Pose2 wanted = toPose2(goal.pose);
  const std::optional<Pose2> here = place();
  if (withoutLeadingSlash(goal.header.frame_id) != options_.global_frame_id || !isFinite(wanted)) {
    ROS_WARN("Goal in frame '%s' ignored, expected a finite one in '%s'",
             goal.header.frame_id.c_str(), options_.global_frame_id.c_str());
    return;
  }
  if (!free_space_ || !here) {
    ROS_WARN("Goal ignored: there is no %s yet", free_space_ ? "pose of the robot on tf" : "map");
    return;
  }
  const Eigen::Vector2d to(wanted.x, wanted.y);
  const Eigen::Vector2d reachable = free_space_->nearest(to);
  if ((reachable - to).norm() > kUnreachable) {
    ROS_WARN("Goal %.2f, %.2f is no place for the robot; it goes to %.2f, %.2f", to.x(), to.y(),
             reachable.x(), reachable.y());
  }
  const auto way = wayThrough(*free_space_, {here->x, here->y}, reachable);
  follower_.emplace(free_space_, options_.route);
  follower_->follow(way);
  goal_ = wanted;
  is_there_ = false;
  publishPlan(way);
}

void GoalFollower::publishPlan(const std::vector<Eigen::Vector2d>& way) {
  nav_msgs::Path plan;
  plan.header.frame_id = options_.global_frame_id;
  plan.header.stamp = ros::Time::now();
  for (const Eigen::Vector2d& point : way) {
    geometry_msgs::PoseStamped pose;
    pose.header = plan.header;
    pose.pose = toPoseMessage({point.x(), point.y(), 0.0});
    plan.poses.push_back(pose);
  }
  plan_.publish(plan);
}

void GoalFollower::advance() {
  if (!goal_) return;
  const std::optional<Pose2> here = place();
  if (!here) {
    ROS_WARN_THROTTLE(5.0, "The robot stands: tf does not know where it is");
    return command({});
  }
  command(approach(*here));
}

Velocity GoalFollower::approach(const Pose2& T_map_base) {
  const Eigen::Vector2d here(T_map_base.x, T_map_base.y);
  is_there_ = is_there_ || follower_->hasArrived(here);
  if (!is_there_) {
    if (follower_->isOff(here)) {  // it was localized anew, or carried
      follower_->follow(wayThrough(*free_space_, here, free_space_->nearest({goal_->x, goal_->y})));
    }
    return follower_->steer(T_map_base, kPeriod);
  }
  const double aside = wrapAngle(goal_->theta - T_map_base.theta);
  if (std::abs(aside) < kFacing) {
    ROS_INFO("Goal reached");
    goal_.reset();
    return {};
  }
  const double most = options_.route.route_turn_rate;
  return {0.0, std::clamp(options_.route.route_p * aside, -most, most)};
}

void GoalFollower::stop() {
  if (!goal_) return;
  goal_.reset();
  command({});
  ros::WallDuration(0.1).sleep();  // a publisher that ends drops what it has not sent
}

void GoalFollower::command(const Velocity& velocity) {
  geometry_msgs::Twist message;
  message.linear.x = velocity.forward;
  message.angular.z = velocity.turn;
  command_.publish(message);
}

}  // namespace adaptive_localization
