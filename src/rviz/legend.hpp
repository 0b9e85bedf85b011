// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QLabel>
#include <QString>

#include "ros/palette.hpp"

namespace adaptive_localization {

/// What the colours of the node's markers mean, `~match` and `~landmarks`.
inline QLabel* makeLegend() {
  const auto entry = [](const Rgb& rgb, const char* meaning) {
    const QColor colour =
        QColor::fromRgbF(static_cast<double>(rgb.red), static_cast<double>(rgb.green),
                         static_cast<double>(rgb.blue));
    return QString::fromUtf8("<font color='%1'>●</font>&nbsp;%2&ensp; ")
        .arg(colour.name(), QString(meaning).replace(' ', "&nbsp;"));
  };
  auto* legend =
      new QLabel(entry(kFittingHit, "hit that fits") + entry(kOtherHit, "does not fit") +
                 entry(kRefusedMatch, "match was refused") + entry(kKnownLandmark, "landmark") +
                 entry(kLandmarkSighting, "sighting"));
  legend->setObjectName("legend");
  legend->setTextFormat(Qt::RichText);
  legend->setWordWrap(true);
  return legend;
}

}  // namespace adaptive_localization
