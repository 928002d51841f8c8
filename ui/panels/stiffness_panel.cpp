// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/stiffness_panel.hpp"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "engine/settings/settings.hpp"
#include "engine/study/stability/press_and_hold.hpp"
#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/history_plot.hpp"
#include "ui/panels/map_plot.hpp"
#include "ui/panels/scrolled.hpp"
#include "ui/tuning/recommendation_text.hpp"

namespace sonde::ui {
namespace {

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

MapPoint point_of(const Coupling& gains, GainAxis axis) {
  if (axis == GainAxis::object) return {gains.k, 0};
  return axis == GainAxis::rotation ? MapPoint{gains.k_r, gains.b_r}
                                    : MapPoint{gains.k_t, gains.b_t};
}

QString words_of(GainAxis axis) {
  if (axis == GainAxis::object) return QStringLiteral("object norm");
  if (axis == GainAxis::together) return QStringLiteral("all gains together");
  return QLatin1String(name_of(axis)) + QStringLiteral(" alone");
}

QString words_of(const Coupling& gains) {
  if (gains.mode == Coupling::Mode::object) return QStringLiteral("k %1 N/m").arg(number(gains.k));
  return QStringLiteral("k_t %1 N/m\nk_r %2 N·m/rad").arg(number(gains.k_t), number(gains.k_r));
}

QLabel* wrapped(const char* object, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(object));
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

}  // namespace

StiffnessPanel::StiffnessPanel(const std::vector<std::string>& device_ids, QWidget* parent)
    : QDockWidget(QStringLiteral("Stiffness"), parent) {
  setObjectName(QStringLiteral("stiffness_panel"));
  const auto [scroll, content, layout] = scrolled(*this);
  layout->setSpacing(4);
  build_last_second(*layout);
  build_sets(*layout);
  build_map(*layout);
  build_recommendation(*layout);
  build_source(*layout, device_ids);
  layout->addStretch();
  show_tuning({});
  show_buzz({}, 0);
}

QPushButton* StiffnessPanel::button(const QString& text, const char* object, const QString& doc) {
  auto* out = new QPushButton(text, this);
  out->setObjectName(QLatin1String(object));
  out->setToolTip(doc);
  return out;
}

void StiffnessPanel::build_last_second(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Last second, measured"), this);
  auto* form = new QFormLayout(group);
  form->setContentsMargins(0, 4, 0, 0);
  form->setVerticalSpacing(3);
  const auto value = [&](const QString& name, const char* object, const QString& doc) {
    auto* label = new QLabel(name, group);
    auto* number = new QLabel(group);
    number->setObjectName(QLatin1String(object));
    number->setAlignment(Qt::AlignRight);
    number->setTextFormat(Qt::RichText);
    label->setToolTip(doc);
    number->setToolTip(doc);
    form->addRow(label, number);
    return number;
  };
  chatter_ = value(QStringLiteral("chatter index"), "chatter_value",
                   QStringLiteral("The share of the wrench's power above 50 Hz. Beyond %1 %, where "
                                  "a twentieth of the wrench buzzes, a study calls it chattering.")
                       .arg(100 * chatter_limit));
  energy_ = value(QStringLiteral("energy to the hand"), "energy_value",
                  QStringLiteral("Net work of force and torque on the hand. Over a whole contact a "
                                 "passive wall gives none."));
  chatter_plot_ = new HistoryPlot(QStringLiteral("chatter index"), colour::contact, group);
  chatter_plot_->set_unit(100, QStringLiteral("%"));
  form->addRow(chatter_plot_);
  layout.addWidget(group);
}

void StiffnessPanel::build_sets(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Gains A and B"), this);
  auto* row = new QHBoxLayout(group);
  row->setContentsMargins(0, 4, 0, 0);
  for (std::size_t i = 0; i < sets_.size(); ++i) {
    sets_[i] = button({}, i == 0 ? "gains_a" : "gains_b",
                      QStringLiteral("Two sets of gains to feel one after the other (B). The "
                                     "sliders change the one that is pressed."));
    sets_[i]->setCheckable(true);
    sets_[i]->setStyleSheet(
        QStringLiteral("QPushButton:checked { background: #26809a; color: white; font-weight: 600; "
                       "border: 1px solid #57d3ff; padding: 4px; }"));
    connect(sets_[i], &QPushButton::clicked, this, [this, i](bool on) {
      if (on && switch_asked) return switch_asked();
      sets_[i]->setChecked(true);  // pressed already
    });
    row->addWidget(sets_[i]);
  }
  layout.addWidget(group);
}

void StiffnessPanel::build_map(QVBoxLayout& layout) {
  map_box_ = new QGroupBox(QStringLiteral("Stability map"), this);
  auto* box = new QVBoxLayout(map_box_);
  box->setContentsMargins(0, 4, 0, 0);
  doubt_ = wrapped("tuning_doubt", map_box_);
  doubt_->setStyleSheet(
      QStringLiteral("background: %1; color: black; padding: 3px").arg(colour::contact.name()));
  box->addWidget(doubt_);
  auto* row = new QHBoxLayout;
  axes_ = new QComboBox(map_box_);
  axes_->setObjectName(QStringLiteral("map_axis"));
  shown_kinds_ = new QComboBox(map_box_);
  shown_kinds_->setObjectName(QStringLiteral("map_kind"));
  row->addWidget(axes_);
  row->addWidget(shown_kinds_);
  box->addLayout(row);
  for (QComboBox* list : {axes_, shown_kinds_})
    connect(list, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] { show_map(); });
  plot_ = new MapPlot(map_box_);
  box->addWidget(plot_);
  place_ = wrapped("map_place", map_box_);
  box->addWidget(place_);
  layout.addWidget(map_box_);
}

void StiffnessPanel::build_recommendation(QVBoxLayout& layout) {
  words_ = wrapped("recommendation", this);
  layout.addWidget(words_);
  apply_ = button(QStringLiteral("Apply the recommended gains"), "apply_recommended",
                  QStringLiteral("They act at once, and can be undone."));
  connect(apply_, &QPushButton::clicked, this, [this] {
    if (apply_asked) apply_asked();
  });
  layout.addWidget(apply_);
}

void StiffnessPanel::build_source(QVBoxLayout& layout, const std::vector<std::string>& device_ids) {
  auto* group = new QGroupBox(QStringLiteral("Study"), this);
  auto* box = new QVBoxLayout(group);
  box->setContentsMargins(0, 4, 0, 0);
  source_ = wrapped("tuning_source", group);
  box->addWidget(source_);
  auto* row = new QHBoxLayout;
  devices_ = new QComboBox(group);
  devices_->setObjectName(QStringLiteral("tuning_device"));
  devices_->setToolTip(QStringLiteral("The device to compute for."));
  for (const std::string& id : device_ids) devices_->addItem(text(id));
  kinds_ = new QComboBox(group);
  kinds_->setObjectName(QStringLiteral("tuning_kind"));
  kinds_->setToolTip(QStringLiteral("The contacts to compute for. One kind is quicker than all."));
  kinds_->addItem(QStringLiteral("all contacts"));
  for (const std::string& kind : situation_kinds()) kinds_->addItem(text(kind));
  row->addWidget(devices_);
  row->addWidget(kinds_);
  box->addLayout(row);
  auto* buttons = new QHBoxLayout;
  auto* compute = button(
      QStringLiteral("Compute…"), "compute_tuning",
      QStringLiteral("Computes as sonde tune does, into a folder; finished parts are kept."));
  compute->setEnabled(!device_ids.empty());
  auto* load = button(QStringLiteral("Load…"), "load_tuning",
                      QStringLiteral("A folder that sonde tune has written."));
  connect(compute, &QPushButton::clicked, this, [this] {
    if (compute_asked) compute_asked();
  });
  connect(load, &QPushButton::clicked, this, [this] {
    if (load_asked) load_asked();
  });
  buttons->addWidget(compute);
  buttons->addWidget(load);
  box->addLayout(buttons);
  layout.addWidget(group);
}

void StiffnessPanel::clear_history() {
  chatter_plot_->clear();
  show_buzz({}, 0);
}

void StiffnessPanel::show_tuning(const std::optional<Tuning>& tuning) {
  tuning_ = tuning;
  map_box_->setVisible(tuning_.has_value());
  words_->setVisible(tuning_.has_value());
  apply_->setVisible(tuning_ && has_recommendation(tuning_->results));
  source_->setText(tuning_ ? QStringLiteral("%1, for %2.")
                                 .arg(QFileInfo(text(tuning_->folder.string())).fileName(),
                                      text(tuning_->results.device_id))
                           : QStringLiteral("There is no map yet: compute one for what is open, or "
                                            "load what sonde tune has written."));
  source_->setToolTip(tuning_ ? text(tuning_->folder.string()) : QString());
  choose_axes();
  show_doubt();
  show_map();
}

void StiffnessPanel::choose_axes() {
  const QSignalBlocker quiet_axes(axes_), quiet_kinds(shown_kinds_);
  axes_->clear();
  shown_kinds_->clear();
  if (!tuning_) return;
  for (const GainAxis each : axes_of(tuning_->results))
    axes_->addItem(words_of(each), static_cast<int>(each));
  axes_->setVisible(axes_->count() > 1);
  shown_kinds_->addItem(QStringLiteral("all contacts"));
  for (const std::string& kind : kinds_of(tuning_->results)) shown_kinds_->addItem(text(kind));
}

GainAxis StiffnessPanel::axis() const {
  return static_cast<GainAxis>(axes_->currentData().toInt());
}

void StiffnessPanel::show_map() {
  if (!tuning_) return;
  const std::string kind =
      shown_kinds_->currentIndex() > 0 ? shown_kinds_->currentText().toStdString() : std::string();
  plot_->set_map(stability_map(tuning_->results, axis(), kind));
  const bool any = has_recommendation(tuning_->results);
  plot_->set_recommended(
      any ? std::optional(point_of(recommended_coupling(tuning_->results), axis())) : std::nullopt);
  words_->setText(recommendation_text(tuning_->results, axis()));
  show_point();
}

void StiffnessPanel::show_device(const std::string& id) {
  simulated_ = id;
  if (const int at = devices_->findText(text(id)); at >= 0) devices_->setCurrentIndex(at);
  show_doubt();
}

void StiffnessPanel::show_doubt() {
  QStringList doubts;
  if (tuning_ && !tuning_->doubt.isEmpty()) doubts << tuning_->doubt;
  if (tuning_ && !simulated_.empty() && simulated_ != tuning_->results.device_id)
    doubts << QStringLiteral("This map is of another device: %1, not %2.")
                  .arg(text(tuning_->results.device_id), text(simulated_));
  doubt_->setText(doubts.join('\n'));
  doubt_->setVisible(!doubts.isEmpty());
}

void StiffnessPanel::show_gains(const Coupling& now) {
  now_ = now;
  if (tuning_) show_point();
}

void StiffnessPanel::show_point() {
  const bool drawn = now_.mode == tuning_->results.mode;
  const MapPoint point = point_of(now_, axis());
  plot_->set_now(drawn ? std::optional(point) : std::nullopt);
  if (!drawn)
    return place_->setText(QStringLiteral("The map is of the %1 coupling, the sliders are not.")
                               .arg(QLatin1String(name_of(tuning_->results.mode))));
  const auto gains = recommend(tuning_->results, axis());
  const auto found = plot_->map_class(point);
  QString words = QStringLiteral("Now: %1 = %2 %3, %4")
                      .arg(QLatin1String(stiffness_key(axis())), number(point.stiffness),
                           stiffness_unit(axis()),
                           found ? QLatin1String(name_of(*found)) : QStringLiteral("off the map"));
  const QString margin = gains ? margin_text(*gains, point.stiffness) : QString();
  place_->setText(words + (margin.isEmpty() ? QString() : QStringLiteral("; ") + margin));
}

void StiffnessPanel::show_sets(const std::array<Coupling, 2>& sets, std::size_t active) {
  for (std::size_t i = 0; i < sets_.size(); ++i) {
    sets_[i]->setChecked(i == active);
    sets_[i]->setText((i == 0 ? QStringLiteral("A: ") : QStringLiteral("B: ")) + words_of(sets[i]));
  }
}

void StiffnessPanel::show_buzz(const std::optional<Buzz>& buzz, double time) {
  if (!buzz) {
    chatter_->setText(QStringLiteral("–"));
    energy_->setText(QStringLiteral("–"));
    return;
  }
  const bool buzzes = buzz->chatter > chatter_limit;
  const QString percent = number(100 * buzz->chatter) + QStringLiteral(" %");
  chatter_->setText(buzzes ? in_colour(colour::force, percent + QStringLiteral(", buzzing"))
                           : percent);
  energy_->setText(number(1e3 * buzz->energy) + QStringLiteral(" mJ"));
  chatter_plot_->add(time, buzz->chatter);
  chatter_plot_->update();
}

std::string StiffnessPanel::device_id() const { return devices_->currentText().toStdString(); }

std::string StiffnessPanel::kind() const {
  return kinds_->currentIndex() > 0 ? kinds_->currentText().toStdString() : std::string();
}

}  // namespace sonde::ui
