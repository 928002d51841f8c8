// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/search_variation.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <variant>

namespace sonde {
namespace {

using Number =
    std::variant<double SearchTuning::*, int SearchTuning::*, std::size_t SearchTuning::*>;
struct Named {
  const char* name;
  Number number;
};
constexpr Named all[] = {
    {"share_for_sketches", &SearchTuning::share_for_sketches},
    {"share_for_search", &SearchTuning::share_for_search},
    {"share_for_refining", &SearchTuning::share_for_refining},
    {"steps_of_first_translation", &SearchTuning::steps_of_first_translation},
    {"first_sketches", &SearchTuning::first_sketches},
    {"most_first_sketches", &SearchTuning::most_first_sketches},
    {"most_sketches", &SearchTuning::most_sketches},
    {"clear", &SearchTuning::clear},
    {"clear_alone", &SearchTuning::clear_alone},
    {"alone", &SearchTuning::alone},
    {"same_place_on_sketches", &SearchTuning::same_place_on_sketches},
    {"worth_more_points", &SearchTuning::worth_more_points},
    {"ends_where_clear", &SearchTuning::ends_where_clear},
    {"first_ends", &SearchTuning::first_ends},
    {"most_ends", &SearchTuning::most_ends},
    {"sketch_error", &SearchTuning::sketch_error},
    {"blind", &SearchTuning::blind},
    {"pushes", &SearchTuning::pushes},
    {"narrow", &SearchTuning::narrow},
    {"most_after_sketches", &SearchTuning::most_after_sketches},
    {"plainly_deep", &SearchTuning::plainly_deep},
    {"tries_in_a_ball", &SearchTuning::tries_in_a_ball},
    {"near_tries", &SearchTuning::near_tries},
    {"ends_for_starts", &SearchTuning::ends_for_starts},
    {"worth_exact", &SearchTuning::worth_exact},
    {"exact_tolerance", &SearchTuning::exact_tolerance},
    {"same", &SearchTuning::same},
    {"refined", &SearchTuning::refined},
    {"worth_refining", &SearchTuning::worth_refining},
    {"bound_for_a_sketch", &SearchTuning::bound_for_a_sketch},
    {"bound_for_a_step", &SearchTuning::bound_for_a_step},
    {"least_us_for_bound", &SearchTuning::least_us_for_bound},
};

template <class Value>
Value parsed(const std::string& text) {
  Value value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value >= Value{}) ||
      !std::isfinite(static_cast<double>(value)))
    throw std::invalid_argument("\"" + text + "\" is no such number, zero or more");
  return value;
}

}  // namespace

std::vector<std::string> names_of_search_tuning() {
  std::vector<std::string> out;
  for (const Named& each : all) out.emplace_back(each.name);
  return out;
}

std::string list_of_search_tuning() {
  std::string out;
  for (const Named& each : all) out.append(out.empty() ? "" : ", ").append(each.name);
  return out;
}

void vary(SearchTuning& tuning, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string name = assignment.substr(0, equals);
  const auto* const at = std::ranges::find(all, name, &Named::name);
  if (equals == std::string::npos || at == std::end(all))
    throw std::invalid_argument("\"" + assignment +
                                "\" is not NAME=VALUE of a number of the search; the names are " +
                                list_of_search_tuning());
  const std::string value = assignment.substr(equals + 1);
  std::visit(
      [&](auto member) {
        auto& number = tuning.*member;
        number = parsed<std::remove_reference_t<decltype(number)>>(value);
      },
      at->number);
}

}  // namespace sonde
