// SPDX-License-Identifier: BSD-3-Clause
#include "command_view.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <utility>

namespace adaptive_localization {
namespace {

constexpr double kPatience = 30.0;  // s, with a service
constexpr double kLogDelay = 1.5;   // s, by which the log may be later than the answer

QString text(const std::string& string) {
  return QString::fromStdString(string);
}

}  // namespace

CommandView::CommandView(QWidget* parent, Say say) : QWidget(parent), say_(std::move(say)) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(new QLabel("core"));
  core_ = new QComboBox;
  core_->setObjectName("core");
  core_->setToolTip("The filter core of the node");
  core_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  line->addWidget(core_);
  line->addStretch(1);
  search_ = new QPushButton("Look anywhere");
  search_->setObjectName("look_anywhere");
  search_->setToolTip("Forgets where the robot is and looks for it on the whole map");
  line->addWidget(search_);
  connect(search_, &QPushButton::clicked, this, [this] { search(); });
  connect(core_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { chooseCore(index); });
}

void CommandView::search() {
  if (searching_ || choosing_) return;
  searching_ =
      std::make_unique<ServiceCall<std_srvs::Empty>>(names_.global_localization, std_srvs::Empty());
  say_("asking " + text(names_.node) + " to look anywhere", false);
}

void CommandView::chooseCore(int index) {
  if (searching_ || choosing_) return;
  wanted_ = core_->itemText(index).toStdString();
  dynamic_reconfigure::Reconfigure request;
  request.request.config.strs.resize(1);
  request.request.config.strs[0].name = "filter";
  request.request.config.strs[0].value = wanted_;
  choosing_ = std::make_unique<ServiceCall<dynamic_reconfigure::Reconfigure>>(names_.set_parameters,
                                                                              request);
  say_("asking " + text(names_.node) + " for core " + text(wanted_), false);
}

void CommandView::followSearch() {
  if (searching_->age() > kPatience && !searching_->isDone()) searching_->giveUp();
  if (!searching_->isDone()) return;
  const bool is_fine = searching_->error().empty();
  say_(is_fine ? text(names_.node) + " looks anywhere" : text(searching_->error()), !is_fine);
  searching_.reset();
}

/// Why a core was refused is told in the node's log alone, which may come after the answer.
void CommandView::followChoice(const NodeLink* link) {
  if (choosing_->age() > kPatience && !choosing_->isDone()) choosing_->giveUp();
  if (!choosing_->isDone()) return;
  const std::string core = coreIn(choosing_->answer().response.config);
  if (!choosing_->error().empty()) {
    say_(text(choosing_->error()), true);
  } else if (core == wanted_) {
    say_(text(names_.node) + " works with core " + text(core), false);
  } else {
    const bool is_same = link && link->names().node == names_.node;
    const std::string why = is_same ? link->warningSince(choosing_->begin()) : "";
    if (why.empty() && choosing_->secondsDone() < kLogDelay) return;
    say_(text(names_.node) + " refused core " + text(wanted_) + ": " +
             (why.empty() ? "its log tells why" : text(why)),
         true);
  }
  choosing_.reset();
}

void CommandView::fillCores(const PanelState& state) {
  QStringList cores;
  for (const std::string& core : state.cores) cores << text(core);
  QStringList shown;
  for (int i = 0; i < core_->count(); ++i) shown << core_->itemText(i);
  if (shown != cores) {
    core_->clear();
    core_->addItems(cores);
  }
  core_->setCurrentIndex(core_->findText(text(state.core)));
}

void CommandView::show(const PanelState& state, const NodeLink* link) {
  if (searching_) followSearch();
  if (choosing_) followChoice(link);
  const bool is_free = link && !searching_ && !choosing_;
  if (is_free) names_ = link->names();
  const bool is_open = core_->view()->isVisible();
  if (!is_open && !choosing_) fillCores(state);
  core_->setEnabled(is_free && !names_.set_parameters.empty() && core_->count() > 0);
  search_->setEnabled(is_free && !names_.global_localization.empty());
}

}  // namespace adaptive_localization
