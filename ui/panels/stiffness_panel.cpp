// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/stiffness_panel.hpp"

#include <QComboBox>
#include <QFileInfo>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "engine/settings/settings.hpp"
#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/curves_dialog.hpp"
#include "ui/panels/last_second_box.hpp"
#include "ui/panels/map_plot.hpp"
#include "ui/panels/scrolled.hpp"
#include "ui/panels/study_box.hpp"
#include "ui/tuning/gains_text.hpp"
#include "ui/tuning/present_contact.hpp"
#include "ui/tuning/recommendation_text.hpp"

namespace sonde::ui {
namespace {

QString words_of(GainAxis axis) {
  if (axis == GainAxis::object) return QStringLiteral("object norm");
  if (axis == GainAxis::damped) return QStringLiteral("damped object norm");
  if (axis == GainAxis::together) return QStringLiteral("all gains together");
  if (axis == GainAxis::together_b_t) return QStringLiteral("all, b_t by itself");
  if (axis == GainAxis::together_b_r) return QStringLiteral("all, b_r by itself");
  return QLatin1String(name_of(axis)) + QStringLiteral(" alone");
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
    : QDockWidget(QStringLiteral("Stiffness"), parent), known_(device_ids) {
  setObjectName(QStringLiteral("stiffness_panel"));
  const auto [scroll, content, layout] = scrolled(*this);
  layout->setSpacing(4);
  build_sets(*layout);
  progress_ = new StudyProgressRow(this);
  connect(progress_, &StudyProgressRow::stop_asked, this, &StiffnessPanel::stop_asked);
  layout->addWidget(progress_);
  last_second_ = new LastSecondBox(this);
  layout->addWidget(last_second_);
  build_map(*layout);
  words_ = wrapped("recommendation", this);
  layout->addWidget(words_);
  build_study(*layout, device_ids);
  layout->addStretch();
  show_tuning({});
}

QPushButton* StiffnessPanel::button(const QString& text, const char* object, const QString& doc) {
  auto* out = new QPushButton(text, this);
  out->setObjectName(QLatin1String(object));
  out->setToolTip(doc);
  return out;
}

void StiffnessPanel::build_sets(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Gains A and B"), this);
  auto* box = new QVBoxLayout(group);
  box->setContentsMargins(0, 4, 0, 0);
  auto* row = new QHBoxLayout;
  box->addLayout(row);
  for (std::size_t i = 0; i < sets_.size(); ++i) {
    sets_[i] = button({}, i == 0 ? "gains_a" : "gains_b",
                      QStringLiteral("Two sets of gains to feel one after the other (B). The "
                                     "sliders change the one that is pressed."));
    sets_[i]->setCheckable(true);
    sets_[i]->setStyleSheet(
        QStringLiteral("QPushButton:checked { background: #26809a; color: white; font-weight: 600; "
                       "border: 1px solid #57d3ff; padding: 4px; }"
                       "QPushButton:checked:hover { background: #2f98b8; }"
                       "QPushButton:checked:pressed { background: #174f5f; }"));
    connect(sets_[i], &QPushButton::clicked, this, [this, i](bool on) {
      if (on) return emit switch_asked();
      sets_[i]->setChecked(true);  // pressed already
    });
    row->addWidget(sets_[i]);
  }
  apply_ =
      button({}, "apply_recommended",
             QStringLiteral("The recommended gains act at once in the set that is pressed, and "
                            "can be undone."));
  connect(apply_, &QPushButton::clicked, this, &StiffnessPanel::apply_asked);
  box->addWidget(apply_);
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
    connect(list, qOverload<int>(&QComboBox::currentIndexChanged), this, &StiffnessPanel::show_map);
  plot_ = new MapPlot(map_box_);
  connect(plot_, &MapPlot::asked, this, [this](const MapPoint& point) {
    emit gains_asked(axis(), point.stiffness, point.damping);
  });
  box->addWidget(plot_);
  place_ = wrapped("map_place", map_box_);
  box->addWidget(place_);
  of_device_ = button(QStringLiteral("The device alone…"), "device_curves",
                      QStringLiteral("How stiff and damped its walls may be, what limits them, the "
                                     "impedance that is rendered, and how hard a wall feels."));
  connect(of_device_, &QPushButton::clicked, this, &StiffnessPanel::show_curves);
  box->addWidget(of_device_);
  layout.addWidget(map_box_);
}

void StiffnessPanel::show_curves() {
  if (!curves_) curves_ = new CurvesDialog(this);
  curves_->show_curves(text(tuning_->results.device_id), device_curves(tuning_->results));
  curves_->show();
  curves_->raise();
}

void StiffnessPanel::build_study(QVBoxLayout& layout, const std::vector<std::string>& device_ids) {
  study_ = new StudyBox(device_ids, this);
  connect(study_, &StudyBox::load_asked, this, &StiffnessPanel::load_asked);
  connect(study_, &StudyBox::compute_asked, this, &StiffnessPanel::compute_asked);
  connect(study_, &StudyBox::save_asked, this, &StiffnessPanel::save_asked);
  layout.addWidget(study_);
}

void StiffnessPanel::show_tuning(const std::optional<Tuning>& tuning) {
  tuning_ = tuning;
  map_box_->setVisible(tuning_.has_value());
  words_->setVisible(tuning_.has_value());
  const bool any = recommends();
  apply_->setVisible(any);
  if (curves_ && curves_->isVisible()) tuning_ ? show_curves() : curves_->hide();
  if (any) {
    const Coupling gains = recommended_coupling(tuning_->results);
    // In a line of its own where it is long: the dock is to be no wider.
    const char between = gains.mode == Coupling::Mode::object ? ' ' : '\n';
    apply_->setText(QStringLiteral("Use recommended:") + between +
                    gains_text(gains).replace('\n', ", "));
  }
  show_source();
  choose_axes();
  show_doubt();
  show_map();
}

/// Not before every row is known: one of those to come may be the one that limits.
bool StiffnessPanel::recommends() const {
  return tuning_ && tuning_->finished() && has_recommendation(tuning_->results);
}

void StiffnessPanel::show_source() {
  study_->set_unsaved(tuning_ && tuning_->finished() && tuning_->computed);
  if (!tuning_)
    return study_->set_source(
        QStringLiteral("There is no map yet: compute one for what is open, or load what sonde tune "
                       "has written."),
        {});
  const QString device = text(tuning_->results.device_id);
  const QString rows = QStringLiteral("%1 of %2 rows").arg(tuning_->rows).arg(tuning_->of_rows);
  if (!tuning_->finished())
    return study_->set_source(
        QStringLiteral("%1, for %2. Compute goes on from these.").arg(rows, device), {});
  const QString folder = text(tuning_->folder.string());
  if (tuning_->computed)
    return study_->set_source(QStringLiteral("Computed here, for %1; not saved.").arg(device),
                              folder);
  study_->set_source(QStringLiteral("%1, for %2.").arg(QFileInfo(folder).fileName(), device),
                     folder);
}

/// What was chosen stays where it is to be had: rows are added while one looks at some of them.
void StiffnessPanel::choose_axes() {
  const QSignalBlocker quiet_axes(axes_), quiet_kinds(shown_kinds_);
  const QString axis_before = axes_->currentText(), kind_before = shown_kinds_->currentText();
  axes_->clear();
  shown_kinds_->clear();
  if (!tuning_) return;
  for (const GainAxis each : axes_of(tuning_->results))
    axes_->addItem(words_of(each), static_cast<int>(each));
  axes_->setVisible(axes_->count() > 1);
  shown_kinds_->addItem(QStringLiteral("all contacts"));
  for (const std::string& kind : kinds_of(tuning_->results)) shown_kinds_->addItem(text(kind));
  axes_->setCurrentIndex(std::max(0, axes_->findText(axis_before)));
  shown_kinds_->setCurrentIndex(std::max(0, shown_kinds_->findText(kind_before)));
}

GainAxis StiffnessPanel::axis() const {
  return static_cast<GainAxis>(axes_->currentData().toInt());
}

void StiffnessPanel::show_map() {
  if (!tuning_) return;
  const std::string kind =
      shown_kinds_->currentIndex() > 0 ? shown_kinds_->currentText().toStdString() : std::string();
  plot_->set_map(stability_map(tuning_->results, axis(), kind));
  plot_->set_recommended(
      recommends() ? std::optional(point_of(recommended_coupling(tuning_->results), axis()))
                   : std::nullopt);
  words_->setText(tuning_->finished()
                      ? recommendation_text(tuning_->results, axis())
                      : QStringLiteral("A recommendation follows when all rows are found."));
  mark_contact();
  show_point();
}

void StiffnessPanel::show_device(const std::string& id, const QString& connected,
                                 const std::string& model) {
  // What the user has chosen since stays, whatever else of the device changes.
  const bool another = simulated_ != id || model_ != model;
  simulated_ = id;
  connected_ = connected;
  model_ = model;
  if (another) study_->choose_device(id.empty() ? model : id);
  show_doubt();
}

bool StiffnessPanel::is_of_connected() const {
  if (!tuning_) return false;
  const bool of_its_model = !model_.empty() && tuning_->results.device_id == model_;
  return of_its_model || is_named_in(tuning_->results, connected_, known_);
}

void StiffnessPanel::show_doubt() {
  QStringList doubts;
  if (tuning_ && !tuning_->doubt.isEmpty()) doubts << tuning_->doubt;
  if (tuning_ && !simulated_.empty() && simulated_ != tuning_->results.device_id)
    doubts << QStringLiteral("This map is of another device: %1, not %2.")
                  .arg(text(tuning_->results.device_id), text(simulated_));
  if (tuning_ && !connected_.isEmpty() && !is_of_connected())
    doubts << QStringLiteral(
                  "This map is of %1. Whether %2 is one is not known: the view says "
                  "nothing of its boundary.")
                  .arg(text(tuning_->results.device_id), connected_);
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
  const auto found = plot_->map_class(point);
  // What a study predicts for its own hands; what is measured in this one stands above.
  QString words = QStringLiteral("By the study of %1, %2 = %3 %4 ")
                      .arg(text(tuning_->results.device_id), QLatin1String(stiffness_key(axis())),
                           number(point.stiffness), stiffness_unit(axis()));
  words += found
               ? QStringLiteral("is %1 in every contact and hand shown, with the device's friction")
                     .arg(QLatin1String(name_of(*found)))
               : QStringLiteral("is off the map");
  const QString margin = margin_text(tuning_->results, axis(), point.stiffness, point.damping);
  if (!margin.isEmpty()) words += QStringLiteral("; ") + margin;
  const QString contact = contact_words(point);
  place_->setText(words + '.' + (contact.isEmpty() ? QString() : '\n' + contact));
}

QString StiffnessPanel::contact_words(const MapPoint& point) const {
  if (contact_.empty()) return {};
  const auto allowed = allowed_at(tuning_->results, axis(), point.damping, contact_);
  return QStringLiteral("Contact now: %1, %2.")
      .arg(text(contact_),
           allowed ? QStringLiteral("in it ") + allowed_text(*allowed, axis(), point.stiffness)
                   : QStringLiteral("which the study has not"));
}

void StiffnessPanel::show_contact(const std::string& kind) {
  if (kind == contact_) return;
  contact_ = kind;
  if (!tuning_) return;
  mark_contact();
  show_point();
}

void StiffnessPanel::mark_contact() {
  plot_->set_contact(contact_, contact_.empty()
                                   ? StabilityMap{}
                                   : stability_map(tuning_->results, axis(), contact_));
}

void StiffnessPanel::show_progress(const std::optional<StudyProgress>& progress) {
  progress_->show_progress(progress);
}

void StiffnessPanel::show_sets(const std::array<Coupling, 2>& sets, std::size_t active) {
  for (std::size_t i = 0; i < sets_.size(); ++i) {
    sets_[i]->setChecked(i == active);
    sets_[i]->setText((i == 0 ? QStringLiteral("A: ") : QStringLiteral("B: ")) +
                      gains_text(sets[i]));
  }
}

void StiffnessPanel::clear_history() { last_second_->clear_history(); }

void StiffnessPanel::show_buzz(const std::optional<Buzz>& buzz, double time) {
  last_second_->show_buzz(buzz, time);
}

std::string StiffnessPanel::device_id() const { return study_->device_id(); }

std::string StiffnessPanel::kind() const { return study_->kind(); }

}  // namespace sonde::ui
