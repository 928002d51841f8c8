// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/pose_panel.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/text/file_unit.hpp"
#include "engine/text/number_text.hpp"
#include "ui/base/format.hpp"
#include "ui/document/pose_text.hpp"
#include "ui/panels/number_field.hpp"
#include "ui/panels/scrolled.hpp"

namespace sonde::ui {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double least_angle = 1e-6;  // degrees; less is rounding

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
  for (const std::string& name : file_unit_names()) {
    const QString file = QString::fromStdString(name);
    unit_->addItem(file == QStringLiteral("um") ? QStringLiteral("µm") : file, file);
  }
  turn_->setObjectName(QStringLiteral("pose_turn"));
  turn_->addItems({QStringLiteral("roll, pitch, yaw"), QStringLiteral("axis and angle"),
                   QStringLiteral("quaternion"), QStringLiteral("matrix, metres")});
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
  const auto add = [&](const char* text, const char* object, void (PosePanel::*pressed)()) {
    auto* button = new QPushButton(QLatin1String(text), content);
    button->setObjectName(QLatin1String(object));
    connect(button, &QPushButton::clicked, this, pressed);
    return button;
  };
  matrix_ = new QPlainTextEdit(content);
  matrix_->setObjectName(QStringLiteral("pose_matrix"));
  matrix_->setToolTip(
      QStringLiteral("The probe's mesh in the fixed body's, as NumPy has it. Click elsewhere to "
                     "take what is typed."));
  matrix_->setLineWrapMode(QPlainTextEdit::NoWrap);
  matrix_->setFixedHeight(6 * matrix_->fontMetrics().lineSpacing());
  matrix_->installEventFilter(this);
  layout->addWidget(matrix_);
  auto* buttons = new QGridLayout;
  buttons->addWidget(add("Copy pose", "pose_copy", &PosePanel::copy_wanted), 0, 0);
  buttons->addWidget(add("Paste pose", "pose_paste", &PosePanel::paste_wanted), 0, 1);
  buttons->addWidget(add("Copy as NumPy", "pose_copy_matrix", &PosePanel::copy_matrix_wanted), 1,
                     0);
  buttons->addWidget(add("Start from here", "pose_start", &PosePanel::start_wanted), 1, 1);
  buttons->addWidget(add("Swap the bodies", "pose_swap", &PosePanel::swap_wanted), 2, 0);
  layout->addLayout(buttons);
  build_snap(*content, *layout);
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

void PosePanel::build_snap(QWidget& content, QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Snap the probe onto the fixed body"), &content);
  auto* column = new QVBoxLayout(group);
  auto* row = new QHBoxLayout;
  const char* const names[] = {"Face", "Edge", "Axis"};
  const char* const objects[] = {"snap_face", "snap_edge", "snap_axis"};
  const char* const docs[] = {
      "Two clicks in the view: a face of the one body lies on a face of the other",
      "Two clicks in the view: an edge of the one body lies along an edge of the other",
      "Two clicks in the view: the axis of a round face (a shaft) lies along that of a bore"};
  for (std::size_t i = 0; i < snaps_.size(); ++i) {
    auto* button = snaps_.at(i) = new QPushButton(QLatin1String(names[i]), group);
    button->setObjectName(QLatin1String(objects[i]));
    button->setToolTip(QLatin1String(docs[i]));
    button->setCheckable(true);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, i](bool on) {
      emit snap_wanted(on ? std::optional(static_cast<SnapKind>(i)) : std::nullopt);
    });
  }
  column->addLayout(row);
  snap_words_ = new QLabel(group);
  snap_words_->setObjectName(QStringLiteral("snap_words"));
  snap_words_->setWordWrap(true);
  column->addWidget(snap_words_);
  layout.addWidget(group);
  show_snap({}, {});
}

void PosePanel::show_snap(std::optional<SnapKind> kind, const QString& words) {
  for (std::size_t i = 0; i < snaps_.size(); ++i)
    snaps_.at(i)->setChecked(kind == static_cast<SnapKind>(i));
  snap_words_->setText(words);
  snap_words_->setVisible(!words.isEmpty());
}

void PosePanel::build_nudge(QWidget& content, QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Arrow keys, Page Up and Page Down"), &content);
  auto* grid = new QGridLayout(group);
  nudge_axes_ = new QComboBox(group);
  nudge_axes_->setObjectName(QStringLiteral("nudge_axes"));
  nudge_axes_->addItems(
      {QStringLiteral("the picture's axes"), QStringLiteral("the fixed body's x, y, z"),
       QStringLiteral("the probe's x, y, z"), QStringLiteral("the normal of a face")});
  nudge_axes_->setToolTip(QStringLiteral(
      "Of a body and of the scene, left and right are -x and x, down and up -y and y, Page Down "
      "and Page Up -z and z. Page Up goes out of a face, the arrows across it. With Shift the "
      "probe turns about that axis."));
  face_words_ = new QLabel(group);
  face_words_->setObjectName(QStringLiteral("nudge_face"));
  face_words_->setWordWrap(true);
  face_words_->setTextFormat(Qt::PlainText);
  step_label_ = new QLabel(group);
  step_ = new NumberField(group);
  step_->setObjectName(QStringLiteral("nudge_step"));
  step_turn_ = new NumberField(group);
  step_turn_->setObjectName(QStringLiteral("nudge_turn"));
  grid->addWidget(new QLabel(QStringLiteral("along"), group), 0, 0);
  grid->addWidget(nudge_axes_, 0, 1);
  grid->addWidget(face_words_, 1, 0, 1, 2);
  grid->addWidget(step_label_, 2, 0);
  grid->addWidget(step_, 2, 1);
  grid->addWidget(new QLabel(QStringLiteral("with Shift, °"), group), 3, 0);
  grid->addWidget(step_turn_, 3, 1);
  layout.addWidget(group);
  connect(nudge_axes_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          &PosePanel::take_nudge);
  for (QLineEdit* field : {step_, step_turn_})
    connect(field, &QLineEdit::editingFinished, this, &PosePanel::take_nudge);
  show_nudge();
  show_face_words();
}

void PosePanel::show_face(const std::optional<PickedFace>& face) {
  nudge_.face = face;
  show_face_words();
  emit nudge_changed(nudge_);
}

void PosePanel::show_face_words() {
  face_words_->setVisible(nudge_.axes == Nudge::Axes::face);
  face_words_->setText(nudge_.face
                           ? QStringLiteral("The face clicked last, of %1: its normal is (%2).")
                                 .arg(nudge_.face->of, components_text(nudge_.face->normal))
                           : QStringLiteral("None was clicked yet: click on a face in the view."));
}

void PosePanel::set_scene_axes(const Quat& q_FW) {
  constexpr int world = static_cast<int>(Nudge::Axes::world);
  const bool others = q_FW.angularDistance(Quat::Identity()) > least_angle * degree;
  const bool listed = nudge_axes_->count() > world;
  nudge_.q_FW = q_FW;
  if (others && !listed) nudge_axes_->addItem(QStringLiteral("the scene's x, y, z"));
  if (!others && listed) {
    if (nudge_axes_->currentIndex() == world)  // the same lines by another name
      nudge_axes_->setCurrentIndex(static_cast<int>(Nudge::Axes::fixed));
    nudge_axes_->removeItem(world);
  }
  emit nudge_changed(nudge_);
}

void PosePanel::suggest_step(double metres) {
  nudge_.step = metres;
  show_nudge();
  emit nudge_changed(nudge_);
}

/// What is no number above zero changes nothing.
void PosePanel::take_nudge() {
  const auto typed = [](const QLineEdit& field, double& value, double unit) {
    if (!field.isModified()) return;
    const auto read = parse_number(field.text().trimmed().replace(',', '.').toStdString());
    if (read && std::isfinite(*read) && *read > 0) value = *read * unit;
  };
  nudge_.axes = static_cast<Nudge::Axes>(nudge_axes_->currentIndex());
  typed(*step_, nudge_.step, unit_metres());
  typed(*step_turn_, nudge_.turn, degree);
  show_nudge();
  show_face_words();
  emit nudge_changed(nudge_);
}

void PosePanel::show_nudge() {
  const double unit = unit_metres();
  step_label_->setText(QStringLiteral("by, %1").arg(unit_->currentText()));
  step_->setText(number_in_field(nudge_.step / unit));
  step_turn_->setText(number_in_field(nudge_.turn / degree));
}

bool PosePanel::is_angle(std::size_t field) const {
  return (turn() == Turn::roll_pitch_yaw && field >= 3) ||
         (turn() == Turn::axis_angle && field == 6);
}

/// What is typed is taken when the keyboard goes elsewhere.
bool PosePanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == matrix_ && event->type() == QEvent::FocusOut &&
      matrix_->document()->isModified()) {
    matrix_->document()->setModified(false);
    try {
      const Pose typed = pose_in(matrix_->toPlainText().toStdString());
      pose_ = typed;
      emit placed(typed);
    } catch (const std::invalid_argument&) {
      show_numbers();  // what is no pose changes nothing
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

double PosePanel::unit_metres() const {
  return unit_in_metres(unit_->currentData().toString().toStdString()).value_or(1);
}

PosePanel::Turn PosePanel::turn() const { return static_cast<Turn>(turn_->currentIndex()); }

void PosePanel::suggest_unit(const QString& name) {
  const int index = unit_->findText(name);
  if (index >= 0) unit_->setCurrentIndex(index);
}

void PosePanel::show_labels() {
  const char* const names[3][4] = {{"roll, about x, °", "pitch, about y, °", "yaw, about z, °", ""},
                                   {"axis x", "axis y", "axis z", "angle, °"},
                                   {"w", "x", "y", "z"}};
  const char* const position[] = {"x", "y", "z"};
  const auto kind = static_cast<std::size_t>(turn());
  const bool matrix = turn() == Turn::matrix;
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    const bool on_show = i < 3 || (!matrix && *names[kind][i - 3] != 0);
    if (i < 3)
      labels_.at(i)->setText(QLatin1String(position[i]));
    else if (!matrix)
      labels_.at(i)->setText(QString::fromUtf8(names[kind][i - 3]));
    labels_.at(i)->setVisible(on_show);
    fields_.at(i)->setVisible(on_show);
  }
  matrix_->setVisible(matrix);
}

std::array<double, 7> PosePanel::numbers() const {
  const double unit = unit_metres();
  std::array<double, 7> n{pose_.p.x() / unit, pose_.p.y() / unit, pose_.p.z() / unit};
  if (turn() == Turn::roll_pitch_yaw) {
    const Vec3 angles = roll_pitch_yaw(pose_.q) / degree;
    n[3] = angles.x(), n[4] = angles.y(), n[5] = angles.z();
  } else if (turn() == Turn::quaternion) {
    const double sign = pose_.q.w() < 0 ? -1 : 1;  // one of the two that turn alike
    n[3] = sign * pose_.q.w(), n[4] = sign * pose_.q.x();
    n[5] = sign * pose_.q.y(), n[6] = sign * pose_.q.z();
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
    const QString text = is_angle(i) && std::abs(n.at(i)) < least_angle ? QStringLiteral("0")
                                                                        : number_in_field(n.at(i));
    if (!typed && field.text() != text) field.setText(text);
  }
  if (turn() != Turn::matrix || (matrix_->hasFocus() && matrix_->document()->isModified())) return;
  const QString text = QString::fromStdString(matrix_text(pose_)).trimmed();
  if (matrix_->toPlainText() != text) matrix_->setPlainText(text);
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
  const double unit = unit_metres();
  if (field < 3) {
    wanted.p[static_cast<Eigen::Index>(field)] = *typed * unit;
  } else if (turn() == Turn::roll_pitch_yaw) {
    wanted.q = of_roll_pitch_yaw(Vec3(n[3], n[4], n[5]) * degree);
  } else if (turn() == Turn::quaternion) {
    const Quat q(n[3], n[4], n[5], n[6]);
    if (!(q.norm() > 1e-12)) return show_numbers();
    wanted.q = q.normalized();
  } else {
    const Vec3 axis(n[3], n[4], n[5]);
    if (!(axis.norm() > 0)) return show_numbers();
    wanted.q = Quat(Eigen::AngleAxisd(n[6] * degree, axis.normalized()));
  }
  pose_ = wanted;  // the next number may be typed before the window shows this one
  emit placed(wanted);
}

}  // namespace sonde::ui
