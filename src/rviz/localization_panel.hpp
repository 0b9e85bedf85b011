// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/panel.h>

#include <QComboBox>
#include <QLabel>
#include <QTimer>

#include "command_view.hpp"
#include "node_watch.hpp"
#include "panel_state.hpp"
#include "place_view.hpp"
#include "sense_view.hpp"
#include "status_view.hpp"

namespace adaptive_localization {

/// A panel of rviz for one localization node, under whatever name it runs: what it says of itself,
/// and what it can be told. It finds the nodes by itself. rviz's thread never waits for any of them
/// nor for the master.
class LocalizationPanel : public rviz::Panel {
 public:
  explicit LocalizationPanel(QWidget* parent = nullptr);

  /// The node that was chosen, if any, is part of rviz's configuration, as "Node".
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void build();
  void tick();
  void showNodes(const NodeWatch::Seen& seen);
  void choose(int index);
  void tellPlace(const NamedPlace& place);
  void say(const QString& text, bool is_error);
  QString silenceOf(const NodeWatch::Seen& seen) const;

  NodeWatch watch_;
  std::string node_;       // that the state is of
  double linked_at_{0.0};  // s, steady: since when it could be heard
  PanelState state_;
  QString trouble_;  // said already
  QTimer timer_;
  QComboBox* nodes_{nullptr};
  QLabel* name_{nullptr};
  QLabel* message_{nullptr};
  StatusView* status_{nullptr};
  CommandView* commands_{nullptr};
  PlaceView* places_{nullptr};
  SenseView* senses_{nullptr};
};

}  // namespace adaptive_localization
