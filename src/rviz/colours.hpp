// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QWidget>
#include <string>

namespace adaptive_localization {

/// The colours of topic ~status_text, dark enough for white letters.
inline QColor colourOf(const std::string& status) {
  if (status == "tracking") return QColor(0, 89, 0);
  if (status == "lost") return QColor(153, 0, 0);
  return QColor(153, 51, 0);
}

/// Of what is not known, dark enough for white letters.
inline QColor colourOfNothing() {
  return QColor(96, 96, 96);
}

/// Makes a text quiet, but readable still.
inline void quieten(QWidget* text) {
  text->setStyleSheet("color: " + colourOfNothing().name());
}

}  // namespace adaptive_localization
