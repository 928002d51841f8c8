// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/accuracy_panel.hpp"

#include <QButtonGroup>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QRadioButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/calibration/calibration.hpp"
#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/bar.hpp"
#include "ui/panels/scrolled.hpp"
#include "ui/panels/slider_row.hpp"

namespace sonde::ui {
namespace {

constexpr double per_cent = 100;
constexpr Setting time_setting{
    "tick_time",  "Time of a tick",
    "µs",         least_time_us,
    most_time_us, ServoSettings{}.budget.microseconds,
    true,         "Wall-clock time that the geometry may take for each answer."};
constexpr Setting accuracy_setting{
    "tick_accuracy",
    "Wanted accuracy",
    "%",
    per_cent* least_share,
    per_cent* most_share,
    1,
    true,
    "Error that nine in ten ticks should keep to, of the largest depth. The time follows."};

constexpr const char* doc_of_here =
    "The same, measured on this scene alone: by `sonde calibrate`, in a file NAME.calibration.json "
    "beside it, or before Sonde was built.";

QString percent_of(double share) { return number(per_cent * share) + QStringLiteral(" %"); }
QString microseconds(double time_us) { return number(time_us) + QStringLiteral(" µs"); }

QString within(double share) {
  return std::isfinite(share) ? QStringLiteral("within ") + percent_of(share)
                              : QStringLiteral("not measured");
}

QString words(const Claim& claim, double sure) {
  switch (claim.by) {
    case Claim::By::nothing:
      return QStringLiteral("not measured");
    case Claim::By::certified:
      return within(claim.within) + QStringLiteral(", certified");
    case Claim::By::expected:
      return within(claim.within) + QStringLiteral(", %1 in 100").arg(std::lround(per_cent * sure));
  }
  return {};
}

QString words(const Expected& expected) {
  return expected.time_us > 0 ? QStringLiteral("%1 in %2")
                                    .arg(within(expected.within), microseconds(expected.time_us))
                              : QStringLiteral("no limit of time");
}

/// A phase in a bar, in its colour.
struct ShownPhase {
  Phase phase;
  const char* name;
  QColor colour;
};
const std::vector<ShownPhase> phases_of_a_tick{{Phase::look, "look", colour::contact},
                                               {Phase::solve, "solve", colour::ghost},
                                               {Phase::sweep, "sweep", colour::nearest},
                                               {Phase::couple, "couple", colour::turn}};
const std::vector<ShownPhase> phases_of_a_search{
    {Phase::sketch, "sketch", colour::probe}, {Phase::look, "look", colour::contact},
    {Phase::solve, "solve", colour::ghost},   {Phase::sweep, "sweep", colour::nearest},
    {Phase::verify, "verify", colour::ready}, {Phase::bound, "bound", colour::bound}};

QString words(const PhaseTimes& phases, const std::vector<ShownPhase>& shown) {
  QStringList out;
  for (const ShownPhase& one : shown) {
    QString time = microseconds(phases[one.phase]);
    time.replace(QLatin1Char(' '), QStringLiteral("&nbsp;"));  // what goes together is on one line
    out += in_colour(one.colour, QStringLiteral("■")) +
           QStringLiteral("&nbsp;%1&nbsp;%2").arg(QLatin1String(one.name), time);
  }
  return out.join(QStringLiteral("&nbsp; "));
}

std::vector<Bar::Part> parts_of(const PhaseTimes& phases, const std::vector<ShownPhase>& shown) {
  std::vector<Bar::Part> out;
  out.reserve(shown.size());
  for (const ShownPhase& one : shown)
    out.push_back({phases[one.phase] / std::max(phases.sum(), 1e-9), one.colour});
  return out;
}

QFormLayout* add_group(QVBoxLayout& layout, const char* title) {
  auto* group = new QGroupBox(QLatin1String(title), layout.parentWidget());
  auto* form = new QFormLayout(group);
  form->setContentsMargins(0, 4, 0, 0);
  layout.addWidget(group);
  return form;
}

QLabel* add_value(QFormLayout& form, const char* name, const char* object, const char* doc) {
  auto* label = new QLabel(QLatin1String(name), form.parentWidget());
  auto* shown = new QLabel(QStringLiteral("–"), form.parentWidget());
  shown->setObjectName(QLatin1String(object));
  shown->setAlignment(Qt::AlignRight);
  for (QLabel* each : {label, shown}) each->setToolTip(QString::fromUtf8(doc));
  form.addRow(label, shown);
  return shown;
}

/// The phases as a bar, and in words below it.
std::pair<Bar*, QLabel*> add_bar(QFormLayout& form, const char* object, const char* doc) {
  auto* parts = new Bar(form.parentWidget());
  auto* words = new QLabel(form.parentWidget());
  words->setObjectName(QLatin1String(object));
  words->setWordWrap(true);
  for (QWidget* each : std::initializer_list<QWidget*>{parts, words}) {
    each->setToolTip(QString::fromUtf8(doc));
    form.addRow(each);
  }
  return {parts, words};
}

}  // namespace

AccuracyPanel::AccuracyPanel(QWidget* parent) : QDockWidget(QStringLiteral("Accuracy"), parent) {
  setObjectName(QStringLiteral("accuracy_panel"));
  const auto [scroll, content, layout] = scrolled(*this);
  build_knob(*layout);
  build_figures(*layout);
  build_search(*layout);
  layout->addStretch();
  show_knob({}, {});
}

void AccuracyPanel::build_knob(QVBoxLayout& layout) {
  QWidget* content = layout.parentWidget();
  kinds_ = new QButtonGroup(this);
  auto* row = new QHBoxLayout;
  layout.addLayout(row);
  const auto kind = [&](Knob which, const char* name, const char* object, const char* doc) {
    auto* button = new QRadioButton(QLatin1String(name), content);
    button->setObjectName(QLatin1String(object));
    button->setToolTip(QLatin1String(doc));
    kinds_->addButton(button, static_cast<int>(which));
    row->addWidget(button);
  };
  kind(Knob::time, "Time", "knob_time", "Each tick has so much time; the accuracy follows");
  kind(Knob::accuracy, "Accuracy", "knob_accuracy",
       "Nine in ten ticks should be so accurate; the time follows");
  kind(Knob::none, "No limit", "knob_none", "Each tick takes the time that it needs");
  connect(kinds_, &QButtonGroup::idClicked, this,
          [this](int id) { emit kind_chosen(static_cast<Knob>(id)); });
  time_ = new SliderRow(time_setting, content);
  connect(time_, &SliderRow::changed, this, &AccuracyPanel::time_changed);
  accuracy_ = new SliderRow(accuracy_setting, content);
  connect(accuracy_, &SliderRow::changed, this,
          [this](double value) { emit accuracy_changed(value / per_cent); });
  layout.addWidget(time_);
  layout.addWidget(accuracy_);
}

void AccuracyPanel::build_figures(QVBoxLayout& layout) {
  QFormLayout* form = add_group(layout, "Nine in ten ticks");
  expected_ = add_value(*form, "expected", "expected_accuracy",
                        "Of ticks with this time, measured on the scenes that Sonde comes with, on "
                        "pairs of this kind: the error as a share of the largest depth of a path.");
  here_ = add_value(*form, "on this scene", "expected_here", doc_of_here);
  reached_ =
      add_value(*form, "reached", "reached_accuracy",
                "What the last two seconds in contact leave open: how much too deep an answer may "
                "be that its contacts do not hold altogether, as a share of its depth.");
  converged_ = add_value(*form, "converged", "converged_share",
                         "Ticks of the last two seconds in contact that ended at an optimum.");
  rows_ = add_value(*form, "rows", "rows_time",
                    "Time that the geometry took: looking for contacts, solving, sweeping. The "
                    "knob limits it.");
  tick_ = add_value(*form, "tick", "tick_time_used",
                    "Time of the servo's own tick: moving the rows to the newest pose of the hand, "
                    "the coupling, the safety of the hand.");
  std::tie(parts_, phases_) = add_bar(
      *form, "phases",
      "Mean time of each phase in the last two seconds in contact: the geometry looks for near "
      "pairs, solves for the nearest pose, and sweeps the way there; the servo's own tick couples "
      "hand and probe.");
}

void AccuracyPanel::build_search(QVBoxLayout& layout) {
  QFormLayout* form = add_group(layout, "Search beside the ticks");
  sure_ = new QComboBox(form->parentWidget());
  sure_->setObjectName(QStringLiteral("search_sure"));
  sure_->setToolTip(
      QStringLiteral("The share of searches that keep to their claim. A larger one searches from "
                     "more starts where the way out is long, and claims less."));
  for (const double share : {0.5, 0.9, 0.99})
    sure_->addItem(QStringLiteral("%1 %").arg(per_cent * share), share);
  sure_->setCurrentIndex(sure_->findData(usually_sure));
  connect(sure_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { emit sure_changed(sure_->currentData().toDouble()); });
  form->addRow(QStringLiteral("sure"), sure_);
  claim_ = add_value(*form, "claim", "search_claim",
                     "How much deeper than the least depth the nearest way out of the last search "
                     "may be, of that depth: certified by the lower bound, or as searches of that "
                     "time were measured, in so many of a hundred.");
  search_time_ = add_value(*form, "time", "search_time",
                           "Of the last search for the nearest ways out, with and without a turn, "
                           "and for the lower bound.");
  std::tie(search_parts_, search_phases_) = add_bar(
      *form, "search_phases",
      "Where the time of that search went, of its threads together: descents on sketches, looks "
      "for near pairs, solving, sweeps, tests whether a pose is free, the lower bound.");
}

void AccuracyPanel::show_knob(const ServoSettings& servo, const Expected& expected) {
  const Knob kind = servo.accuracy > 0              ? Knob::accuracy
                    : servo.budget.microseconds > 0 ? Knob::time
                                                    : Knob::none;
  kinds_->button(static_cast<int>(kind))->setChecked(true);
  time_->setVisible(kind == Knob::time);
  accuracy_->setVisible(kind == Knob::accuracy);
  // A value outside of the slider's range stays as it is until the slider is moved.
  if (kind == Knob::time && time_->value() != servo.budget.microseconds)
    time_->set_value(servo.budget.microseconds);
  if (kind == Knob::accuracy && accuracy_->value() != per_cent * servo.accuracy)
    accuracy_->set_value(per_cent * servo.accuracy);
  expected_->setText(words(expected));
  here_->setText(within(expected.here.value_or(std::numeric_limits<double>::infinity())));
  if (!expected.no_here.isEmpty()) here_->setText(QStringLiteral("cannot be read"));
  here_->setToolTip(expected.no_here.isEmpty() ? QString::fromUtf8(doc_of_here) : expected.no_here);
}

void AccuracyPanel::show_reached(const std::optional<Reached>& reached) {
  if (!reached) {
    for (QLabel* label : {reached_, converged_, rows_, tick_}) label->setText(QStringLiteral("–"));
    phases_->clear();
    return parts_->set({});
  }
  reached_->setText(QStringLiteral("within ") + percent_of(reached->within));
  converged_->setText(percent_of(reached->converged));
  rows_->setText(microseconds(reached->rows_us));
  tick_->setText(microseconds(reached->tick_us));
  parts_->set(parts_of(reached->phases, phases_of_a_tick));
  phases_->setText(words(reached->phases, phases_of_a_tick));
}

void AccuracyPanel::show_claim(const std::optional<Claim>& claim, double sure) {
  claim_->setText(claim ? words(*claim, sure) : QStringLiteral("–"));
}

void AccuracyPanel::show_search(const PhaseTimes& phases, double time_us) {
  const bool timed = phases.sum() > 0;
  search_time_->setText(timed ? microseconds(time_us) : QStringLiteral("–"));
  search_parts_->set(timed ? parts_of(phases, phases_of_a_search) : std::vector<Bar::Part>());
  search_phases_->setText(timed ? words(phases, phases_of_a_search) : QString());
}

}  // namespace sonde::ui
