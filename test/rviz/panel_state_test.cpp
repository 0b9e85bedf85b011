// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel_state.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "ros/reconfigure_messages.hpp"

namespace adaptive_localization {
namespace {

using diagnostic_msgs::DiagnosticArray;
using diagnostic_msgs::DiagnosticStatus;
using testing::ElementsAre;
using testing::IsEmpty;

void add(DiagnosticStatus& status, const std::string& key, const std::string& value) {
  diagnostic_msgs::KeyValue pair;
  pair.key = key;
  pair.value = value;
  status.values.push_back(pair);
}

DiagnosticStatus statusMessage(const std::string& word) {
  DiagnosticStatus status;
  status.message = word;
  add(status, "stamp", "12.500000000");
  add(status, "confidence", "0.750");
  add(status, "modes", "2");
  add(status, "mode 1", "mass 0.600 at x 1.000 m, y -2.000 m, yaw 90.0 deg");
  add(status, "mode 2", "mass 0.400 at x 3.000 m, y 4.000 m, yaw -180.0 deg");
  add(status, "particles", "1200");
  add(status, "ms per update", "3.250");
  return status;
}

geometry_msgs::Pose pose(double x, double y, double yaw) {
  geometry_msgs::Pose message;
  message.position.x = x;
  message.position.y = y;
  message.orientation.z = std::sin(yaw / 2.0);
  message.orientation.w = std::cos(yaw / 2.0);
  return message;
}

geometry_msgs::PoseArray modesMessage() {
  geometry_msgs::PoseArray message;
  message.header.frame_id = "floor";
  message.header.stamp.sec = 12;
  message.poses = {pose(1.0, -2.0, kPi / 2), pose(3.0, 4.0, kPi), pose(5.0, 5.0, 0.0)};
  return message;
}

DiagnosticStatus diagnostic(const std::string& name, const std::string& message = "OK") {
  DiagnosticStatus status;
  status.name = name;
  status.message = message;
  status.level = message == "OK" ? DiagnosticStatus::OK : DiagnosticStatus::WARN;
  return status;
}

DiagnosticArray scansMessage(const std::string& name, const std::string& received,
                             const std::string& dropped, const std::string& message = "OK") {
  DiagnosticArray array;
  array.status.push_back(diagnostic(name + ": Scans", message));
  add(array.status.back(), "scans received", received);
  add(array.status.back(), "scans dropped", dropped);
  return array;
}

}  // namespace

TEST(PanelState, ReadsTheStatus) {
  PanelState state;
  read(statusMessage("ambiguous"), state);
  EXPECT_EQ(state.status, "ambiguous");
  EXPECT_EQ(state.confidence, 0.75);
  EXPECT_EQ(state.particles, 1200U);
  EXPECT_EQ(state.ms_per_update, 3.25);
  ASSERT_EQ(state.history.samples().size(), 1U);
  EXPECT_EQ(state.history.samples()[0].stamp, 12.5);
  EXPECT_EQ(state.history.samples()[0].confidence, 0.75);
  EXPECT_EQ(state.history.samples()[0].status, "ambiguous");
}

TEST(PanelState, WhatAStatusDoesNotTellStaysAsItWas) {
  PanelState state;
  read(statusMessage("tracking"), state);
  DiagnosticStatus other;
  other.message = "lost";
  add(other, "confidence", "high");
  add(other, "particles", "-3");
  read(other, state);
  EXPECT_EQ(state.status, "lost");
  EXPECT_EQ(state.confidence, 0.75);
  EXPECT_EQ(state.particles, 1200U);
  EXPECT_EQ(state.history.samples().size(), 1U);
}

TEST(PanelState, PlacesHaveTheMassesOfTheStatusWhicheverComesFirst) {
  for (const bool is_status_first : {true, false}) {
    PanelState state;
    if (is_status_first) read(statusMessage("ambiguous"), state);
    read(modesMessage(), state);
    read(statusMessage("ambiguous"), state);
    ASSERT_EQ(state.places.size(), 3U);
    EXPECT_EQ(state.frame, "floor");
    EXPECT_EQ(state.places_stamp, ros::Time(12));
    EXPECT_EQ(state.places[0].mass, 0.6);
    EXPECT_EQ(state.places[1].mass, 0.4);
    EXPECT_EQ(state.places[2].mass, std::nullopt);
    EXPECT_NEAR(state.places[0].pose.theta, kPi / 2, 1e-9);
    EXPECT_EQ(state.places[1].pose.x, 3.0);
    EXPECT_EQ(state.places[1].pose.y, 4.0);
  }
}

TEST(PanelState, AMassBelongsToItsPlaceAlone) {
  PanelState state;
  read(statusMessage("ambiguous"), state);
  auto modes = modesMessage();
  modes.poses[0] = pose(1.0, -2.0, 0.0);
  read(modes, state);
  EXPECT_EQ(state.places[0].mass, std::nullopt) << "turned";
  EXPECT_EQ(state.places[1].mass, 0.4);
}

TEST(PanelState, WithoutModesThereAreNoPlaces) {
  PanelState state;
  read(modesMessage(), state);
  DiagnosticStatus status;
  status.message = "uninitialised";
  add(status, "modes", "0");
  read(status, state);
  EXPECT_THAT(state.places, IsEmpty());
}

TEST(PanelState, ReadsTheLaser) {
  PanelState state;
  EXPECT_TRUE(read(scansMessage("robot/amcl", "100", "0"), "/robot/amcl", state));
  ASSERT_EQ(state.senses.size(), 1U);
  EXPECT_EQ(state.senses[0].name, "laser");
  EXPECT_EQ(state.senses[0].state, "used");
  EXPECT_TRUE(state.senses[0].is_fine);
  read(scansMessage("robot/amcl", "100", "7"), "/robot/amcl", state);
  EXPECT_EQ(state.senses[0].state, "used, 7 of 100 scans dropped");
  read(scansMessage("robot/amcl", "0", "0", "Waiting for a scan on /scan"), "/robot/amcl", state);
  EXPECT_EQ(state.senses[0].state, "Waiting for a scan on /scan");
  EXPECT_FALSE(state.senses[0].is_fine);
  read(scansMessage("robot/amcl", "0", "0"), "/robot/amcl", state);
  EXPECT_THAT(state.senses, IsEmpty()) << "a robot without a laser";
}

TEST(PanelState, LeavesTheDiagnosticsOfOthers) {
  PanelState state;
  read(scansMessage("amcl", "100", "0"), "/amcl", state);
  EXPECT_FALSE(read(scansMessage("robot/amcl", "100", "7"), "/amcl", state));
  EXPECT_FALSE(read(DiagnosticArray(), "/amcl", state));
  ASSERT_EQ(state.senses.size(), 1U);
  EXPECT_EQ(state.senses[0].state, "used");
}

TEST(PanelState, ReadsTheOtherSenses) {
  auto message = scansMessage("amcl", "100", "0");
  message.status.push_back(diagnostic("amcl: Senses", "compass: disturbed; sonar: silent for 3 s"));
  DiagnosticStatus& senses = message.status.back();
  for (const std::string name : {"compass", "gyroscope", "sonar"}) {
    add(senses, name,
        name == "compass" ? "disturbed"
        : name == "sonar" ? "silent for 3 s"
                          : "used");
    add(senses, name + " messages received", "5");
    add(senses, name + " messages dropped", "0");
  }
  PanelState state;
  read(message, "/amcl", state);
  std::vector<std::string> words;
  std::vector<bool> fine;
  for (const Sense& sense : state.senses) {
    words.push_back(sense.name + ": " + sense.state);
    fine.push_back(sense.is_fine);
  }
  EXPECT_THAT(words, ElementsAre("laser: used", "compass: disturbed", "gyroscope: used",
                                 "sonar: silent for 3 s"));
  EXPECT_THAT(fine, ElementsAre(true, false, true, false));
}

/// As this package's node sends them, and as dynamic_reconfigure's own servers do.
TEST(PanelState, ReadsTheCores) {
  OptionDescription option;
  option.key = "filter";
  option.value = std::string("kld");
  option.choices = {"kld", "my_core"};
  PanelState state;
  read(toDescription({option}), state);
  EXPECT_THAT(state.cores, ElementsAre("kld", "my_core"));
  read(toConfig({option}), state);
  EXPECT_EQ(state.core, "kld");
  dynamic_reconfigure::ConfigDescription other;
  other.groups.resize(1);
  other.groups[0].parameters.resize(2);
  other.groups[0].parameters[0].name = "model";
  other.groups[0].parameters[0].edit_method = "{'enum': [{'value': 'beam'}]}";
  other.groups[0].parameters[1].name = "filter";
  other.groups[0].parameters[1].edit_method =
      "{'enum_description': 'Cores', 'enum': [{'srcline': 7, 'description': '', 'value': 'a'}, "
      "{\"value\": \"b\", 'type': 'str'}]}";
  read(other, state);
  EXPECT_THAT(state.cores, ElementsAre("a", "b"));
}

TEST(PanelState, AConfigWithoutACoreChangesNothing) {
  PanelState state;
  state.core = "kld";
  read(dynamic_reconfigure::Config(), state);
  EXPECT_EQ(state.core, "kld");
  EXPECT_EQ(coreIn(dynamic_reconfigure::Config()), "");
}

}  // namespace adaptive_localization
