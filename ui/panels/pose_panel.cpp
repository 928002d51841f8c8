// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/pose_panel.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "engine/scene/scene.hpp"
#include "engine/text/number_text.hpp"
#include "ui/document/pose_text.hpp"
#include "ui/panels/scrolled.hpp"

namespace sonde::ui {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr int digits = 7;
constexpr double least_angle = 1e-6;  // degrees; less is rounding

/// A field for a number. Letters that are no part of one stay commands of the window, as in the
/// other docks; Enter gives the keyboard back to the view.
class NumberField : public QLineEdit {
 public:
  using QLineEdit::QLineEdit;

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride) {
      const auto& key = static_cast<const QKeyEvent&>(*event);
      const bool letter = key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z;
      const bool plain = !(key.modifiers() & ~Qt::ShiftModifier);
      if (plain && (letter || key.key() == Qt::Key_Space) && key.key() != Qt::Key_E) {
        event->ignore();
        return false;
      }
    }
    return QLineEdit::event(event);
  }
  void keyPressEvent(QKeyEvent* event) override {
    QLineEdit::keyPressEvent(event);
    if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter) return;
    for (QWidget* up = parentWidget(); up; up = up->parentWidget())
      if (auto* main = qobject_cast<QMainWindow*>(up); main && main->centralWidget())
        return main->centralWidget()->setFocus(Qt::OtherFocusReason);
  }
};

QString shown(double value) {
  if (std::abs(value) < 1e-9) value = 0;  // rounding
  return QString::fromStdString(number_text(value, digits));
}

}  // namespace

PosePanel::PosePanel(QWidget* parent)
    : QDockWidget(QStringLiteral("Pose"), parent),
      unit_(new QComboBox(this)),
      turn_(new QComboBox(this)) {
  setObjectName(QStringLiteral("pose_panel"));
  build();
  show_labels();
  show_numbers();
}

void PosePanel::build() {
  const Scrolled dock = scrolled(*this);
  QWidget* const content = dock.content;
  QVBoxLayout* const layout = dock.layout;
  auto* grid = new QGridLayout;
  layout->addLayout(grid);
  unit_->setObjectName(QStringLiteral("pose_unit"));
  for (const char* name : {"m", "cm", "mm", "um", "in", "ft"}) unit_->addItem(QLatin1String(name));
  turn_->setObjectName(QStringLiteral("pose_turn"));
  turn_->addItems({QStringLiteral("roll, pitch, yaw"), QStringLiteral("axis and angle")});
  grid->addWidget(new QLabel(QStringLiteral("Position in"), content), 0, 0);
  grid->addWidget(unit_, 0, 1);
  grid->addWidget(new QLabel(QStringLiteral("Turn as"), content), 4, 0);
  grid->addWidget(turn_, 4, 1);
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    labels_.at(i) = new QLabel(content);
    fields_.at(i) = new NumberField(content);
    fields_.at(i)->setObjectName(QStringLiteral("pose_%1").arg(i));
    fields_.at(i)->setToolTip(
        QStringLiteral("The origin and the axes of the probe's mesh in the fixed body's mesh"));
    const int row = static_cast<int>(i) + (i < 3 ? 1 : 2);
    grid->addWidget(labels_.at(i), row, 0);
    grid->addWidget(fields_.at(i), row, 1);
    connect(fields_.at(i), &QLineEdit::editingFinished, this, [this, i] { take(i); });
  }
  const auto add = [&](const char* text, const char* object, std::function<void()>& pressed) {
    auto* button = new QPushButton(QLatin1String(text), content);
    button->setObjectName(QLatin1String(object));
    connect(button, &QPushButton::clicked, this, [&pressed] {
      if (pressed) pressed();
    });
    return button;
  };
  auto* buttons = new QGridLayout;
  buttons->addWidget(add("Copy pose", "pose_copy", copy_wanted), 0, 0);
  buttons->addWidget(add("Paste pose", "pose_paste", paste_wanted), 0, 1);
  buttons->addWidget(add("Start from here", "pose_start", start_wanted), 1, 0);
  buttons->addWidget(add("Swap the bodies", "pose_swap", swap_wanted), 1, 1);
  layout->addLayout(buttons);
  build_nudge(*content, *layout);
  layout->addStretch();
  connect(unit_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
    show_numbers();
    show_nudge();
  });
  connect(turn_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
    show_labels();
    show_numbers();
  });
}

void PosePanel::build_nudge(QWidget& content, QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Arrow keys, Page Up and Page Down"), &content);
  auto* grid = new QGridLayout(group);
  nudge_axes_ = new QComboBox(group);
  nudge_axes_->setObjectName(QStringLiteral("nudge_axes"));
  nudge_axes_->addItems({QStringLiteral("the picture's axes"),
                         QStringLiteral("the fixed body's x, y, z"),
                         QStringLiteral("the probe's x, y, z")});
  nudge_axes_->setToolTip(QStringLiteral(
      "Of a body, left and right are -x and x, down and up -y and y, Page Down and Page Up -z and "
      "z. With Shift the probe turns about that axis."));
  step_label_ = new QLabel(group);
  step_ = new NumberField(group);
  step_->setObjectName(QStringLiteral("nudge_step"));
  step_turn_ = new NumberField(group);
  step_turn_->setObjectName(QStringLiteral("nudge_turn"));
  grid->addWidget(new QLabel(QStringLiteral("along"), group), 0, 0);
  grid->addWidget(nudge_axes_, 0, 1);
  grid->addWidget(step_label_, 1, 0);
  grid->addWidget(step_, 1, 1);
  grid->addWidget(new QLabel(QStringLiteral("with Shift, °"), group), 2, 0);
  grid->addWidget(step_turn_, 2, 1);
  layout.addWidget(group);
  connect(nudge_axes_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this] { take_nudge(); });
  for (QLineEdit* field : {step_, step_turn_})
    connect(field, &QLineEdit::editingFinished, this, [this] { take_nudge(); });
  show_nudge();
}

void PosePanel::suggest_step(double metres) {
  nudge_.step = metres;
  show_nudge();
  if (nudge_changed) nudge_changed(nudge_);
}

/// What is no number above zero changes nothing.
void PosePanel::take_nudge() {
  const auto typed = [](const QLineEdit& field, double& value, double unit) {
    if (!field.isModified()) return;
    const auto read = parse_number(field.text().trimmed().replace(',', '.').toStdString());
    if (read && std::isfinite(*read) && *read > 0) value = *read * unit;
  };
  nudge_.axes = static_cast<Nudge::Axes>(nudge_axes_->currentIndex());
  typed(*step_, nudge_.step, unit_in_metres(unit_->currentText().toStdString()).value_or(1));
  typed(*step_turn_, nudge_.turn, degree);
  show_nudge();
  if (nudge_changed) nudge_changed(nudge_);
}

void PosePanel::show_nudge() {
  const double unit = unit_in_metres(unit_->currentText().toStdString()).value_or(1);
  step_label_->setText(QStringLiteral("by, %1").arg(unit_->currentText()));
  step_->setText(shown(nudge_.step / unit));
  step_turn_->setText(shown(nudge_.turn / degree));
}

bool PosePanel::is_angle(std::size_t field) const {
  return turn() == Turn::roll_pitch_yaw ? field >= 3 : field == 6;
}

PosePanel::Turn PosePanel::turn() const { return static_cast<Turn>(turn_->currentIndex()); }

void PosePanel::suggest_unit(const QString& name) {
  const int index = unit_->findText(name == QStringLiteral("µm") ? QStringLiteral("um") : name);
  if (index >= 0) unit_->setCurrentIndex(index);
}

void PosePanel::show_labels() {
  const bool angles = turn() == Turn::roll_pitch_yaw;
  const char* const three[] = {
      "x", "y", "z", "roll, about x, °", "pitch, about y, °", "yaw, about z, °", ""};
  const char* const four[] = {"x", "y", "z", "axis x", "axis y", "axis z", "angle, °"};
  for (std::size_t i = 0; i < labels_.size(); ++i)
    labels_.at(i)->setText(QString::fromUtf8(angles ? three[i] : four[i]));
  labels_[6]->setVisible(!angles);
  fields_[6]->setVisible(!angles);
}

std::array<double, 7> PosePanel::numbers() const {
  const double unit = unit_in_metres(unit_->currentText().toStdString()).value_or(1);
  std::array<double, 7> n{pose_.p.x() / unit, pose_.p.y() / unit, pose_.p.z() / unit};
  if (turn() == Turn::roll_pitch_yaw) {
    const Vec3 angles = roll_pitch_yaw(pose_.q) / degree;
    n[3] = angles.x(), n[4] = angles.y(), n[5] = angles.z();
  } else {
    const Eigen::AngleAxisd turned(pose_.q);
    n[3] = turned.axis().x(), n[4] = turned.axis().y(), n[5] = turned.axis().z();
    n[6] = turned.angle() / degree;
  }
  return n;
}

void PosePanel::show_pose(const Pose& X_FM) {
  pose_ = X_FM;
  if (isVisible()) show_numbers();
}

void PosePanel::show_numbers() {
  const std::array<double, 7> n = numbers();
  for (std::size_t i = 0; i < n.size(); ++i) {
    QLineEdit& field = *fields_.at(i);
    const bool typed = field.hasFocus() && field.isModified();
    const QString text =
        is_angle(i) && std::abs(n.at(i)) < least_angle ? QStringLiteral("0") : shown(n.at(i));
    if (!typed && field.text() != text) field.setText(text);
  }
}

/// One number changes; the others stay as they are to the bit, not as they are shown.
void PosePanel::take(std::size_t field) {
  if (!fields_.at(field)->isModified()) return;
  fields_.at(field)->setModified(false);
  const auto typed =
      parse_number(fields_.at(field)->text().trimmed().replace(',', '.').toStdString());
  std::array<double, 7> n = numbers();
  if (!typed || !std::isfinite(*typed)) return show_numbers();
  n.at(field) = *typed;
  Pose wanted = pose_;
  const double unit = unit_in_metres(unit_->currentText().toStdString()).value_or(1);
  if (field < 3) {
    wanted.p[static_cast<Eigen::Index>(field)] = *typed * unit;
  } else if (turn() == Turn::roll_pitch_yaw) {
    wanted.q = of_roll_pitch_yaw(Vec3(n[3], n[4], n[5]) * degree);
  } else {
    const Vec3 axis(n[3], n[4], n[5]);
    if (!(axis.norm() > 0)) return show_numbers();
    wanted.q = Quat(Eigen::AngleAxisd(n[6] * degree, axis.normalized()));
  }
  pose_ = wanted;  // the next number may be typed before the window shows this one
  if (placed) placed(wanted);
}

}  // namespace sonde::ui
