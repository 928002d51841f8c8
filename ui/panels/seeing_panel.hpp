// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QStringList>
#include <optional>

#include "ui/base/format.hpp"
#include "ui/views/seeing.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QSlider;
class QVBoxLayout;

namespace sonde::ui {

class NumberField;

/// The dock for seeing inside: how the bodies are drawn, the plane that cuts them, and the saved
/// views. It shows the given state and reports the user's wishes.
class SeeingPanel : public QDockWidget {
  Q_OBJECT
 public:
  explicit SeeingPanel(QWidget* parent = nullptr);

  void show_seeing(const Seeing& seeing);
  /// Where the bodies are, for the slider of the cut: its ends are that far from the centre.
  void set_extent(const Vec3& centre, double radius);
  void show_saved(const QStringList& names);

 signals:
  void changed(const Seeing& seeing);
  void gap_reach_changed(std::optional<double> reach);  ///< m; none: as fits the gaps
  void snap_wanted();                                   ///< the cut through the contact
  void face_wanted();                                   ///< the cut across the line of sight
  void save_wanted();                                   ///< the view as it is
  void view_wanted(int index);
  void forget_wanted(int index);

 private:
  void add_looks(QVBoxLayout& layout);
  void add_cut(QVBoxLayout& layout);
  void add_gap(QVBoxLayout& layout);
  void add_saved(QVBoxLayout& layout);
  void say();
  void move_cut(int place);

  Seeing seeing_;
  Vec3 centre_ = Vec3::Zero();
  double radius_ = 1;
  QComboBox *fixed_ = nullptr, *probe_ = nullptr;
  QCheckBox *cut_ = nullptr, *cut_fixed_ = nullptr, *cut_probe_ = nullptr;
  QSlider* place_ = nullptr;
  QLabel* gap_label_ = nullptr;
  NumberField* gap_ = nullptr;
  LengthUnit unit_;
  QListWidget* saved_ = nullptr;
  bool showing_ = false;
};

}  // namespace sonde::ui
