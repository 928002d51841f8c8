// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/search_variation.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <variant>

namespace sonde {
namespace {

using Number = std::variant<double*, int*, std::size_t*>;
struct Named {
  const char* name;
  Number (*in)(SearchTuning&);
};
constexpr Named all[] = {
    {"share_for_sketches", [](SearchTuning& t) -> Number { return &t.share_for_sketches; }},
    {"share_for_search", [](SearchTuning& t) -> Number { return &t.share_for_search; }},
    {"share_for_refining", [](SearchTuning& t) -> Number { return &t.share_for_refining; }},
    {"shortest_for_two_threads",
     [](SearchTuning& t) -> Number { return &t.shortest_for_two_threads; }},
    {"steps_of_first_translation",
     [](SearchTuning& t) -> Number { return &t.steps_of_first_translation; }},
    {"first_sketches", [](SearchTuning& t) -> Number { return &t.first_sketches; }},
    {"most_first_sketches", [](SearchTuning& t) -> Number { return &t.most_first_sketches; }},
    {"most_sketches", [](SearchTuning& t) -> Number { return &t.most_sketches; }},
    {"clear", [](SearchTuning& t) -> Number { return &t.clear; }},
    {"same_place", [](SearchTuning& t) -> Number { return &t.same_place; }},
    {"smallest_ball_of_sketches",
     [](SearchTuning& t) -> Number { return &t.smallest_ball_of_sketches; }},
    {"first_balls_growth", [](SearchTuning& t) -> Number { return &t.first_balls.growth; }},
    {"first_balls_tries", [](SearchTuning& t) -> Number { return &t.first_balls.tries; }},
    {"near_balls_growth", [](SearchTuning& t) -> Number { return &t.near_balls.growth; }},
    {"near_balls_tries", [](SearchTuning& t) -> Number { return &t.near_balls.tries; }},
    {"other_balls_growth", [](SearchTuning& t) -> Number { return &t.other_balls.growth; }},
    {"other_balls_tries", [](SearchTuning& t) -> Number { return &t.other_balls.tries; }},
    {"least_far_ball", [](SearchTuning& t) -> Number { return &t.least_far_ball; }},
    {"largest_far_ball", [](SearchTuning& t) -> Number { return &t.largest_far_ball; }},
    {"largest_end_ball", [](SearchTuning& t) -> Number { return &t.largest_end_ball; }},
    {"ends_for_sketches", [](SearchTuning& t) -> Number { return &t.ends_for_sketches; }},
    {"hopeless_few_points", [](SearchTuning& t) -> Number { return &t.hopeless_few_points; }},
    {"worth_more_points", [](SearchTuning& t) -> Number { return &t.worth_more_points; }},
    {"ends_where_clear", [](SearchTuning& t) -> Number { return &t.ends_where_clear; }},
    {"first_ends", [](SearchTuning& t) -> Number { return &t.first_ends; }},
    {"most_ends", [](SearchTuning& t) -> Number { return &t.most_ends; }},
    {"apart_0", [](SearchTuning& t) -> Number { return &t.apart[0]; }},
    {"apart_1", [](SearchTuning& t) -> Number { return &t.apart[1]; }},
    {"apart_2", [](SearchTuning& t) -> Number { return &t.apart[2]; }},
    {"apart_3", [](SearchTuning& t) -> Number { return &t.apart[3]; }},
    {"apart_4", [](SearchTuning& t) -> Number { return &t.apart[4]; }},
    {"steps_apart", [](SearchTuning& t) -> Number { return &t.steps_apart; }},
    {"beyond_0", [](SearchTuning& t) -> Number { return &t.beyond[0]; }},
    {"beyond_1", [](SearchTuning& t) -> Number { return &t.beyond[1]; }},
    {"beyond_2", [](SearchTuning& t) -> Number { return &t.beyond[2]; }},
    {"beyond_3", [](SearchTuning& t) -> Number { return &t.beyond[3]; }},
    {"beyond_4", [](SearchTuning& t) -> Number { return &t.beyond[4]; }},
    {"beyond_5", [](SearchTuning& t) -> Number { return &t.beyond[5]; }},
    {"sketch_error", [](SearchTuning& t) -> Number { return &t.sketch_error; }},
    {"blind", [](SearchTuning& t) -> Number { return &t.blind; }},
    {"pushes", [](SearchTuning& t) -> Number { return &t.pushes; }},
    {"narrow", [](SearchTuning& t) -> Number { return &t.narrow; }},
    {"narrow_for_pushes", [](SearchTuning& t) -> Number { return &t.narrow_for_pushes; }},
    {"farthest_push", [](SearchTuning& t) -> Number { return &t.farthest_push; }},
    {"given_up_at", [](SearchTuning& t) -> Number { return &t.given_up_at; }},
    {"most_after_sketches", [](SearchTuning& t) -> Number { return &t.most_after_sketches; }},
    {"most_translations_pushed",
     [](SearchTuning& t) -> Number { return &t.most_translations_pushed; }},
    {"overlaps_compared", [](SearchTuning& t) -> Number { return &t.overlaps_compared; }},
    {"plainly_deep", [](SearchTuning& t) -> Number { return &t.plainly_deep; }},
    {"tries_in_a_ball", [](SearchTuning& t) -> Number { return &t.tries_in_a_ball; }},
    {"near_tries", [](SearchTuning& t) -> Number { return &t.near_tries; }},
    {"near_tries_timed", [](SearchTuning& t) -> Number { return &t.near_tries_timed; }},
    {"near_growth", [](SearchTuning& t) -> Number { return &t.near_growth; }},
    {"far_growth", [](SearchTuning& t) -> Number { return &t.far_growth; }},
    {"smallest_ball", [](SearchTuning& t) -> Number { return &t.smallest_ball; }},
    {"largest_ball", [](SearchTuning& t) -> Number { return &t.largest_ball; }},
    {"near_again", [](SearchTuning& t) -> Number { return &t.near_again; }},
    {"ends_for_starts", [](SearchTuning& t) -> Number { return &t.ends_for_starts; }},
    {"about_nearest", [](SearchTuning& t) -> Number { return &t.about_nearest; }},
    {"about_wider", [](SearchTuning& t) -> Number { return &t.about_wider; }},
    {"farthest_overlap", [](SearchTuning& t) -> Number { return &t.farthest_overlap; }},
    {"far_widths_0", [](SearchTuning& t) -> Number { return &t.far_widths[0]; }},
    {"far_widths_1", [](SearchTuning& t) -> Number { return &t.far_widths[1]; }},
    {"far_widths_2", [](SearchTuning& t) -> Number { return &t.far_widths[2]; }},
    {"rough_steps", [](SearchTuning& t) -> Number { return &t.rough_steps; }},
    {"rough_reach", [](SearchTuning& t) -> Number { return &t.rough_reach; }},
    {"worth_exact", [](SearchTuning& t) -> Number { return &t.worth_exact; }},
    {"exact_steps", [](SearchTuning& t) -> Number { return &t.exact_steps; }},
    {"exact_reach", [](SearchTuning& t) -> Number { return &t.exact_reach; }},
    {"exact_reach_alone", [](SearchTuning& t) -> Number { return &t.exact_reach_alone; }},
    {"hopeless", [](SearchTuning& t) -> Number { return &t.hopeless; }},
    {"same", [](SearchTuning& t) -> Number { return &t.same; }},
    {"refined", [](SearchTuning& t) -> Number { return &t.refined; }},
    {"translation_competes", [](SearchTuning& t) -> Number { return &t.translation_competes; }},
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
  const std::string value = assignment.substr(equals + 1);
  std::visit(
      [&](auto* number) { *number = parsed<std::remove_pointer_t<decltype(number)>>(value); },
      at->in(tuning));
}

}  // namespace sonde
