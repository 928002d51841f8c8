// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/search_variation.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

using Number = std::variant<double*, int*, std::size_t*>;
struct Named {
  const char* name;
  Number (*in)(SearchTuning&);
  double least = 0;  ///< with less, the search divides by zero or never ends
};
constexpr Named all[] = {
    {"share_for_sketches", [](SearchTuning& t) -> Number { return &t.share_for_sketches; }},
    {"share_for_search", [](SearchTuning& t) -> Number { return &t.share_for_search; }},
    {"share_for_refining", [](SearchTuning& t) -> Number { return &t.share_for_refining; }},
    {"shortest_for_two_threads",
     [](SearchTuning& t) -> Number { return &t.shortest_for_two_threads; }},
    {"same", [](SearchTuning& t) -> Number { return &t.same; }},
    {"same_place", [](SearchTuning& t) -> Number { return &t.same_place; }},
    {"sketch_error", [](SearchTuning& t) -> Number { return &t.sketch_error; }},
    {"rough_error", [](SearchTuning& t) -> Number { return &t.rough_error; }},
    {"smallest_ball", [](SearchTuning& t) -> Number { return &t.smallest_ball; }, 1e-6},
    {"largest_ball", [](SearchTuning& t) -> Number { return &t.largest_ball; }},
    {"ball_growth", [](SearchTuning& t) -> Number { return &t.ball_growth; }, 1.01},
    {"tries_in_a_ball", [](SearchTuning& t) -> Number { return &t.tries_in_a_ball; }},
    {"least_ball", [](SearchTuning& t) -> Number { return &t.least_ball; }},
    {"farthest_ball", [](SearchTuning& t) -> Number { return &t.farthest_ball; }},
    {"end_ball", [](SearchTuning& t) -> Number { return &t.end_ball; }},
    {"farthest_overlap", [](SearchTuning& t) -> Number { return &t.farthest_overlap; }},
    {"clear", [](SearchTuning& t) -> Number { return &t.clear; }},
    {"most_first_sketches", [](SearchTuning& t) -> Number { return &t.most_first_sketches; }},
    {"most_sketches", [](SearchTuning& t) -> Number { return &t.most_sketches; }},
    {"few_ends", [](SearchTuning& t) -> Number { return &t.few_ends; }, 1},
    {"first_ends", [](SearchTuning& t) -> Number { return &t.first_ends; }, 1},
    {"narrow", [](SearchTuning& t) -> Number { return &t.narrow; }},
    {"narrow_for_pushes", [](SearchTuning& t) -> Number { return &t.narrow_for_pushes; }},
    {"most_after_sketches", [](SearchTuning& t) -> Number { return &t.most_after_sketches; }},
    {"most_translations_pushed",
     [](SearchTuning& t) -> Number { return &t.most_translations_pushed; }},
    {"descent_steps", [](SearchTuning& t) -> Number { return &t.descent_steps; }},
    {"reach", [](SearchTuning& t) -> Number { return &t.reach; }},
    {"bound_for_a_sketch", [](SearchTuning& t) -> Number { return &t.bound_for_a_sketch; }},
    {"bound_for_a_step", [](SearchTuning& t) -> Number { return &t.bound_for_a_step; }},
    {"least_us_for_bound", [](SearchTuning& t) -> Number { return &t.least_us_for_bound; }},
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
  const std::string text = assignment.substr(equals + 1);
  std::visit(
      [&](auto* number) {
        const auto value = parsed<std::remove_pointer_t<decltype(number)>>(text);
        if (!(static_cast<double>(value) >= at->least))
          throw std::invalid_argument(name + " has to be " + number_text(at->least) + " or more");
        *number = value;
      },
      at->in(tuning));
}

}  // namespace sonde
