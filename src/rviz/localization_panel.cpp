// SPDX-License-Identifier: BSD-3-Clause
#include "localization_panel.hpp"

#include <QVBoxLayout>
#include <algorithm>
#include <pluginlib/class_list_macros.hpp>

#include "colours.hpp"
#include "core/error_text.hpp"
#include "legend.hpp"

namespace adaptive_localization {
namespace {

constexpr int kTick = 100;        // ms
constexpr double kSilence = 2.0;  // s, without a status until the panel says so
constexpr auto kNodeKey = "Node";

QLabel* makeTitle(const char* text) {
  auto* title = new QLabel(text);
  QFont font = title->font();
  font.setBold(true);
  title->setFont(font);
  return title;
}

}  // namespace

LocalizationPanel::LocalizationPanel(QWidget* parent) : rviz::Panel(parent) {
  build();
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  timer_.start(kTick);
  tick();
}

void LocalizationPanel::build() {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(6, 4, 6, 4);
  rows->setSpacing(4);
  nodes_ = new QComboBox;
  nodes_->setObjectName("node");
  nodes_->setToolTip("The localization node that is shown");
  nodes_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  name_ = new QLabel;
  name_->setObjectName("node_name");
  status_ = new StatusView(this);
  commands_ =
      new CommandView(this, [this](const QString& text, bool is_error) { say(text, is_error); });
  places_ = new PlaceView(this, [this](const NamedPlace& place) { tellPlace(place); });
  senses_ = new SenseView(this);
  message_ = new QLabel;
  message_->setObjectName("message");
  message_->setWordWrap(true);
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  message_->setMinimumHeight(2 * fontMetrics().height());
  message_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  for (QWidget* row : {static_cast<QWidget*>(nodes_), static_cast<QWidget*>(name_),
                       static_cast<QWidget*>(status_), static_cast<QWidget*>(commands_)}) {
    rows->addWidget(row);
  }
  rows->addWidget(makeTitle("Places"));
  rows->addWidget(places_, 1);
  rows->addWidget(makeTitle("Senses"));
  rows->addWidget(senses_);
  rows->addWidget(makeTitle("Markers"));
  rows->addWidget(makeLegend());
  rows->addWidget(message_);
  connect(nodes_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { choose(index); });
}

void LocalizationPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString node;
  if (config.mapGetString(kNodeKey, &node)) watch_.choose(node.toStdString());
}

void LocalizationPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue(kNodeKey, QString::fromStdString(watch_.seen().chosen));
}

void LocalizationPanel::tick() {
  const NodeWatch::Seen seen = watch_.seen();
  if (seen.current != node_) {
    node_ = seen.current;
    state_ = PanelState();
    linked_at_ = 0.0;
  }
  NodeLink* link = seen.link && seen.link->names().node == node_ ? seen.link.get() : nullptr;
  if (link && linked_at_ == 0.0) linked_at_ = steadySeconds();
  if (link) link->hear(state_);
  const QString trouble = QString::fromStdString(seen.trouble);
  if (trouble != trouble_) say(trouble, true);
  trouble_ = trouble;
  showNodes(seen);
  const QString silence = silenceOf(seen);
  status_->show(state_, silence);
  commands_->show(state_, seen.is_current_there ? link : nullptr);
  places_->show(state_, !silence.isEmpty());
  senses_->setEnabled(silence.isEmpty());
  senses_->show(state_.senses);
}

/// Why there is no status, in words; empty: there is one.
QString LocalizationPanel::silenceOf(const NodeWatch::Seen& seen) const {
  const QString node = QString::fromStdString(seen.current);
  const double since = std::max(state_.heard_at, linked_at_);
  const double silent = since > 0.0 ? steadySeconds() - since : 0.0;
  const bool is_heard = !state_.status.empty();
  if (is_heard && silent <= kSilence) return "";
  if (!seen.is_master_there) return "no ROS master";
  if (node.isEmpty()) return "no localization node";
  if (!seen.is_current_there) return "no node " + node;
  if (silent <= kSilence) return "waiting for " + node;
  return QString("no status from %1 for %2").arg(node, durationText(silent));
}

/// A list where there is something to choose, else a name.
void LocalizationPanel::showNodes(const NodeWatch::Seen& seen) {
  QStringList found;
  for (const std::string& node : seen.nodes) found << QString::fromStdString(node);
  const QString current = QString::fromStdString(seen.current);
  if (!current.isEmpty() && !found.contains(current)) found << current;
  found.sort();
  QStringList shown;
  for (int i = 0; i < nodes_->count(); ++i) shown << nodes_->itemText(i);
  if (shown != found && !nodes_->view()->isVisible()) {
    nodes_->clear();
    nodes_->addItems(found);
  }
  if (!nodes_->view()->isVisible()) nodes_->setCurrentIndex(nodes_->findText(current));
  nodes_->setVisible(found.size() > 1);
  name_->setVisible(found.size() == 1);
  name_->setText(current);
}

void LocalizationPanel::choose(int index) {
  watch_.choose(nodes_->itemText(index).toStdString());
  say("", false);
  Q_EMIT configChanged();
}

void LocalizationPanel::tellPlace(const NamedPlace& place) {
  const auto link = watch_.seen().link;
  if (!link || link->names().node != node_) return;
  try {
    link->tell(place, state_);
    say(QString("told %1 that it is at x %2 m, y %3 m")
            .arg(QString::fromStdString(node_))
            .arg(place.pose.x, 0, 'f', 2)
            .arg(place.pose.y, 0, 'f', 2),
        false);
  } catch (...) {
    say(QString::fromStdString(errorText()), true);
  }
}

void LocalizationPanel::say(const QString& text, bool is_error) {
  message_->setText(text);
  message_->setStyleSheet(is_error ? "color: " + colourOf("lost").name() : QString());
}

}  // namespace adaptive_localization

PLUGINLIB_EXPORT_CLASS(adaptive_localization::LocalizationPanel, rviz::Panel)
