// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <functional>
#include <optional>
#include <vector>

#include "engine/scene/scene_body.hpp"

class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace sonde::ui {

/// The dock of the fixed body's parts: names, colours, a tick for what is shown and one for what is
/// felt. It shows the given body and reports the user's wishes.
class PartsPanel : public QDockWidget {
 public:
  explicit PartsPanel(QWidget* parent = nullptr);

  /// A body of one mesh is listed as its only part. `triangles`: of each; empty: not known.
  void show_parts(const SceneBody& fixed, const std::vector<std::size_t>& triangles);
  void show_nothing();
  void choose(std::optional<std::size_t> part);
  std::optional<std::size_t> chosen() const;

  std::function<void()> add_wanted, swap_wanted;
  std::function<void(std::size_t part)> remove_wanted, colour_wanted, take_apart_wanted;
  std::function<void(std::size_t part, const QString& name)> rename_wanted;
  std::function<void(std::size_t part, bool on)> shown_wanted, felt_wanted;
  std::function<void(std::optional<std::size_t> part)> chosen_changed;

 private:
  QPushButton* button(const QString& text, const char* object, const QString& doc);
  void show_row(QTreeWidgetItem& row, const SceneBody& part, const QColor& colour, bool only);
  std::optional<std::size_t> chosen_or_only() const;
  void on_changed(QTreeWidgetItem* row, int column);
  void update_buttons();

  QTreeWidget* rows_;
  QPushButton *add_, *remove_, *colour_, *swap_, *take_apart_;
  bool filling_ = false;
};

}  // namespace sonde::ui
