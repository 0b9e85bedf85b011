// SPDX-License-Identifier: BSD-3-Clause
// The panel as rviz loads it, in a window that nobody sees, beside a node that localizes a
// simulated robot under a name of its own. Buttons are clicked, and the node has to follow.
#include <diagnostic_msgs/DiagnosticStatus.h>
#include <dynamic_reconfigure/Config.h>
#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gmock/gmock.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>
#include <rviz/panel.h>
#include <std_msgs/Float32.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <cmath>
#include <functional>
#include <pluginlib/class_loader.hpp>
#include <string>

namespace adaptive_localization {
namespace {

using testing::HasSubstr;

constexpr double kAtLast = 120.0;  // s of real time, by which a test ends whose answer never comes

class RvizPanel : public testing::Test {
 protected:
  RvizPanel()
      : panel_(loader_.createUniqueInstance("adaptive_localization/Localization")),
        statuses_(node_.subscribe("/pose_finder/status", 100, &RvizPanel::onStatus, this)),
        configs_(node_.subscribe("/pose_finder/parameter_updates", 10, &RvizPanel::onConfig, this)),
        told_(node_.subscribe("/fleet/put_robot", 10, &RvizPanel::onTold, this)),
        poses_(node_.subscribe("/amcl_pose", 10, &RvizPanel::onPose, this)),
        logs_(node_.subscribe("/rosout_agg", 10, &RvizPanel::onLog, this)) {
    panel_->initialize(nullptr);
    panel_->resize(300, 700);
    panel_->show();
  }

  void onStatus(const diagnostic_msgs::DiagnosticStatus& message) {
    status_ = message.message;
    globalizing_ += status_ == "globalizing";
  }
  void onConfig(const dynamic_reconfigure::Config& message) {
    for (const auto& field : message.strs) {
      if (field.name == "filter") core_ = field.value;
    }
  }
  void onTold(const geometry_msgs::PoseWithCovarianceStamped& message) { initial_ = message; }
  void onPose(const geometry_msgs::PoseWithCovarianceStamped& message) { pose_ = message; }

  void onLog(const rosgraph_msgs::Log&) {}

  /// Lets the panel work until a condition holds.
  testing::AssertionResult waitFor(const std::function<bool()>& condition) {
    const auto end = ros::WallTime::now() + ros::WallDuration(kAtLast);
    while (ros::WallTime::now() < end && ros::ok()) {
      QTest::qWait(5);
      ros::spinOnce();
      if (condition()) return testing::AssertionSuccess();
    }
    return testing::AssertionFailure() << "waited in vain; the panel says: " << text("status")
                                       << "; " << text("message") << "; the node: " << status_;
  }

  template <class Widget>
  Widget* find(const std::string& name) {
    return panel_->findChild<Widget*>(QString::fromStdString(name));
  }

  std::string text(const std::string& label) {
    const auto* found = find<QLabel>(label);
    return found ? found->text().toStdString() : "no label " + label;
  }

  bool says(const std::string& label, const std::string& part) {
    return text(label).find(part) != std::string::npos;
  }

  double number(const std::string& label) { return std::stod(text(label)); }

  void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }

  /// The list is opened with the mouse, and one of its lines chosen with a key.
  void choose(QComboBox* box, const std::string& item) {
    const int row = box->findText(QString::fromStdString(item));
    ASSERT_GE(row, 0) << item;
    click(box);
    QAbstractItemView* list = box->view();
    ASSERT_TRUE(waitFor([&] { return list->isVisible(); }));
    list->setCurrentIndex(list->model()->index(row, box->modelColumn()));
    QTest::keyClick(list, Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return !list->isVisible(); }));
  }

  testing::AssertionResult isLocalized() {
    return waitFor([&] { return text("status") == "tracking" || text("status") == "ambiguous"; });
  }

  pluginlib::ClassLoader<rviz::Panel> loader_{"rviz", "rviz::Panel"};
  pluginlib::UniquePtr<rviz::Panel> panel_;
  ros::NodeHandle node_;
  ros::Subscriber statuses_;
  ros::Subscriber configs_;
  ros::Subscriber told_;
  ros::Subscriber poses_;
  ros::Subscriber logs_;  // one connection for all subscribers of a process: the panel's too
  std::string status_;
  std::string core_;
  int globalizing_{0};  // statuses that said so
  geometry_msgs::PoseWithCovarianceStamped initial_;
  geometry_msgs::PoseWithCovarianceStamped pose_;
};

/// Another localization node, as far as its topics go.
class OtherNode {
 public:
  OtherNode()
      : status_(node_.advertise<diagnostic_msgs::DiagnosticStatus>("status", 1)),
        confidence_(node_.advertise<std_msgs::Float32>("confidence", 1)),
        modes_(node_.advertise<geometry_msgs::PoseArray>("modes", 1)) {}

  void say(const std::string& status) {
    diagnostic_msgs::DiagnosticStatus message;
    message.message = status;
    message.values.resize(1);
    message.values[0].key = "confidence";
    message.values[0].value = "0.250";
    status_.publish(message);
  }

 private:
  ros::NodeHandle node_{"~"};
  ros::Publisher status_;
  ros::Publisher confidence_;
  ros::Publisher modes_;
};

}  // namespace

TEST_F(RvizPanel, ShowsTheNodeThatThereIs) {
  ASSERT_TRUE(isLocalized());
  EXPECT_EQ(text("node_name"), "/pose_finder");
  EXPECT_TRUE(find<QComboBox>("node")->isHidden()) << "nothing to choose";
  EXPECT_THAT(text("confidence"), testing::MatchesRegex("confidence [01]\\.[0-9][0-9]"));
  EXPECT_THAT(text("duration"), testing::MatchesRegex("for .* s"));
  EXPECT_TRUE(
      waitFor([&] { return says("figures", " particles, ") && text("figures")[0] != '0'; }));
  EXPECT_TRUE(waitFor([&] { return find<QLabel>("sense") && text("sense") == "laser"; }));
  EXPECT_EQ(text("sense_state").substr(0, 4), "used");
  EXPECT_THAT(text("legend"), testing::HasSubstr("<font color='#009900'>"));  // as ~match has them
  EXPECT_TRUE(waitFor([&] { return find<QComboBox>("core")->currentText() == "sa_kld"; }));
}

TEST_F(RvizPanel, LookAnywhereHasTheRobotLookedFor) {
  ASSERT_TRUE(isLocalized());
  auto* button = find<QPushButton>("look_anywhere");
  ASSERT_TRUE(waitFor([&] { return button->isEnabled(); }));
  globalizing_ = 0;
  click(button);
  EXPECT_TRUE(waitFor([&] { return text("message") == "/pose_finder looks anywhere"; }));
  EXPECT_TRUE(waitFor([&] { return globalizing_ > 0; }));
  EXPECT_TRUE(isLocalized());
}

TEST_F(RvizPanel, HereSendsTheRobotThere) {
  ASSERT_TRUE(waitFor([&] { return find<QPushButton>("here_2") && text("place_mass_2") != "–"; }));
  QPushButton* button = find<QPushButton>("here_2");
  double x[2], y[2];
  const auto are_apart = [&] {
    for (int i = 0; i < 2; ++i) {
      if (text("place_x_" + std::to_string(i + 1)).empty()) return false;
      x[i] = number("place_x_" + std::to_string(i + 1));
      y[i] = number("place_y_" + std::to_string(i + 1));
    }
    return button->isVisible() && button->isEnabled() && std::hypot(x[0] - x[1], y[0] - y[1]) > 3.0;
  };
  ASSERT_TRUE(waitFor([&] { return are_apart() && told_.getNumPublishers() > 0; }));
  click(button);
  EXPECT_THAT(text("message"), HasSubstr("told /pose_finder"));
  ASSERT_TRUE(waitFor([&] { return !initial_.header.frame_id.empty(); }));
  const auto distance = [&](const geometry_msgs::PoseWithCovarianceStamped& pose, int i) {
    return std::hypot(pose.pose.pose.position.x - x[i], pose.pose.pose.position.y - y[i]);
  };
  EXPECT_EQ(initial_.header.frame_id, "map");
  EXPECT_LT(distance(initial_, 1), 0.1);
  EXPECT_DOUBLE_EQ(initial_.pose.covariance[0], 0.25);
  EXPECT_DOUBLE_EQ(initial_.pose.covariance[7], 0.25);
  EXPECT_DOUBLE_EQ(initial_.pose.covariance[35], 0.0685);
  EXPECT_TRUE(waitFor([&] { return !pose_.header.frame_id.empty() && distance(pose_, 1) < 1.0; }));
}

TEST_F(RvizPanel, ChoosesACore) {
  auto* box = find<QComboBox>("core");
  ASSERT_TRUE(waitFor([&] { return box->isEnabled() && core_ == "sa_kld"; }));
  choose(box, "ekf_icp");
  EXPECT_TRUE(waitFor([&] { return text("message") == "/pose_finder works with core ekf_icp"; }));
  EXPECT_TRUE(waitFor([&] { return core_ == "ekf_icp" && box->currentText() == "ekf_icp"; }));
  ASSERT_TRUE(waitFor([&] { return box->isEnabled(); }));
  choose(box, "sa_kld");
  EXPECT_TRUE(waitFor([&] { return core_ == "sa_kld"; }));
}

TEST_F(RvizPanel, TellsWhyACoreIsRefused) {
  auto* box = find<QComboBox>("core");
  ASSERT_TRUE(waitFor([&] { return box->isEnabled() && core_ == "sa_kld"; }));
  ASSERT_TRUE(waitFor([&] { return logs_.getNumPublishers() > 0; }));
  choose(box, "markov");
  EXPECT_TRUE(waitFor([&] { return says("message", "refused core markov: "); }));
  EXPECT_THAT(text("message"), HasSubstr("markov_max_memory"));
  EXPECT_TRUE(waitFor([&] { return box->isEnabled() && box->currentText() == "sa_kld"; }));
}

TEST_F(RvizPanel, AnotherNodeCanBeChosenAndIsKept) {
  ASSERT_TRUE(waitFor([&] { return text("node_name") == "/pose_finder"; }));
  OtherNode other;
  const std::string name = ros::this_node::getName();
  auto* box = find<QComboBox>("node");
  ASSERT_TRUE(waitFor([&] { return box->isVisible() && box->count() == 2; }));
  EXPECT_EQ(box->currentText().toStdString(), "/pose_finder");
  choose(box, name);
  ASSERT_TRUE(waitFor([&] {
    other.say("lost");
    return text("status") == "lost";
  }));
  EXPECT_EQ(text("confidence"), "confidence 0.25");
  const auto colour = [&] { return find<QLabel>("status")->styleSheet().toStdString(); };
  const std::string colour_of_lost = colour();
  EXPECT_TRUE(waitFor([&] { return says("status", "no status from " + name + " for "); }));
  EXPECT_NE(colour(), colour_of_lost);
  EXPECT_FALSE(find<QPushButton>("look_anywhere")->isEnabled()) << "it has no such service";

  const rviz::Config config;
  panel_->save(config);
  QString kept;
  EXPECT_TRUE(config.mapGetString("Node", &kept));
  EXPECT_EQ(kept.toStdString(), name);
  panel_ = loader_.createUniqueInstance("adaptive_localization/Localization");
  panel_->load(config);
  panel_->show();
  ASSERT_TRUE(waitFor([&] {
    other.say("uninitialised");
    return text("status") == "uninitialised";
  }));
}

TEST_F(RvizPanel, SaysThatANodeIsGone) {
  rviz::Config config;
  config.mapSetValue("Node", "/nobody");
  panel_->load(config);
  EXPECT_TRUE(waitFor([&] { return text("status") == "no node /nobody"; }));
  auto* box = find<QComboBox>("node");
  ASSERT_TRUE(waitFor([&] { return box->isVisible() && box->count() == 2; }));
  choose(box, "/pose_finder");
  EXPECT_TRUE(isLocalized());
  EXPECT_TRUE(waitFor([&] { return box->isHidden(); }));
}

}  // namespace adaptive_localization

int main(int argc, char** argv) {
  ros::init(argc, argv, "rviz_panel_check");
  testing::InitGoogleTest(&argc, argv);
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
