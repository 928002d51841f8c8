// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/recommendation_text.hpp"

#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <map>

#include "engine/study/stability/contact_stability.hpp"
#include "engine/study/tuning/assumptions.hpp"
#include "engine/study/tuning/tuning_words.hpp"
#include "ui/base/format.hpp"
#include "ui/tuning/present_contact.hpp"
#include "ui/tuning/stability_map.hpp"

namespace sonde::ui {
namespace {

QString with_unit(double value, const QString& unit) { return number(value) + ' ' + unit; }

QString words_of(const std::string& reason) {
  static const std::map<std::string, const char*> words{
      {"stability", "stability"},
      {"saturation", "saturation: the motors can give no more"},
      {"chatter", "chatter: more would buzz"},
      {"fidelity", "fidelity: more would be too far from the spring and damper commanded"},
      {"friction", "stability without friction, which may be less than the profile says"},
      {"knocks", "stability at knocks of up to four times the strength"},
      {"driver", "the largest stiffness that the device's driver takes"},
      {"rendered", "what is rendered on this device at most"},
      {"resolution", "resolution: a step of the encoders would be felt"},
      {"rest", "rest: above it the probe swings on"},
      {"released", "what the handle bears in theory once no hand holds it"},
      {"range", "the range studied: nothing in it fails"}};
  const auto found = words.find(reason);
  return found == words.end() ? text(reason) : QString::fromUtf8(found->second);
}

QString where(const GainLimit& limit) {
  if (limit.kind.empty()) return {};
  const QString hand =
      limit.hand.empty() ? QString() : QStringLiteral(", %1 hand").arg(text(limit.hand));
  return QStringLiteral(" (%1 contact%2)").arg(text(limit.kind), hand);
}

/// Of all gains together the rotational ones, which follow.
QString rotational_values(const AxisGains& gains, const JointGains& joint) {
  if (!is_joint(gains.axis)) return {};
  const Coupling c = coupling_of(gains, joint);
  QString stiffness =
      QStringLiteral(", k_r = %1").arg(with_unit(c.k_r, stiffness_unit(GainAxis::rotation)));
  if (gains.axis != GainAxis::together) return stiffness;
  return stiffness +
         QStringLiteral(", b_r = %1").arg(with_unit(c.b_r, damping_unit(GainAxis::rotation)));
}

QString values(const AxisGains& gains) {
  QString line =
      QStringLiteral("%1 = %2").arg(QLatin1String(stiffness_key(gains.axis)),
                                    with_unit(gains.stiffness, stiffness_unit(gains.axis)));
  if (gains.axis != GainAxis::object)
    line += QStringLiteral(", %1 = %2")
                .arg(QLatin1String(damping_key(gains.axis)),
                     with_unit(gains.damping, damping_unit(gains.axis)));
  return line;
}

QString contacts(const std::vector<GainLimit>& places) {
  QStringList out;
  for (const GainLimit& each : places)
    out << QStringLiteral("%1 contact, %2 hand").arg(text(each.kind), text(each.hand));
  return out.join(QStringLiteral("; "));
}

/// What theory says of the handle without a hand.
QString let_go(const AxisGains& gains) {
  const QString unit = stiffness_unit(gains.axis);
  const QString hertz = QStringLiteral("%1 Hz").arg(slowest_buzz);
  const auto up_to = [&](double limit) {
    return std::isfinite(limit) ? QStringLiteral(" up to %1").arg(with_unit(limit, unit))
                                : QString();
  };
  switch (if_let_go(gains)) {
    case LetGo::unknown:
      return {};
    case LetGo::no_buzz:
      return QStringLiteral(
                 " Without a hand on the handle, no swing of %1 or faster grows in theory%2.")
          .arg(hertz, up_to(gains.released));
    case LetGo::stable:
      return QStringLiteral(" Without a hand on the handle, no swing grows in theory%1.")
          .arg(up_to(*gains.released_any_swing));
    case LetGo::slow_swing:
      return QStringLiteral(
                 " Without a hand on the handle it is unstable in theory: a swing slower than %1 "
                 "grows%2.")
          .arg(hertz,
               *gains.released_any_swing > 0
                   ? QStringLiteral(" from %1 on").arg(with_unit(*gains.released_any_swing, unit))
                   : QStringLiteral(" at any stiffness"));
    case LetGo::buzz:
      return QStringLiteral(
                 " Without a hand on the handle it is unstable in theory, and buzzes: up to %1 it "
                 "would be stable.")
          .arg(with_unit(largest_if_let_go(gains), unit));
  }
  return {};
}

/// The terminal's sentence, as one of several.
QString sentence(const std::string& words) {
  const QString line = text(words);
  return line.left(1).toUpper() + line.mid(1) + '.';
}

QString margin(const TuningResults& results, const AxisGains& gains) {
  const QString unit = stiffness_unit(gains.axis);
  QString line =
      QStringLiteral("Limited by %1%2.").arg(words_of(gains.limit.reason), where(gains.limit));
  if (std::isfinite(gains.boundary) && gains.boundary > 0)
    line += QStringLiteral(" Measured to be stable up to %1: a margin of %2.")
                .arg(with_unit(gains.boundary, unit), number(gains.margin()));
  if (std::isfinite(gains.without_friction))
    line += QStringLiteral(" Without friction, up to %1%2.")
                .arg(with_unit(gains.without_friction, unit),
                     QLatin1String(gains.without_friction_by_theory ? " in theory" : ""));
  if (std::isfinite(gains.harder_knocks) && gains.harder_knocks < gains.boundary)
    line +=
        QStringLiteral(" At harder knocks, up to %1.").arg(with_unit(gains.harder_knocks, unit));
  if (std::isfinite(gains.passive) && gains.passive > 0)
    line += QStringLiteral(" Passive in theory up to %1.").arg(with_unit(gains.passive, unit));
  if (const std::string words = passivity_in_words(results, gains); !words.empty())
    line += ' ' + sentence(words);
  return line + let_go(gains);
}

/// Of what was held for seconds.
QString lasting_swings(const TuningResults& results, const AxisGains& gains) {
  if (gains.tried)
    return QStringLiteral(
               "The probe came to rest in every contact, in a firm, a light and a limp hand, after "
               "knocks of up to four times the strength%1.")
        .arg(QLatin1String(trusts_friction(results) ? "" : ", also without friction"));
  if (gains.held_at == 0)
    return QStringLiteral(
        "Whether the probe swings on for seconds, without friction or after a hard knock, was not "
        "looked at.");
  const QString at =
      QStringLiteral("at %1%2").arg(with_unit(gains.held_at, stiffness_unit(gains.axis)),
                                    QLatin1String(held_elsewhere(gains) ? ", far from this" : ""));
  const QString knock =
      QStringLiteral("a knock of %1 times the strength").arg(std::ranges::max(harder_knocks));
  const bool trusts = trusts_friction(results);
  QStringList out;
  if (!trusts && !gains.swings_without_friction.empty())
    out << (has_friction(results)
                ? QStringLiteral("May rely on friction: without it, %1, the probe swings on (%2).")
                : QStringLiteral("The device has no friction: %1 the probe swings on (%2)."))
               .arg(at, contacts(gains.swings_without_friction));
  if (!gains.swings_at_harder_knocks.empty())
    out << QStringLiteral("After %1, %2, it swings on (%3).")
               .arg(knock, at, contacts(gains.swings_at_harder_knocks));
  if (out.empty())
    out << QStringLiteral("Held for seconds %1,%2 after %3, the probe comes to rest.")
               .arg(at, QLatin1String(trusts ? "" : " once without friction and once"), knock);
  return out.join(' ');
}

/// Why a coupling that could be damped is best without it; empty where it is not.
QString why_no_damping(const TuningResults& results, const AxisGains& best) {
  const auto damped = best_damped(results, best);
  if (best.damping > 0 || best.stiffness <= 0 || !damped) return {};
  const AxisGains& next = *damped;
  return QStringLiteral("No virtual damping is best: at %1 = %2 the stiffness may be %3, by %4%5.")
      .arg(QLatin1String(damping_key(next.axis)), with_unit(next.damping, damping_unit(next.axis)),
           with_unit(next.stiffness, stiffness_unit(next.axis)), words_of(next.limit.reason),
           where(next.limit));
}

/// What an assumed value does to the recommendation, as shares of it.
struct Effect {
  QString name;
  double least = 1, most = 1;
  double size() const { return std::max(most, least > 0 ? 1 / least : INFINITY); }
};

std::vector<Effect> effects_of(const TuningResults& results, GainAxis axis) {
  std::vector<Effect> out;
  const auto as_assumed = recommend_as_varied(results, axis);
  if (!as_assumed || as_assumed->stiffness <= 0) return out;
  for (const TuningLine& line : results.lines) {
    if (line.axis != axis || line.assumed.empty()) continue;
    const QString name = text(line.assumed).replace('_', ' ');
    const auto gains = recommend(results, axis, line.assumed, line.times);
    if (!gains) continue;
    auto at = std::ranges::find(out, name, &Effect::name);
    if (at == out.end()) at = out.insert(out.end(), Effect{.name = name});
    const double share = gains->stiffness / as_assumed->stiffness;
    at->least = std::min(at->least, share);
    at->most = std::max(at->most, share);
  }
  std::ranges::stable_sort(out, std::greater{}, &Effect::size);
  return out;
}

/// The profile's assumed values, where a study has varied none of them.
QString not_varied(const TuningResults& results) {
  const QJsonObject device = QJsonDocument::fromJson(QByteArray::fromStdString(results.about))
                                 .object()
                                 .value(QStringLiteral("device"))
                                 .toObject();
  QStringList names;
  for (auto each = device.begin(); each != device.end(); ++each)
    if (each->toObject().contains(QStringLiteral("assumed")))
      names << QString(each.key()).replace('_', ' ');
  return names.isEmpty() ? QString()
                         : QStringLiteral("Rests on assumed %1, which this study did not vary.")
                               .arg(names.join(QStringLiteral(", ")));
}

/// The value that limits most of those that are not sure, with what is recommended at both ends.
QString limiting_assumption(const TuningResults& results, GainAxis axis) {
  const std::vector<AssumedInterval> intervals = assumed_intervals(results, axis);
  if (!change_gains(intervals)) return {};
  const AssumedInterval& most = intervals.front();
  const auto end = [&](const AssumedEnd& each) {
    return QStringLiteral("%1 at %2")
        .arg(with_unit(each.gains.stiffness, stiffness_unit(axis)),
             with_unit(each.value, text(unit_of(most))).trimmed());
  };
  return QStringLiteral(
             " Of the values that are not sure, the %1 limits most: by the limits of the %2 "
             "contact (%3 hand) alone, %4, and %5.")
      .arg(text(most.key).replace('_', ' '), text(most.kind), text(most.hand), end(most.low),
           end(most.high));
}

QString rests_on(const TuningResults& results, GainAxis axis) {
  constexpr double matters = 1.05;
  const std::vector<Effect> effects = effects_of(results, axis);
  if (effects.empty()) return not_varied(results);
  QStringList strong, weak;
  for (const Effect& effect : effects) {
    if (effect.size() < matters)
      weak << effect.name;
    else
      strong << QStringLiteral("%1 %2 to %3 times")
                    .arg(effect.name, number(effect.least), number(effect.most));
  }
  QString line;
  if (!strong.isEmpty())
    line = QStringLiteral(
               "Rests on values that are not sure; the ends of each (half and twice, if it is "
               "assumed) make of the stiffness: %1.")
               .arg(strong.join(QStringLiteral(", ")));
  if (!weak.isEmpty())
    line +=
        QStringLiteral("%1Hardly on the %2.")
            .arg(line.isEmpty() ? QString() : QStringLiteral(" "), weak.join(QStringLiteral(", ")));
  return line + limiting_assumption(results, axis);
}

}  // namespace

QString recommendation_text(const TuningResults& results, GainAxis axis) {
  const auto gains = recommend(results, axis);
  if (!gains) return QStringLiteral("The study has no gains to recommend.");
  const auto recommended = recommended_axes(results);
  const bool alone = std::ranges::find(recommended, axis) == recommended.end();
  QStringList lines;
  if (gains->stiffness > 0)
    lines << (alone ? QStringLiteral("Alone, with the rest soft: ")
                    : QStringLiteral("Recommended: ")) +
                 values(*gains) + rotational_values(*gains, results.joint)
          << margin(results, *gains);
  else
    lines << QStringLiteral("No stiffness in the range studied is good, %1.")
                 .arg(text(limit_in_words(gains->limit)));
  if (gains->stiffness <= 0)
    for (const std::string& words : rest_in_words(results, *gains)) lines << sentence(words);
  const QString swings =
      alone || gains->stiffness <= 0 ? QString() : lasting_swings(results, *gains);
  if (!swings.isEmpty()) lines << swings;
  const QString undamped = why_no_damping(results, *gains);
  if (!undamped.isEmpty()) lines << undamped;
  const QString assumed = alone ? QString() : rests_on(results, axis);
  if (!assumed.isEmpty()) lines << assumed;
  return lines.join('\n');
}

QString margin_text(const TuningResults& results, GainAxis axis, double stiffness, double damping) {
  const auto allowed = allowed_at(results, axis, damping);
  return allowed ? allowed_text(*allowed, axis, stiffness) : QString();
}

}  // namespace sonde::ui
