// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
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
  Q_OBJECT
 public:
  explicit PartsPanel(QWidget* parent = nullptr);

  /// A body of one mesh is listed as its only part. `triangles`: of each; empty: not known.
  void show_parts(const SceneBody& fixed, const std::vector<std::size_t>& triangles);
  void show_nothing();
  void choose(std::optional<std::size_t> part);
  std::optional<std::size_t> chosen() const;

 signals:
  void add_wanted();
  void swap_wanted();
  void remove_wanted(std::size_t part);
  void colour_wanted(std::size_t part);
  void take_apart_wanted(std::size_t part);
  void rename_wanted(std::size_t part, const QString& name);
  void shown_wanted(std::size_t part, bool on);
  void felt_wanted(std::size_t part, bool on);
  void chosen_changed(std::optional<std::size_t> part);

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
