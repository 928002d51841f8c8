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
constexpr double first_steps = 200, most_steps = 1e5;
constexpr double first_across = 21, most_across = 501;
constexpr double first_tilt = 2;  // degrees

/// What is no number counts as the first.
std::size_t count_in(const NumberField& field, double first, double most) {
  const double count = field.number();
  return static_cast<std::size_t>(std::isfinite(count) ? std::clamp(count, 1.0, most) : first);
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

void WayInPanel::build_way(QVBoxLayout& layout) {
  kind_->setObjectName(QStringLiteral("way_kind"));
  kind_->addItems({QStringLiteral("along an axis"), QStringLiteral("along the recorded path")});
  layout.addWidget(kind_);
  auto* grid = new QGridLayout;
  const char* const names[] = {"way_x", "way_y", "way_z"};
  auto* axes = new QHBoxLayout;
  for (std::size_t i = 0; i < 3; ++i) {
    axis_.at(i) = field(names[i], "The direction, in the fixed body's mesh frame, of any length");
    axes->addWidget(axis_.at(i));
  }
  grid->addWidget(new QLabel(QStringLiteral("axis"), this), 0, 0);
  grid->addLayout(axes, 0, 1);
  face_ = button("Face", "way_face", "The next click in the view: into the face that it hits");
  edge_ = button("Edge", "way_edge", "The next click in the view: along the edge next to it");
  flip_ = button("Flip", "way_flip", "The other way");
  auto* picks = new QHBoxLayout;
  for (QPushButton* pick : {face_, edge_, flip_}) picks->addWidget(pick);
  for (QPushButton* pick : {face_, edge_}) pick->setCheckable(true);
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
  work_->start_wanted = [this] { compute_wanted(); };
  work_->stop_wanted = [this] { stop_wanted(); };
  layout.addWidget(work_);
  connect(kind_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int kind) {
    for (QWidget* of_axis : {static_cast<QWidget*>(axis_[0]), static_cast<QWidget*>(axis_[1]),
                             static_cast<QWidget*>(axis_[2]), static_cast<QWidget*>(face_),
                             static_cast<QWidget*>(edge_), static_cast<QWidget*>(flip_),
                             static_cast<QWidget*>(travel_), static_cast<QWidget*>(twist_),
                             static_cast<QWidget*>(map_work_)})
      of_axis->setEnabled(kind == 0);
  });
  connect(face_, &QPushButton::clicked, this, [this](bool on) { face_wanted(on); });
  connect(edge_, &QPushButton::clicked, this, [this](bool on) { edge_wanted(on); });
  connect(flip_, &QPushButton::clicked, this, [this] { show_axis(-wanted().axis); });
}

void WayInPanel::build_result(QVBoxLayout& layout) {
  summary_ = new QLabel(this);
  summary_->setObjectName(QStringLiteral("way_summary"));
  summary_->setWordWrap(true);
  summary_->setTextFormat(Qt::PlainText);
  layout.addWidget(summary_);
  plot_ = new TravelPlot(this);
  plot_->sought = [this](double travel) { sought(travel); };
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
  connect(play_, &QPushButton::clicked, this, [this](bool on) { play_wanted(on); });
  connect(first_, &QPushButton::clicked, this, [this] { first_wanted(); });
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
  layout.addLayout(grid);
  map_work_ = new WorkRow(QStringLiteral("Map what goes in"), QStringLiteral("map_compute"), this);
  map_work_->start_wanted = [this] { map_asked(); };
  map_work_->stop_wanted = [this] { map_stop_wanted(); };
  layout.addWidget(map_work_);
  map_words_ = new QLabel(this);
  map_words_->setObjectName(QStringLiteral("map_words"));
  map_words_->setWordWrap(true);
  map_words_->setTextFormat(Qt::PlainText);
  layout.addWidget(map_words_);
  map_ = new OffsetPlot(this);
  map_->asked = [this](const MapPlace& place) { map_place_wanted(place); };
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
  show_map_progress({});
  show_map({}, {});
  twist_->show_number(0);
  steps_->show_number(first_steps);
  show_picking(false, false);
  show_progress({});
  show_result({}, {});
}

WayWanted WayInPanel::wanted() const {
  WayWanted way;
  way.along_path = kind_->currentIndex() == 1;
  way.axis = {axis_[0]->number(), axis_[1]->number(), axis_[2]->number()};
  way.travel = travel_->number() * unit_.metres();
  way.twist = twist_->number() * per_degree;
  way.steps = count_in(*steps_, first_steps, most_steps);
  return way;
}

MapWanted WayInPanel::map_wanted() const {
  return {offset_->number() * unit_.metres(), tilt_->number() * per_degree,
          count_in(*across_, first_across, most_across)};
}

void WayInPanel::show_axis(const Vec3& axis) {
  for (std::size_t i = 0; i < 3; ++i) axis_.at(i)->show_number(axis[static_cast<Eigen::Index>(i)]);
}

void WayInPanel::show_picking(bool face, bool edge) {
  face_->setChecked(face);
  edge_->setChecked(edge);
}

void WayInPanel::show_progress(std::optional<double> fraction) { work_->show_progress(fraction); }

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

void WayInPanel::show_map_progress(std::optional<double> fraction) {
  map_work_->show_progress(fraction);
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
