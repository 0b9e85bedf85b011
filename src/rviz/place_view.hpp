// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QWidget>
#include <array>
#include <functional>
#include <vector>

#include "place_rows.hpp"

namespace adaptive_localization {

/// Lists the places where the robot may be, each with a button that tells the node that it is
/// there. Rows stay where they are while the mouse is over them.
class PlaceView : public QWidget {
 public:
  PlaceView(QWidget* parent, std::function<void(const NamedPlace&)> on_here);

  void show(const PanelState& state, bool is_silent);

 private:
  struct Row {
    std::array<QLabel*, 5> cells;  // number, x, y, heading, mass
    QPushButton* here;
  };

  void addHead();
  void addRow();
  void fill(Row& row, const PlaceRows::Row& place, bool is_silent);

  std::function<void(const NamedPlace&)> on_here_;
  PlaceRows places_;
  QScrollArea* area_;
  QWidget* inside_;
  QGridLayout* grid_;
  std::vector<QLabel*> head_;
  QLabel* more_;
  std::vector<Row> rows_;
};

}  // namespace adaptive_localization
