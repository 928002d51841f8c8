// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/readout_panel.hpp"

#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/body/body.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/queries/body_queries.hpp"
#include "ui/base/theme.hpp"
#include "ui/document/same_pose.hpp"
#include "ui/panels/bar.hpp"
#include "ui/panels/history_plot.hpp"
#include "ui/panels/scrolled.hpp"
#include "ui/views/separation_view.hpp"
#include "ui/views/wrench_view.hpp"

namespace sonde::ui {
namespace {

/// Of the probe's radius. A screw about an axis that far away is a slide as it is felt and seen:
/// its path leaves the straight line by less than a thousandth of its length.
constexpr double far_axis = 1000;

QString percent(double part) { return QString::number(100 * part, 'f', 0) + QStringLiteral(" %"); }

QString large(const QString& text) {
  return QStringLiteral("<span style='font-size:20pt; font-weight:bold'>%1</span>").arg(text);
}

/// Small ones in thousandths: with all their decimals three numbers are wider than the dock.
void show_components(QLabel& value, const QString& unit, const Vec3& x) {
  const bool small = x.norm() > 0 && x.norm() < 0.1;
  value.setText(components_text(small ? Vec3(1000 * x) : x));
  auto* form = static_cast<QFormLayout*>(value.parentWidget()->layout());
  static_cast<QLabel*>(form->labelForField(&value))
      ->setText(QStringLiteral("x, y, z, ") + (small ? QStringLiteral("m") : QString()) + unit);
}

/// The first of these texts that is no wider than the value's room; the last, if none is.
void show_fitting(QLabel& value, const QStringList& texts) {
  const auto fits = [&](const QString& text) {
    return value.fontMetrics().horizontalAdvance(text) <= value.minimumWidth();
  };
  const auto found = std::ranges::find_if(texts, fits);
  value.setText(found == texts.end() ? texts.back() : *found);
}

/// Why force and torque are less than the coupling asks for.
QString reasons(const QString& of_force, const QString& of_torque) {
  if (of_force == of_torque)
    return of_force.isEmpty() ? of_force : QStringLiteral("force and torque: ") + of_force;
  QStringList each;
  if (!of_force.isEmpty()) each << QStringLiteral("force: ") + of_force;
  if (!of_torque.isEmpty()) each << QStringLiteral("torque: ") + of_torque;
  return each.join(QStringLiteral("; "));
}

/// Faint text with room for two lines, so that nothing below moves when they come and go.
QLabel* remark(QFormLayout& form, const char* object) {
  auto* label = new QLabel(form.parentWidget());
  label->setObjectName(QLatin1String(object));
  label->setWordWrap(true);
  label->setForegroundRole(QPalette::PlaceholderText);
  label->setMinimumHeight(2 * label->fontMetrics().lineSpacing());
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  form.addRow(label);
  return label;
}

QFormLayout* form_in(QVBoxLayout& layout, QWidget* group) {
  auto* form = new QFormLayout(group);
  form->setContentsMargins(0, 4, 0, 0);
  form->setVerticalSpacing(3);
  form->setHorizontalSpacing(4);
  layout.addWidget(group);
  return form;
}

}  // namespace

ReadoutPanel::ReadoutPanel(QWidget* parent) : QDockWidget(QStringLiteral("Readout"), parent) {
  setObjectName(QStringLiteral("readout_panel"));
  const auto [scroll, content, layout] = scrolled(*this);
  layout->setSpacing(4);
  build_held(*layout);
  build_ways(*layout);
  build_wrench(*layout);
  build_loop(*layout);
  layout->addStretch();
}

QLabel* ReadoutPanel::value(QFormLayout& form, const QString& name, const char* object,
                            const QString& doc) {
  auto* label = new QLabel(name, form.parentWidget());
  auto* number = new QLabel(QStringLiteral("–"), form.parentWidget());
  number->setObjectName(QLatin1String(object));
  number->setAlignment(Qt::AlignRight);
  number->setTextFormat(Qt::RichText);
  // As wide as nearly all numbers are: the dock keeps its width while they change.
  const bool two = name.contains(QStringLiteral("turns")) || name == QStringLiteral("screw");
  const QStringList widest = two ? QStringList{QStringLiteral("88.8°, 88.888 mm (88 %)"),
                                               QStringLiteral("0.000888°, 0.000888 mm")}
                                 : QStringList{QStringLiteral("88.888 mm (888 %)")};
  for (const QString& text : widest)
    number->setMinimumWidth(
        std::max(number->minimumWidth(), number->fontMetrics().horizontalAdvance(text) + 1));
  label->setToolTip(doc);
  number->setToolTip(doc);
  form.addRow(label, number);
  return number;
}

void ReadoutPanel::build_held(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Clearance, or depth"), this);
  auto* form = form_in(layout, group);
  depth_ = new QLabel(QStringLiteral("–"), group);
  depth_->setObjectName(QStringLiteral("depth_value"));
  depth_->setToolTip(QStringLiteral(
      "Free: the least distance between the bodies, which the view shows with the two points where "
      "it is taken; grey while it is measured anew. Held: how deep, that is how far the separated "
      "pose that holds the probe is from the pose of the hand, √σ, how far the probe's points move "
      "in the mean. The force pulls there. The loop followed it along a free path from where the "
      "probe came, so it need not be the nearest way out."));
  form->addRow(depth_);
  split_ = new Bar(group);
  form->addRow(split_);
  translation_ =
      value(*form, in_colour(colour::ghost, QStringLiteral("moves")), "translation_value",
            QStringLiteral("How far the centre of mass moves, and its share of σ."));
  rotation_ = value(*form, in_colour(colour::turn, QStringLiteral("turns")), "rotation_value",
                    QStringLiteral("How far it turns about its centre of mass, how far the turn "
                                   "moves the points, and its share of σ."));
  screw_ =
      value(*form, QStringLiteral("screw"), "screw_value",
            QStringLiteral("The same motion as one turn about an axis and one slide along it. "
                           "The axis is not through the centre of mass, which goes round it: "
                           "the slide is shorter than the way of the centre of mass. Where the "
                           "axis is very far away, it is a slide alone."));
  contacts_ = value(*form, QStringLiteral("contacts"), "contacts_value",
                    QStringLiteral("Places of contact that carry the separation."));
  depth_plot_ = new HistoryPlot(QStringLiteral("held"), colour::ghost, group);
  form->addRow(depth_plot_);
}

void ReadoutPanel::build_ways(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Penetration depth, searched"), this);
  auto* form = form_in(layout, group);
  nearest_ =
      value(*form, in_colour(colour::nearest, QStringLiteral("nearest way out")), "nearest_value",
            QStringLiteral("Root of PD_g: the least depth found, by a search in all directions or "
                           "by following, whether or not a free path leads there from where the "
                           "probe was. Grey while computed for the newest pose. Key 5 draws it."));
  pdt_ = value(*form, in_colour(colour::straight, QStringLiteral("without a turn")), "pdt_value",
               QStringLiteral("PD_t: the least depth found if the probe may not turn, and its "
                              "ratio to the nearest way out. Key 6 draws it."));
  bound_ = value(*form, QStringLiteral("at least"), "bound_value",
                 QStringLiteral("A lower bound: no shorter motion separates the two. And its ratio "
                                "to the nearest way out."));
  why_ = remark(*form, "why_value");
}

void ReadoutPanel::build_wrench(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("On the hand"), this);
  auto* form = form_in(layout, group);
  force_ = value(*form, in_colour(colour::force, QStringLiteral("force |F|")), "force_value",
                 QStringLiteral("Against the force limit."));
  force_parts_ = value(*form, QStringLiteral("x, y, z, N"), "force_parts_value",
                       QStringLiteral("The force on the hand along the axes of the fixed body."));
  force_bar_ = new Bar(group);
  form->addRow(force_bar_);
  torque_ = value(*form, in_colour(colour::torque, QStringLiteral("torque |τ|")), "torque_value",
                  QStringLiteral("About the centre of mass, against the torque limit."));
  torque_parts_ = value(*form, QStringLiteral("x, y, z, N·m"), "torque_parts_value",
                        QStringLiteral("The torque on the hand about the axes of the fixed body, "
                                       "through the probe's centre of mass."));
  torque_bar_ = new Bar(group);
  form->addRow(torque_bar_);
  lessened_ = remark(*form, "lessened_value");
  force_plot_ = new HistoryPlot(QStringLiteral("force"), colour::force, group);
  force_plot_->set_unit(1, QStringLiteral("N"));
  form->addRow(force_plot_);
}

void ReadoutPanel::build_loop(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Servo"), this);
  auto* form = form_in(layout, group);
  tick_ = value(*form, QStringLiteral("tick time"), "tick_value",
                QStringLiteral("Time to compute one tick of the haptic loop."));
  rate_ = value(*form, QStringLiteral("rate"), "rate_value",
                QStringLiteral("Ticks per second, measured."));
  steps_ = value(*form, QStringLiteral("solver steps"), "steps_value",
                 QStringLiteral("Linearise, solve, advance: times in this tick."));
  late_ = value(*form, QStringLiteral("late ticks"), "late_value",
                QStringLiteral("Ticks that missed their deadline, since the start."));
}

void ReadoutPanel::take(const Pair& pair) {
  pair_ = pair;
  mass_ = pair.probe().mass;
  const LengthUnit unit(mass_.radius);
  unit_ = unit;
  depth_plot_->set_unit(1 / unit.metres(), unit.name());
  depth_plot_->clear();
  force_plot_->clear();
}

void ReadoutPanel::show_course(const Curves* curves, double until) {
  const auto show = [&](HistoryPlot& plot, Curve curve) {
    const auto columns = static_cast<std::size_t>(plot.width() * plot.devicePixelRatioF());
    const double from = until - HistoryPlot::span;
    plot.show(curves ? curves->outline(curve, from, until, columns) : std::vector<CurvePoint>{},
              until);
  };
  show(*depth_plot_, Curve::held);
  show(*force_plot_, Curve::force);
}

void ReadoutPanel::show_numbers(const Instant& now) {
  const Snapshot& snapshot = now.snapshot;
  coupling_ = snapshot.coupling;
  show_held(now);
  show_ways(snapshot.separation, now.searched);
  show_wrench(snapshot);
  show_loop(snapshot);
}

/// In large letters: how deep it is, or how much room there is.
QString ReadoutPanel::room_text(const Instant& now) const {
  const Separation& separation = now.snapshot.separation;
  if (separation.status == Status::penetrating)
    return large(unit_.text(separation.depth)) + QStringLiteral(" deep");
  if (!now.clearance) return large(QStringLiteral("free"));
  QString room = large(unit_.text(now.clearance->distance)) + QStringLiteral(" clear");
  if (pair_ && !pair_->fixed().parts.empty()) {
    const std::string_view part = part_at(pair_->fixed(), now.clearance->on_fixed);
    room += QStringLiteral("<br>of %1").arg(text(std::string(part)).toHtmlEscaped());
  }
  if (clearance_here(now)) return room;
  return QStringLiteral("<span style='color:%1'>%2</span>").arg(faint_text(palette()).name(), room);
}

/// Of a motion about the centre of mass, in words: the longest first.
QStringList ReadoutPanel::screw_texts(const SeparationMotion& motion) const {
  const Screw screw = screw_of(motion, Vec3::Zero());
  if (screw.point.norm() > far_axis * mass_.radius)
    return {QStringLiteral("slide %1").arg(unit_.text(motion.t.norm()))};
  const QString angle = angle_text(screw.turn), slide = unit_.text(std::abs(screw.slide));
  return {QStringLiteral("%1, slide %2").arg(angle, slide),
          QStringLiteral("%1, %2").arg(angle, slide)};
}

void ReadoutPanel::show_held(const Instant& now) {
  const Separation& separation = now.snapshot.separation;
  const bool held = separation.status == Status::penetrating;
  if (separation.status == Status::failed) {
    depth_->setText(large(QStringLiteral("not found")));
    split_->set({});
    for (QLabel* label : {translation_, rotation_, screw_, contacts_})
      label->setText(QStringLiteral("–"));
    return;
  }
  depth_->setText(room_text(now));
  const double sigma = separation.sigma;
  const double turned =
      sigma > 0 ? separation.rotation * separation.rotation / sigma : 0;  // share of σ
  const double moved = sigma > 0 ? separation.translation * separation.translation / sigma : 0;
  split_->set({{moved, colour::ghost}, {turned, colour::turn}});
  const auto share = [&](double length, double part) {
    return sigma > 0 ? QStringLiteral("%1 (%2)").arg(unit_.text(length), percent(part))
                     : unit_.text(length);
  };
  const SeparationMotion motion = separation_motion(mass_, separation.device, separation.separated);
  const QString angle = angle_text(motion.theta.norm());
  translation_->setText(share(separation.translation, moved));
  // Small numbers have exponents: with all that is said of them they are wider than the dock.
  show_fitting(*rotation_, {QStringLiteral("%1, %2").arg(angle, share(separation.rotation, turned)),
                            QStringLiteral("%1, %2").arg(angle, unit_.text(separation.rotation))});
  show_fitting(*screw_, held ? screw_texts(motion) : QStringList{QStringLiteral("–")});
  contacts_->setText(QString::number(separation.clusters.size));
}

void ReadoutPanel::show_ways(const Separation& separation,
                             const std::optional<BackgroundResult>& searched) {
  if (!searched) {
    for (QLabel* label : {nearest_, pdt_, bound_}) label->setText(QStringLiteral("…"));
    why_->clear();
    return;
  }
  const bool fresh = same(searched->device, separation.device);
  const auto in_shade = [&](const QString& text) {
    return fresh ? text
                 : QStringLiteral("<span style='color:%1'>%2</span>")
                       .arg(faint_text(palette()).name(), text);
  };
  const WayOut way = way_out(separation, *searched);
  why_->setText(QString::fromUtf8(words(way)));
  if (way == WayOut::free_blocked) {
    nearest_->setText(QStringLiteral("free at the hand"));
    pdt_->setText(QStringLiteral("free at the hand"));
    bound_->setText(QStringLiteral("–"));
    return;
  }
  const double nearest = searched->nearest ? searched->nearest->depth : 0;
  const auto beside = [&](double length) {
    return in_shade(
        nearest > 0 ? QStringLiteral("%1 (%2)").arg(unit_.text(length), percent(length / nearest))
                    : unit_.text(length));
  };
  const QString not_found = QStringLiteral("not found");
  nearest_->setText(in_shade(searched->nearest ? unit_.text(nearest) : not_found));
  pdt_->setText(searched->pdt ? beside(searched->pdt->depth) : in_shade(not_found));
  bound_->setText(searched->lower_bound ? beside(*searched->lower_bound)
                                        : QStringLiteral("none found"));
}

void ReadoutPanel::show_wrench(const Snapshot& snapshot) {
  const Wrench& wrench = snapshot.wrench;
  const HandState& hand = snapshot.hand;
  const double force = wrench.force.norm(), torque = wrench.torque.norm();
  force_->setText(number(force) + QStringLiteral(" N"));
  torque_->setText(number(torque) + QStringLiteral(" N·m"));
  lessened_->setText(
      reasons(lessened_text(force_lessened(wrench, hand, snapshot.coupling), hand.share),
              lessened_text(torque_lessened(wrench, hand, snapshot.coupling), hand.share)));
  show_components(*force_parts_, QStringLiteral("N"), wrench.force);
  show_components(*torque_parts_, QStringLiteral("N·m"), wrench.torque);
  force_bar_->set({{force / coupling_.max_force, colour::force}});
  torque_bar_->set({{torque / coupling_.max_torque, colour::torque}});
}

void ReadoutPanel::show_loop(const Snapshot& snapshot) {
  const QString none = QStringLiteral("–");  // of a run with no clock
  tick_->setText(snapshot.tick_us > 0 ? number(snapshot.tick_us) + QStringLiteral(" µs") : none);
  rate_->setText(snapshot.paused ? QStringLiteral("paused")
                 : snapshot.rate_hz > 0
                     ? QString::number(snapshot.rate_hz, 'f', 0) + QStringLiteral(" Hz")
                     : none);
  steps_->setText(QString::number(snapshot.separation.iterations));
  late_->setText(snapshot.tick_us > 0
                     ? QStringLiteral("%1 of %2").arg(snapshot.late).arg(snapshot.tick)
                     : none);
}

}  // namespace sonde::ui
