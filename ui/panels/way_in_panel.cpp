// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/way_in_panel.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "ui/panels/number_field.hpp"
#include "ui/panels/scrolled.hpp"
#include "ui/panels/work_row.hpp"

namespace sonde::ui {
namespace {

constexpr double per_degree = std::numbers::pi / 180;
constexpr double first_steps = 200, first_across = 21;
constexpr double first_tilt = 2;  // degrees

Vec3 vector_in(const std::array<NumberField*, 3>& fields) {
  return {fields[0]->number(), fields[1]->number(), fields[2]->number()};
}

void show_in(const std::array<NumberField*, 3>& fields, const Vec3& x) {
  for (std::size_t i = 0; i < 3; ++i) fields.at(i)->show_number(x[static_cast<Eigen::Index>(i)]);
}

}  // namespace

WayInPanel::WayInPanel(QWidget* parent)
    : QDockWidget(QStringLiteral("Way in"), parent), kind_(new QComboBox(this)) {
  setObjectName(QStringLiteral("way_in_panel"));
  const Scrolled dock = scrolled(*this);
  build_way(*dock.layout);
  build_result(*dock.layout);
  build_map(*dock.layout);
  dock.layout->addStretch();
  take(0.05, false);
}

QPushButton* WayInPanel::button(const char* text, const char* object, const char* doc) {
  auto* made = new QPushButton(QString::fromUtf8(text), this);
  made->setObjectName(QLatin1String(object));
  made->setToolTip(QString::fromUtf8(doc));
  return made;
}

NumberField* WayInPanel::field(const char* object, const char* doc) {
  auto* made = new NumberField(this);
  made->setObjectName(QLatin1String(object));
  made->setToolTip(QString::fromUtf8(doc));
  made->setMinimumWidth(40);
  return made;
}

QPushButton* WayInPanel::pick_button(WayPick what, const char* object, const char* doc) {
  const bool face = what == WayPick::axis_face || what == WayPick::side_face;
  auto* made = button(face ? "Face" : "Edge", object, doc);
  made->setCheckable(true);
  connect(made, &QPushButton::clicked, this,
          [this, what](bool on) { emit pick_wanted(on ? what : WayPick::nothing); });
  picks_.at(static_cast<std::size_t>(what)) = made;
  return made;
}

QHBoxLayout* WayInPanel::fields(std::array<NumberField*, 3>& of,
                                const std::array<const char*, 3>& objects, const char* doc) {
  auto* row = new QHBoxLayout;
  for (std::size_t i = 0; i < 3; ++i) {
    of.at(i) = field(objects.at(i), doc);
    row->addWidget(of.at(i));
  }
  return row;
}

void WayInPanel::build_way(QVBoxLayout& layout) {
  kind_->setObjectName(QStringLiteral("way_kind"));
  kind_->addItems({QStringLiteral("along an axis"), QStringLiteral("along the recorded path")});
  layout.addWidget(kind_);
  auto* grid = new QGridLayout;
  grid->addWidget(new QLabel(QStringLiteral("axis"), this), 0, 0);
  grid->addLayout(fields(axis_, {"way_x", "way_y", "way_z"},
                         "The direction, in the fixed body's mesh frame, of any length"),
                  0, 1);
  auto* picks = new QHBoxLayout;
  picks->addWidget(pick_button(WayPick::axis_face, "way_face",
                               "The next click in the view: into the face that it hits"));
  picks->addWidget(pick_button(WayPick::axis_edge, "way_edge",
                               "The next click in the view: along the edge next to it"));
  flip_ = button("Flip", "way_flip", "The other way");
  picks->addWidget(flip_);
  grid->addLayout(picks, 1, 1);
  travel_ = field("way_travel", "How far the centre of mass goes, from where the probe is");
  twist_ = field("way_twist",
                 "By how much it turns on the way about the axis through its centre of mass: a "
                 "screw");
  steps_ = field("way_steps", "Places along the way; more of them about the first contact");
  travel_label_ = new QLabel(this);
  grid->addWidget(travel_label_, 2, 0);
  grid->addWidget(travel_, 2, 1);
  grid->addWidget(new QLabel(QStringLiteral("twist, °"), this), 3, 0);
  grid->addWidget(twist_, 3, 1);
  grid->addWidget(new QLabel(QStringLiteral("steps"), this), 4, 0);
  grid->addWidget(steps_, 4, 1);
  layout.addLayout(grid);
  work_ = new WorkRow(QStringLiteral("Try the way in"), QStringLiteral("way_compute"), this);
  connect(work_, &WorkRow::start_wanted, this, &WayInPanel::compute_wanted);
  connect(work_, &WorkRow::stop_wanted, this, &WayInPanel::stop_wanted);
  layout.addWidget(work_);
  connect(kind_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int kind) {
    for (NumberField* along : axis_) along->setEnabled(kind == 0);
    for (QPushButton* pick : picks_)
      if (pick) pick->setEnabled(kind == 0);
    for (QWidget* of_axis : {static_cast<QWidget*>(flip_), static_cast<QWidget*>(travel_),
                             static_cast<QWidget*>(twist_), static_cast<QWidget*>(map_work_)})
      of_axis->setEnabled(kind == 0);
  });
  connect(flip_, &QPushButton::clicked, this, [this] { show_axis(-axis()); });
}

void WayInPanel::build_result(QVBoxLayout& layout) {
  summary_ = new QLabel(this);
  summary_->setObjectName(QStringLiteral("way_summary"));
  summary_->setWordWrap(true);
  summary_->setTextFormat(Qt::PlainText);
  layout.addWidget(summary_);
  plot_ = new TravelPlot(this);
  connect(plot_, &TravelPlot::sought, this, &WayInPanel::sought);
  layout.addWidget(plot_);
  at_ = new QLabel(this);
  at_->setObjectName(QStringLiteral("way_at"));
  at_->setWordWrap(true);
  layout.addWidget(at_);
  play_ = button("▶ Play", "way_play", "The probe goes the way, as the hand would feel it");
  play_->setCheckable(true);
  first_ = button("To where it binds", "way_first", "The probe goes to the first contact");
  auto* row = new QHBoxLayout;
  row->addWidget(play_);
  row->addWidget(first_);
  layout.addLayout(row);
  connect(play_, &QPushButton::clicked, this, &WayInPanel::play_wanted);
  connect(first_, &QPushButton::clicked, this, &WayInPanel::first_wanted);
}

void WayInPanel::build_map(QVBoxLayout& layout) {
  offset_ = field("map_offset", "The largest offset to either side, square to the axis");
  tilt_ = field("map_tilt", "The largest tilt to either side, about the centre of mass");
  across_ =
      field("map_across", "How many offsets, and how many tilts; odd, so that 0 is among them");
  offset_label_ = new QLabel(this);
  auto* grid = new QGridLayout;
  grid->addWidget(offset_label_, 0, 0);
  grid->addWidget(offset_, 0, 1);
  grid->addWidget(new QLabel(QStringLiteral("tilt, ± °"), this), 1, 0);
  grid->addWidget(tilt_, 1, 1);
  grid->addWidget(new QLabel(QStringLiteral("of each"), this), 2, 0);
  grid->addWidget(across_, 2, 1);
  grid->addWidget(new QLabel(QStringLiteral("aside"), this), 3, 0);
  grid->addLayout(fields(side_, {"map_x", "map_y", "map_z"},
                         "Along which the offsets are, in the fixed body's mesh frame: what of it "
                         "is square to the axis. Empty: along the coordinate that the axis has "
                         "least of"),
                  3, 1);
  auto* picks = new QHBoxLayout;
  picks->addWidget(pick_button(WayPick::side_face, "map_face",
                               "The next click in the view: into the face that it hits"));
  picks->addWidget(pick_button(WayPick::side_edge, "map_edge",
                               "The next click in the view: along the edge next to it"));
  grid->addLayout(picks, 4, 1);
  layout.addLayout(grid);
  map_work_ = new WorkRow(QStringLiteral("Map what goes in"), QStringLiteral("map_compute"), this);
  connect(map_work_, &WorkRow::start_wanted, this, &WayInPanel::map_asked);
  connect(map_work_, &WorkRow::stop_wanted, this, &WayInPanel::map_stop_wanted);
  layout.addWidget(map_work_);
  map_words_ = new QLabel(this);
  map_words_->setObjectName(QStringLiteral("map_words"));
  map_words_->setWordWrap(true);
  map_words_->setTextFormat(Qt::PlainText);
  layout.addWidget(map_words_);
  map_ = new OffsetPlot(this);
  connect(map_, &OffsetPlot::asked, this, &WayInPanel::map_place_wanted);
  layout.addWidget(map_);
}

void WayInPanel::take(double radius, bool has_path) {
  unit_ = LengthUnit(radius);
  kind_->setCurrentIndex(0);
  kind_->setEnabled(has_path);
  travel_label_->setText(QStringLiteral("travel, %1").arg(unit_.name()));
  show_axis(-Vec3::UnitZ());
  travel_->show_number(round_down_125(2 * radius) / unit_.metres());
  offset_label_->setText(QStringLiteral("offset, ± %1").arg(unit_.name()));
  offset_->show_number(round_down_125(radius / 50) / unit_.metres());
  tilt_->show_number(first_tilt);
  across_->show_number(first_across);
  for (NumberField* aside : side_) aside->clear();
  show_map_progress({});
  show_map({}, {});
  twist_->show_number(0);
  steps_->show_number(first_steps);
  show_picking(WayPick::nothing);
  show_progress({});
  show_result({}, {});
}

WayWanted WayInPanel::wanted() const {
  WayWanted way;
  way.along_path = kind_->currentIndex() == 1;
  way.axis = axis();
  way.travel = travel_->number() * unit_.metres();
  way.twist = twist_->number() * per_degree;
  way.steps = steps_->number();
  return way;
}

MapWanted WayInPanel::map_wanted() const {
  MapWanted map;
  map.offset = offset_->number() * unit_.metres();
  map.tilt = tilt_->number() * per_degree;
  map.across = across_->number();
  const bool any = std::ranges::any_of(
      side_, [](const NumberField* aside) { return !aside->text().trimmed().isEmpty(); });
  if (any) map.lateral = vector_in(side_);
  return map;
}

Vec3 WayInPanel::axis() const { return vector_in(axis_); }

void WayInPanel::show_axis(const Vec3& axis) { show_in(axis_, axis); }

void WayInPanel::show_side(const Vec3& side) { show_in(side_, side); }

void WayInPanel::show_picking(WayPick what) {
  for (std::size_t i = 0; i < picks_.size(); ++i)
    if (picks_.at(i)) picks_.at(i)->setChecked(i == static_cast<std::size_t>(what));
}

void WayInPanel::show_progress(std::optional<double> fraction, double elapsed) {
  work_->show_progress(fraction, elapsed);
}

void WayInPanel::show_result(const QString& summary, TravelCurves curves) {
  summary_->setText(summary);
  const bool any = curves.travel.size() > 1;
  first_->setEnabled(curves.first.has_value());
  play_->setEnabled(any);
  plot_->setVisible(any);
  at_->clear();
  plot_->set_curves(std::move(curves), unit_);
}

void WayInPanel::show_reason(const QString& reason) { show_result(reason, {}); }

void WayInPanel::show_at(double travel, const QString& words) {
  plot_->show_at(travel);
  at_->setText(words);
}

void WayInPanel::show_map_progress(std::optional<double> fraction, double elapsed) {
  map_work_->show_progress(fraction, elapsed);
}

void WayInPanel::show_map(const QString& words, OffsetMap map) {
  map_words_->setText(words);
  map_->setVisible(!map.free.empty());
  map_->set_map(std::move(map), unit_);
}

void WayInPanel::show_map_place(const MapPlace& place, const QString& words) {
  map_->choose(place);
  map_words_->setText(words);
}

void WayInPanel::show_playing(bool on) {
  play_->setChecked(on);
  play_->setText(on ? QStringLiteral("❚❚ Hold") : QStringLiteral("▶ Play"));
}

}  // namespace sonde::ui
