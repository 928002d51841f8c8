// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QStringList>
#include <optional>
#include <vector>

#include "engine/study/assembly/clash.hpp"
#include "ui/base/format.hpp"

class QLabel;
class QTreeWidget;

namespace sonde::ui {

class NumberField;
class WorkRow;

/// The dock of clashes: how each two of the parts and the probe stand to each other, the deepest
/// first, and how to part them.
class ClashPanel : public QDockWidget {
  Q_OBJECT
 public:
  explicit ClashPanel(QWidget* parent = nullptr);

  /// A scene of that size was opened.
  void take(double radius);
  /// m; what is no number, or less than 0, is 0.
  double within() const;
  double allowance() const;
  void show_progress(std::optional<double> fraction, double elapsed = 0);
  /// Found of these parts, at the poses that they had then.
  void show_clashes(const std::vector<AssemblyPart>& parts, const std::vector<Clash>& found);
  void show_reason(const QString& reason);

 signals:
  void find_wanted();
  void stop_wanted();
  void chosen(std::size_t clash);

 private:
  QTreeWidget* rows_;
  QLabel* summary_;
  NumberField *within_, *allowance_;
  QLabel *within_label_, *allowance_label_;
  WorkRow* work_;
  LengthUnit unit_;
};

/// "0.12 mm, 3.4°": what the way out of a clash does to the part that it moves.
QString way_out_text(const Clash& clash, const std::vector<AssemblyPart>& parts,
                     const LengthUnit& unit);

}  // namespace sonde::ui
