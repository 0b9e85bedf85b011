// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QWidget>
#include <vector>

#include "panel_state.hpp"

namespace adaptive_localization {

/// The senses that the node uses, with what it makes of each: green is fine, red is not.
class SenseView : public QWidget {
 public:
  explicit SenseView(QWidget* parent);

  void show(const std::vector<Sense>& senses);

 private:
  struct Row {
    QLabel* dot;
    QLabel* name;
    QLabel* state;
  };

  void addRow();

  QGridLayout* grid_;
  QLabel* none_;
  std::vector<Row> rows_;
};

}  // namespace adaptive_localization
