// SPDX-License-Identifier: BSD-3-Clause
#include "place_view.hpp"

#include <QScrollBar>
#include <QVBoxLayout>
#include <utility>

#include "colours.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kMost = 20;  // rows
constexpr int kMore = kMost + 1;   // line of the grid, below them

QLabel* makeCell(const QString& text = "") {
  auto* cell = new QLabel(text);
  cell->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return cell;
}

}  // namespace

PlaceView::PlaceView(QWidget* parent, std::function<void(const NamedPlace&)> on_here)
    : QWidget(parent), on_here_(std::move(on_here)), places_(kMost) {
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  area_ = new QScrollArea;
  area_->setFrameShape(QFrame::NoFrame);
  area_->setWidgetResizable(true);
  area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  whole->addWidget(area_);
  inside_ = new QWidget;
  auto* rows = new QVBoxLayout(inside_);
  rows->setContentsMargins(0, 0, 0, 0);
  grid_ = new QGridLayout;
  grid_->setHorizontalSpacing(6);
  grid_->setVerticalSpacing(2);
  rows->addLayout(grid_);
  rows->addStretch(1);
  addHead();
  area_->setWidget(inside_);
  area_->setMinimumHeight(4 * fontMetrics().height() + 10);  // two rows; it gets all that is left
}

void PlaceView::addHead() {
  const char* const words[] = {"", "x (m)", "y (m)", "heading", "mass", ""};
  for (int i = 0; i < 6; ++i) {
    QLabel* word = makeCell(words[i]);
    QFont font = word->font();
    font.setPointSizeF(0.85 * font.pointSizeF());
    word->setFont(font);
    quieten(word);
    head_.push_back(word);
    grid_->addWidget(word, 0, i);
    grid_->setColumnStretch(i, i == 0 || i == 5 ? 0 : 1);
  }
  more_ = new QLabel;
  quieten(more_);
  grid_->addWidget(more_, kMore, 0, 1, 6);
}

void PlaceView::addRow() {
  Row row;
  const std::size_t index = rows_.size();
  const int line = static_cast<int>(index) + 1;
  const char* const names[] = {"place", "place_x", "place_y", "place_heading", "place_mass"};
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    row.cells[i] = makeCell();
    row.cells[i]->setObjectName(QString("%1_%2").arg(names[i]).arg(line));
    grid_->addWidget(row.cells[i], line, static_cast<int>(i));
  }
  row.here = new QPushButton("Here!");
  row.here->setObjectName(QString("here_%1").arg(line));
  row.here->setToolTip("Tells the node that the robot is at this place");
  row.here->setMinimumWidth(row.here->fontMetrics().boundingRect("Here!").width() + 14);
  row.here->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  grid_->addWidget(row.here, line, 5);
  connect(row.here, &QPushButton::clicked, this, [this, index] {
    if (index < places_.rows().size()) on_here_(places_.rows()[index].place);
  });
  rows_.push_back(row);
}

void PlaceView::show(const PanelState& state, bool is_silent) {
  places_.update(state.places, inside_->underMouse());
  const auto& places = places_.rows();
  while (rows_.size() < places.size()) addRow();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const bool is_used = i < places.size();
    for (QWidget* cell : rows_[i].cells) cell->setVisible(is_used);
    rows_[i].here->setVisible(is_used);
    if (is_used) fill(rows_[i], places[i], is_silent);
  }
  const std::size_t known = state.places.size();
  for (QWidget* word : head_) word->setVisible(!places.empty());
  more_->setVisible(known == 0 || known > kMost);
  const bool is_scrolled = area_->verticalScrollBar()->isVisible();
  area_->setMinimumWidth(inside_->minimumSizeHint().width() +
                         (is_scrolled ? area_->verticalScrollBar()->width() : 0));
  more_->setText(known == 0 ? "none known" : QString("and %1 more").arg(known - kMost));
}

void PlaceView::fill(Row& row, const PlaceRows::Row& shown, bool is_silent) {
  const NamedPlace& place = shown.place;
  const auto number = [](double value, int digits) { return QString::number(value, 'f', digits); };
  const QString texts[] = {
      row.here->objectName().mid(QString("here_").size()), number(place.pose.x, 2),
      number(place.pose.y, 2), number(place.pose.theta * 180.0 / kPi, 0) + QString::fromUtf8("°"),
      place.mass ? number(100.0 * *place.mass, 0) + " %" : QString::fromUtf8("–")};
  const bool is_there = shown.is_there && !is_silent;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    row.cells[i]->setText(texts[i]);
    row.cells[i]->setEnabled(is_there);
  }
  row.here->setEnabled(is_there);
}

}  // namespace adaptive_localization
