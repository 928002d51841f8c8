// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <array>
#include <optional>

#include "engine/geometry/pose.hpp"
#include "ui/devices/nudge.hpp"
#include "ui/document/snap.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QVBoxLayout;

namespace sonde::ui {

/// The dock of the probe's pose: its mesh frame in the fixed body's, to read, type, copy and paste.
/// It does not touch a field while the user types in it.
class PosePanel : public QDockWidget {
  Q_OBJECT
 public:
  explicit PosePanel(QWidget* parent = nullptr);

  void show_pose(const Pose& X_FM);
  /// The length unit for a scene of this size: "mm".
  void suggest_unit(const QString& name);

  /// The step of the arrow keys for a scene of this size, m.
  void suggest_step(double metres);
  /// The face that the arrow keys may go along; none was clicked yet.
  void show_face(const std::optional<PickedFace>& face);
  /// The scene's axes in the fixed body's, to go along where they are others.
  void set_scene_axes(const Quat& q_FW);

  /// What clicks in the view are waited for, and what to do next; none: nothing, or why not.
  void show_snap(std::optional<SnapKind> kind, const QString& words);

 signals:
  void placed(const Pose& X_FM);
  void snap_wanted(std::optional<SnapKind> kind);
  void nudge_changed(const Nudge& nudge);
  void copy_wanted();
  void copy_matrix_wanted();
  void paste_wanted();
  void start_wanted();
  void swap_wanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Turn { roll_pitch_yaw, axis_angle, quaternion, matrix };
  void build();
  void show_numbers();
  void show_labels();
  void take(std::size_t field);
  void build_snap(QWidget& content, QVBoxLayout& layout);
  void build_nudge(QWidget& content, QVBoxLayout& layout);
  void take_nudge();
  void show_face_words();
  void show_nudge();
  std::array<double, 7> numbers() const;
  Turn turn() const;
  double unit_metres() const;
  bool is_angle(std::size_t field) const;

  Pose pose_;
  QComboBox *unit_, *turn_;
  std::array<QLineEdit*, 7> fields_{};  ///< x, y, z; then the turn
  std::array<QLabel*, 7> labels_{};
  QPlainTextEdit* matrix_ = nullptr;
  std::array<QPushButton*, 3> snaps_{};  ///< by SnapKind
  QLabel* snap_words_ = nullptr;
  Nudge nudge_;
  QComboBox* nudge_axes_ = nullptr;
  QLabel *step_label_ = nullptr, *face_words_ = nullptr;
  QLineEdit *step_ = nullptr, *step_turn_ = nullptr;
};

}  // namespace sonde::ui
