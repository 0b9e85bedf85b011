// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "confidence_history.hpp"

namespace adaptive_localization {

/// Plots the confidence of the last two minutes, from 0 to 1, in the colour that the status had.
class ConfidenceView : public QWidget {
 public:
  explicit ConfidenceView(QWidget* parent);

  void show(const ConfidenceHistory& history);

 protected:
  void paintEvent(QPaintEvent* event) override;
  QSize sizeHint() const override;

 private:
  ConfidenceHistory history_;
};

}  // namespace adaptive_localization
