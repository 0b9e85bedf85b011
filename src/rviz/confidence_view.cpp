// SPDX-License-Identifier: BSD-3-Clause
#include "confidence_view.hpp"

#include <QPainter>
#include <algorithm>

#include "colours.hpp"

namespace adaptive_localization {
namespace {

constexpr double kGap = 3.0;  // s, without a status: no line is drawn over it

/// Where to draw: the left end is two minutes before the right one.
struct Axes {
  QRectF area;
  double newest{0.0};  // s

  QPointF at(double stamp, double confidence) const {
    const double share = 1.0 - (newest - stamp) / ConfidenceHistory::kSpan;
    return {area.left() + share * area.width(),
            area.bottom() - std::clamp(confidence, 0.0, 1.0) * area.height()};
  }
};

void drawGrid(QPainter& painter, const Axes& axes, const QPalette& palette) {
  painter.setPen(QPen(palette.color(QPalette::Mid), 1.0));
  for (const double minutes : {0.0, 1.0, 2.0}) {
    const double stamp = axes.newest - 60.0 * minutes;
    painter.drawLine(axes.at(stamp, 0.0), axes.at(stamp, 1.0));
  }
  for (const double confidence : {0.0, 0.5, 1.0}) {
    painter.drawLine(axes.at(axes.newest - ConfidenceHistory::kSpan, confidence),
                     axes.at(axes.newest, confidence));
  }
}

/// At the ends of the axes; `letter` is the size of a line of text.
void drawWords(QPainter& painter, const Axes& axes, const QSizeF& letter, const QColor& colour) {
  painter.setPen(colour);
  const QRectF& area = axes.area;
  const auto number = [&](double confidence, const char* text) {
    const double y = axes.at(axes.newest, confidence).y() - letter.height() / 2.0;
    painter.drawText(QRectF(0.0, y, area.left() - 3.0, letter.height()),
                     Qt::AlignRight | Qt::AlignVCenter, text);
  };
  number(0.0, "0");
  number(1.0, "1");
  const QRectF below(area.left(), area.bottom() + 2.0, area.width(), letter.height());
  painter.drawText(below, Qt::AlignLeft, QString::fromUtf8("−2 min"));
  painter.drawText(below, Qt::AlignHCenter, QString::fromUtf8("−1 min"));
  painter.drawText(below, Qt::AlignRight, "now");
}

void drawLine(QPainter& painter, const Axes& axes, const ConfidenceHistory& history) {
  const auto& samples = history.samples();
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto& a = samples[i - 1];
    const auto& b = samples[i];
    if (b.stamp - a.stamp > kGap) continue;
    painter.setPen(QPen(colourOf(a.status), 2.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(axes.at(a.stamp, a.confidence), axes.at(b.stamp, b.confidence));
  }
}

}  // namespace

ConfidenceView::ConfidenceView(QWidget* parent) : QWidget(parent) {
  setObjectName("history");
  setToolTip("Confidence of the last two minutes, coloured by the status");
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

QSize ConfidenceView::sizeHint() const {
  return {200, 50 + 2 * fontMetrics().height()};
}

void ConfidenceView::show(const ConfidenceHistory& history) {
  history_ = history;
  update();
}

void ConfidenceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QSizeF letter(fontMetrics().boundingRect("0").width(), fontMetrics().height());
  const double left = letter.width() + 6.0, top = letter.height() / 2.0;
  Axes axes;
  axes.area = QRectF(left, top, width() - left - 3.0, height() - top - letter.height() - 3.0);
  if (!history_.samples().empty()) axes.newest = history_.samples().back().stamp;
  painter.fillRect(axes.area, palette().color(QPalette::Base));
  drawGrid(painter, axes, palette());
  drawWords(painter, axes, letter, palette().color(QPalette::WindowText));
  painter.setClipRect(axes.area.adjusted(-1.0, -2.0, 1.0, 2.0));
  drawLine(painter, axes, history_);
}

}  // namespace adaptive_localization
