// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <array>
#include <optional>

class QLabel;
class QToolButton;

namespace sonde::ui {

class ElidedLabel;

/// What the bar says of one body.
struct RepairsRow {
  QString name;           ///< the body's
  QString text;           ///< in brief
  QString in_full;        ///< for the tooltip
  bool can_show = false;  ///< there are places
  bool can_be_as_in_file = false;
  bool as_in_file = false;  ///< it is: the button mends it
  bool can_close = false;
};

/// A slim bar that says what was mended of the bodies on show, a line for each, and offers to show
/// it and to take it back. One that has nothing to say is hidden.
class RepairsBar : public QFrame {
  Q_OBJECT
 public:
  /// Bodies by this index.
  static constexpr std::size_t probe = 0, fixed = 1;
  explicit RepairsBar(QWidget* parent);

  void show_row(std::size_t body, const std::optional<RepairsRow>& row);
  /// Where Show is: "1 of 7", and what there is to add to it.
  void show_places(std::size_t body, const QString& places, const QString& in_full);
  /// How Show is reached by the keyboard, for its tooltip.
  void set_key(const QString& key);

 signals:
  void show_wanted(std::size_t body);
  void repair_wanted(std::size_t body, bool as_in_file);
  void close_wanted(std::size_t body);
  void put_away();

 private:
  struct Widgets {
    QWidget* row;
    ElidedLabel* text;
    QLabel* places;
    QToolButton *show, *repair, *close;
    bool as_in_file = false;
  };
  Widgets make_row(std::size_t body);

  std::array<Widgets, 2> rows_;
  QString key_;
};

}  // namespace sonde::ui
