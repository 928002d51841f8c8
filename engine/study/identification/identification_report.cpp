// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/identification_report.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "engine/study/identification/identified_profile.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;
using Row = std::array<std::string, 6>;

/// The number of characters, not bytes.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string aligned(const std::vector<Row>& rows) {
  std::array<std::size_t, 6> widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  std::string out;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += row[i] + std::string(widths[i] - width(row[i]) + 2, ' ');
    out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return out;
}

std::string about(const IdentifiedAxis& axis) {
  const std::string unit = axis.axis < 3 ? " N" : " N·m";
  std::string out = name_of_axis(axis.axis) + ": " + std::to_string(axis.pulses) +
                    " pulses of up to " + number_text(axis.most, 3) + unit + "; " +
                    number_text(100 * axis.handle.misfit, 2) + " % of the motion is unexplained";
  if (axis.with_gaps > 0)
    out +=
        "; " + std::to_string(axis.with_gaps) + " more are left out, samples are missing in them";
  const HandleFit& fit = axis.handle;
  if (fit.between)
    out +=
        "; it moves as if its commands had changed between the samples, so their times are "
        "measured too, and the intervals hold both answers (record each sample that the device "
        "gets)";
  if (fit.widened)
    out += "; the unexplained rest is " + number_text(fit.excess, 2) +
           " times what noise and encoder steps would leave: this device does something that mass, "
           "damping, friction and delay do not describe, so the intervals are widened until they "
           "cover what the parts of the pulses say one by one";
  if (!axis.has_steps) out += "; no step of the encoder was seen: it may be as large as is said";
  return out + '\n';
}

Json json_of(const Estimate& e) { return {{"value", e.value}, {"low", e.low}, {"high", e.high}}; }

Json json_of(const IdentifiedAxis& axis) {
  return {{"axis", name_of_axis(axis.axis)},
          {"pulses", axis.pulses},
          {"pulses_with_gaps", axis.with_gaps},
          {"largest_command", axis.most},
          {"inertia", json_of(axis.handle.inertia)},
          {"damping", json_of(axis.handle.damping)},
          {"friction", json_of(axis.handle.friction)},
          {"delay", json_of(axis.handle.delay)},
          {"resolution", json_of(axis.resolution)},
          {"steps_seen", axis.has_steps},
          {"beside_the_command", axis.handle.offset},
          {"unexplained", axis.handle.misfit},
          {"beyond_noise", axis.handle.excess},
          {"commands_between_samples", axis.handle.between},
          {"widened", axis.handle.widened}};
}

}  // namespace

std::string identification_text(const Identification& identification,
                                const DeviceProfile& profile) {
  std::vector<Row> rows{{"", "measured", "at least", "at most", "profile", "unit"}};
  for (const auto& [value, e] : identified_values(identification)) {
    const ProfileKey& key = key_of(value);
    rows.push_back({key.key, number_text(e.value, 4), number_text(e.low, 4), number_text(e.high, 4),
                    number_text((profile.*value).value, 4), key.unit});
  }
  std::string out = aligned(rows) + '\n';
  for (const IdentifiedAxis& axis : identification.axes) out += about(axis);
  for (const RefusedAxis& axis : identification.refused)
    out += name_of_axis(axis.axis) + ": not identified: " + axis.reason + '\n';
  return out;
}

std::string identification_json(const Identification& identification,
                                const DeviceProfile& profile) {
  Json values = Json::object(), axes = Json::array(), refused = Json::array();
  for (const auto& [value, estimate] : identified_values(identification)) {
    const ProfileKey& key = key_of(value);
    values[key.key] = json_of(estimate);
    values[key.key].update({{"unit", key.unit}, {"profile", (profile.*value).value}});
  }
  for (const IdentifiedAxis& axis : identification.axes) axes.push_back(json_of(axis));
  for (const RefusedAxis& axis : identification.refused)
    refused.push_back({{"axis", name_of_axis(axis.axis)}, {"reason", axis.reason}});
  const Json json{{"values", values},
                  {"sample_time", identification.sample_time},
                  {"axes", axes},
                  {"not_identified", refused}};
  return json.dump(2) + '\n';
}

}  // namespace sonde
