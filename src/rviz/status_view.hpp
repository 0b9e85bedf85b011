// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>
#include <QWidget>

#include "confidence_view.hpp"
#include "panel_state.hpp"

namespace adaptive_localization {

/// The status in words on its colour, for how long, the confidence and its last two minutes, what
/// the filter works with.
class StatusView : public QWidget {
 public:
  explicit StatusView(QWidget* parent);

  /// `silence` tells in words why there is no status now; empty: there is one.
  void show(const PanelState& state, const QString& silence);

 private:
  QLabel* status_;
  QLabel* duration_;
  QLabel* confidence_;
  QLabel* figures_;
  ConfidenceView* history_;
};

/// "42 s", "3 min 5 s", "2 h 10 min".
QString durationText(double seconds);

}  // namespace adaptive_localization
