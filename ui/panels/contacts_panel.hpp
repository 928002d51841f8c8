// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <cstdint>
#include <optional>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "ui/base/format.hpp"

class QLabel;
class QTreeWidget;

namespace sonde::ui {

/// The dock of contacts: the clusters that carry the separation, the largest share first. The
/// chosen row is marked in the view, and a contact chosen in the view chooses its row.
class ContactsPanel : public QDockWidget {
  Q_OBJECT
 public:
  explicit ContactsPanel(QWidget* parent = nullptr);

  /// Other bodies.
  void take(const Pair& pair);
  void show_contacts(const Separation& separation, const Wrench& wrench);
  /// The row of that cluster; 0: none. It stays chosen while the cluster comes and goes.
  void choose(std::uint64_t id);
  std::uint64_t chosen() const { return chosen_; }

 signals:
  void chosen_changed(std::uint64_t id);

 private:
  void on_selection();

  QTreeWidget* rows_;
  QLabel* summary_;
  std::optional<Pair> pair_;
  LengthUnit unit_;
  Vec3 com_ = Vec3::Zero();  ///< of the probe, in its mesh frame
  std::uint64_t chosen_ = 0;
  bool filling_ = false;
};

}  // namespace sonde::ui
