// SPDX-License-Identifier: BSD-3-Clause
#include "status_view.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "colours.hpp"

namespace adaptive_localization {
namespace {

QLabel* addLabel(QBoxLayout* layout, const char* name, Qt::Alignment alignment) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setAlignment(alignment | Qt::AlignVCenter);
  layout->addWidget(label);
  return label;
}

}  // namespace

QString durationText(double seconds) {
  const auto whole = static_cast<long>(seconds);
  const auto number = [](long value, const char* unit) {
    return QString("%1 %2").arg(value).arg(unit);
  };
  if (whole < 60) return number(whole, "s");
  if (whole < 3600) return number(whole / 60, "min") + " " + number(whole % 60, "s");
  return number(whole / 3600, "h") + " " + number(whole % 3600 / 60, "min");
}

StatusView::StatusView(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(3);
  status_ = addLabel(rows, "status", Qt::AlignHCenter);
  status_->setWordWrap(true);
  QFont font = status_->font();
  font.setBold(true);
  font.setPointSizeF(1.2 * font.pointSizeF());
  status_->setFont(font);
  auto* line = new QHBoxLayout;
  rows->addLayout(line);
  confidence_ = addLabel(line, "confidence", Qt::AlignLeft);
  duration_ = addLabel(line, "duration", Qt::AlignRight);
  duration_->setToolTip("For how long the status has been what it is, in ROS time");
  history_ = new ConfidenceView(this);
  rows->addWidget(history_);
  figures_ = addLabel(rows, "figures", Qt::AlignLeft);
}

void StatusView::show(const PanelState& state, const QString& silence) {
  const bool is_silent = !silence.isEmpty();
  const QColor colour = is_silent ? colourOfNothing() : colourOf(state.status);
  status_->setText(is_silent ? silence : QString::fromStdString(state.status));
  const QString style =
      QString("background: %1; color: white; border-radius: 4px; padding: 5px").arg(colour.name());
  if (status_->styleSheet() != style) status_->setStyleSheet(style);
  const bool is_known = !state.status.empty();
  confidence_->setText(is_known ? QString("confidence %1").arg(state.confidence, 0, 'f', 2) : "");
  duration_->setText(is_known && !is_silent ? "for " + durationText(state.history.secondsInStatus())
                                            : QString());
  figures_->setText(is_known ? QString("%1 particles, %2 ms per update")
                                   .arg(state.particles)
                                   .arg(state.ms_per_update, 0, 'f', 1)
                             : "");
  for (QWidget* figure : {confidence_, figures_}) figure->setEnabled(!is_silent);
  history_->show(state.history);
}

}  // namespace adaptive_localization
