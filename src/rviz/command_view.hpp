// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dynamic_reconfigure/Reconfigure.h>
#include <std_srvs/Empty.h>

#include <QAbstractItemView>
#include <QComboBox>
#include <QPushButton>
#include <QWidget>
#include <functional>
#include <memory>
#include <string>

#include "node_link.hpp"
#include "panel_state.hpp"
#include "service_call.hpp"

namespace adaptive_localization {

/// Chooses the filter core and has the robot looked for anywhere. Both call services of the node,
/// one call at a time, and tell what came of it.
class CommandView : public QWidget {
 public:
  /// Says something in words; it may be what went wrong.
  using Say = std::function<void(const QString& text, bool is_error)>;

  CommandView(QWidget* parent, Say say);

  /// Shows the core in effect, and takes over answers that have come. Without a link there is
  /// nobody to be asked.
  void show(const PanelState& state, const NodeLink* link);

 private:
  void search();
  void chooseCore(int index);
  void followSearch();
  void followChoice(const NodeLink* link);
  void fillCores(const PanelState& state);

  Say say_;
  QComboBox* core_;
  QPushButton* search_;
  LocalizationNames names_;  // of the node that is shown
  std::unique_ptr<ServiceCall<std_srvs::Empty>> searching_;
  std::unique_ptr<ServiceCall<dynamic_reconfigure::Reconfigure>> choosing_;
  std::string wanted_;  // the core that was asked for
};

}  // namespace adaptive_localization
