// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/seeing_panel.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/panels/number_field.hpp"
#include "ui/panels/scrolled.hpp"

namespace sonde::ui {
namespace {

constexpr int slider_end = 1000;

QPushButton* button(QWidget* parent, const char* text, const char* object, const char* tip,
                    const std::function<void()>& pressed) {
  auto* made = new QPushButton(QString::fromUtf8(text), parent);
  made->setObjectName(QLatin1String(object));
  made->setToolTip(QString::fromUtf8(tip));
  QObject::connect(made, &QPushButton::clicked, parent, pressed);
  return made;
}

}  // namespace

SeeingPanel::SeeingPanel(QWidget* parent) : QDockWidget(QStringLiteral("Seeing"), parent) {
  setObjectName(QStringLiteral("seeing_panel"));
  const Scrolled dock = scrolled(*this);
  add_looks(*dock.layout);
  add_cut(*dock.layout);
  add_gap(*dock.layout);
  add_saved(*dock.layout);
  dock.layout->addStretch();
  show_seeing({});
}

void SeeingPanel::add_looks(QVBoxLayout& layout) {
  auto* form = new QFormLayout;
  layout.addLayout(form);
  const auto add = [&](const char* text, const char* object) {
    auto* box = new QComboBox(this);
    box->setObjectName(QLatin1String(object));
    box->addItems({QStringLiteral("opaque"), QStringLiteral("x-ray"), QStringLiteral("wireframe"),
                   QStringLiteral("hidden")});
    form->addRow(QString::fromUtf8(text), box);
    connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, &SeeingPanel::say);
    return box;
  };
  fixed_ = add("Fixed body", "fixed_look");
  probe_ = add("Probe", "probe_look");
}

void SeeingPanel::add_cut(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Cut plane"), this);
  layout.addWidget(group);
  auto* grid = new QGridLayout(group);
  const auto check = [&](const char* text, const char* object) {
    auto* box = new QCheckBox(QString::fromUtf8(text), group);
    box->setObjectName(QLatin1String(object));
    connect(box, &QCheckBox::toggled, this, &SeeingPanel::say);
    return box;
  };
  cut_ = check("Cut", "cut_on");
  cut_fixed_ = check("the fixed body", "cut_fixed");
  cut_probe_ = check("the probe", "cut_probe");
  grid->addWidget(cut_, 0, 0);
  grid->addWidget(cut_fixed_, 0, 1);
  grid->addWidget(cut_probe_, 0, 2);
  const auto across = [this](const Vec3& normal) {
    seeing_.cut.normal = normal;
    seeing_.cut.point = centre_;
    cut_->setChecked(true);
    say();
  };
  const Vec3 axes[] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  const char* const names[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i)
    grid->addWidget(
        button(group, names[i], QStringLiteral("cut_%1").arg(QLatin1String(names[i])).toLatin1(),
               "Across this axis of the fixed body, through its middle",
               [across, axis = axes[i]] { across(axis); }),
        1, i);
  grid->addWidget(button(group, "Flip", "cut_flip", "The other half",
                         [this] {
                           seeing_.cut.normal = -seeing_.cut.normal;
                           say();
                         }),
                  2, 0);
  grid->addWidget(
      button(group, "Eye", "cut_face", "Across the line of sight", [this] { emit face_wanted(); }),
      2, 1);
  grid->addWidget(button(group, "Contact", "cut_snap",
                         "Through the marked contact, or the one with the largest share",
                         [this] { emit snap_wanted(); }),
                  2, 2);
  place_ = new QSlider(Qt::Horizontal, group);
  place_->setObjectName(QStringLiteral("cut_place"));
  place_->setRange(-slider_end, slider_end);
  place_->setToolTip(QStringLiteral("Along its normal; in the view, drag the arrow"));
  connect(place_, &QSlider::valueChanged, this, &SeeingPanel::move_cut);
  grid->addWidget(place_, 3, 0, 1, 3);
}

void SeeingPanel::add_gap(QVBoxLayout& layout) {
  auto* row = new QHBoxLayout;
  gap_label_ = new QLabel(this);
  gap_ = new NumberField(this);
  gap_->setObjectName(QStringLiteral("gap_reach"));
  gap_->setPlaceholderText(QStringLiteral("fits the gaps"));
  gap_->setToolTip(
      QStringLiteral("The gap of the last colour; larger gaps are not coloured. Empty: "
                     "a few times the clearance when the colours are switched on"));
  row->addWidget(gap_label_);
  row->addWidget(gap_, 1);
  layout.addLayout(row);
  connect(gap_, &QLineEdit::editingFinished, this, [this] {
    const double typed = gap_->number() * unit_.metres();
    const bool any = typed > 0 && std::isfinite(typed);
    if (!any) gap_->clear();
    emit gap_reach_changed(any ? std::optional(typed) : std::nullopt);
  });
}

void SeeingPanel::add_saved(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Saved views"), this);
  layout.addWidget(group);
  auto* grid = new QGridLayout(group);
  saved_ = new QListWidget(group);
  saved_->setObjectName(QStringLiteral("saved_views"));
  saved_->setMaximumHeight(110);
  grid->addWidget(saved_, 0, 0, 1, 2);
  connect(saved_, &QListWidget::itemActivated, this,
          [this](QListWidgetItem* item) { emit view_wanted(saved_->row(item)); });
  connect(saved_, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { emit view_wanted(saved_->row(item)); });
  grid->addWidget(button(group, "Save this view", "view_save", "Kept with the scene",
                         [this] { emit save_wanted(); }),
                  1, 0);
  grid->addWidget(button(group, "Forget", "view_forget", "The one that is chosen",
                         [this] {
                           if (saved_->currentRow() >= 0) emit forget_wanted(saved_->currentRow());
                         }),
                  1, 1);
}

void SeeingPanel::show_seeing(const Seeing& seeing) {
  seeing_ = seeing;
  showing_ = true;
  fixed_->setCurrentIndex(static_cast<int>(seeing.fixed));
  probe_->setCurrentIndex(static_cast<int>(seeing.probe));
  cut_->setChecked(seeing.cut.on);
  cut_fixed_->setChecked(seeing.cut.fixed);
  cut_probe_->setChecked(seeing.cut.probe);
  const double part = (seeing.cut.point - centre_).dot(seeing.cut.normal) / radius_;
  place_->setValue(static_cast<int>(std::clamp(part, -1.0, 1.0) * slider_end));
  showing_ = false;
}

void SeeingPanel::set_extent(const Vec3& centre, double radius) {
  centre_ = centre;
  radius_ = std::max(radius, 1e-12);
  unit_ = LengthUnit(radius_);
  gap_label_->setText(QStringLiteral("Colours of the gap up to, %1").arg(unit_.name()));
  show_seeing(seeing_);
}

void SeeingPanel::show_saved(const QStringList& names) {
  QStringList shown;
  for (int i = 0; i < saved_->count(); ++i) shown << saved_->item(i)->text();
  if (shown == names) return;
  saved_->clear();
  saved_->addItems(names);
}

void SeeingPanel::say() {
  if (showing_) return;
  seeing_.fixed = static_cast<Look>(fixed_->currentIndex());
  seeing_.probe = static_cast<Look>(probe_->currentIndex());
  seeing_.cut.on = cut_->isChecked();
  seeing_.cut.fixed = cut_fixed_->isChecked();
  seeing_.cut.probe = cut_probe_->isChecked();
  emit changed(seeing_);
}

void SeeingPanel::move_cut(int place) {
  if (showing_) return;
  const Vec3& normal = seeing_.cut.normal;
  const double now = (seeing_.cut.point - centre_).dot(normal);
  seeing_.cut.point += normal * (radius_ * place / slider_end - now);
  say();
}

}  // namespace sonde::ui
