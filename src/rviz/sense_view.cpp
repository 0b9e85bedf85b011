// SPDX-License-Identifier: BSD-3-Clause
#include "sense_view.hpp"

#include "colours.hpp"

namespace adaptive_localization {

SenseView::SenseView(QWidget* parent) : QWidget(parent) {
  grid_ = new QGridLayout(this);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setVerticalSpacing(1);
  grid_->setColumnStretch(2, 1);
  none_ = new QLabel("nothing told on /diagnostics");
  quieten(none_);
  grid_->addWidget(none_, 0, 0, 1, 3);
}

void SenseView::addRow() {
  const Row row{new QLabel(QString::fromUtf8("●")), new QLabel, new QLabel};
  const int line = static_cast<int>(rows_.size()) + 1;
  row.name->setObjectName("sense");
  row.state->setObjectName("sense_state");
  row.state->setWordWrap(true);
  row.state->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  grid_->addWidget(row.dot, line, 0, Qt::AlignTop);
  grid_->addWidget(row.name, line, 1, Qt::AlignTop);
  grid_->addWidget(row.state, line, 2, Qt::AlignTop);
  rows_.push_back(row);
}

void SenseView::show(const std::vector<Sense>& senses) {
  none_->setVisible(senses.empty());
  while (rows_.size() < senses.size()) addRow();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const bool is_used = i < senses.size();
    for (QWidget* part : {rows_[i].dot, rows_[i].name, rows_[i].state}) part->setVisible(is_used);
    if (!is_used) continue;
    const QColor colour = colourOf(senses[i].is_fine ? "tracking" : "lost");
    rows_[i].dot->setText(QString::fromUtf8("<font color='%1'>●</font>").arg(colour.name()));
    rows_[i].name->setText(QString::fromStdString(senses[i].name));
    rows_[i].state->setText(QString::fromStdString(senses[i].state));
  }
}

}  // namespace adaptive_localization
