// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/summary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/bench/statistics.hpp"

namespace sonde::reference {
namespace {

using bench::Cell;
using bench::Table;
using Chosen = std::vector<const Measured*>;
using Wanted = std::function<bool(const Measured&)>;

Cell count(auto n) { return static_cast<std::int64_t>(n); }

Cell number_or_nothing(const std::vector<double>& values, auto of) {
  return values.empty() ? Cell{} : Cell{of(values)};
}

std::int64_t how_many(const Chosen& rows, const Wanted& wanted) {
  return std::count_if(rows.begin(), rows.end(), [&](const Measured* m) { return wanted(*m); });
}

std::vector<double> values(const Chosen& rows, auto of) {
  std::vector<double> out;
  for (const Measured* m : rows) out.push_back(of(*m));
  return out;
}

double p99(const std::vector<double>& values) { return bench::percentile(values, 0.99); }

/// Lower bound over depth; nothing for two surfaces, which have none.
std::vector<double> bound_ratios(const Chosen& rows) {
  std::vector<double> out;
  for (const Measured* m : rows)
    if (m->lower_bound && m->got.depth > 0) out.push_back(*m->lower_bound / m->got.depth);
  return out;
}

const std::vector<bench::Column> summary_columns = {
    {"group", ""},       {"poses", ""},         {"within 1 %", ""},  {"within 5 %", ""},
    {"better", ""},      {"failed", ""},        {"not free", ""},    {"worst excess", "%"},
    {"median", "ms"},    {"p99", "ms"},         {"p99/budget", ""},  {"bound median", "ms"},
    {"bound p99", "ms"}, {"low/up median", ""}, {"low/up worst", ""}};

void add_line(Table& table, const std::string& name, const Chosen& rows, double budget_us) {
  if (rows.empty()) return;
  const auto times = values(rows, [](const Measured& m) { return 1e-3 * m.time_us; });
  const auto bounds = values(rows, [](const Measured& m) { return 1e-3 * m.bound_us; });
  const auto excess = values(rows, [](const Measured& m) { return 100 * m.excess(); });
  const auto ratios = bound_ratios(rows);
  table.rows.push_back(
      {name, count(rows.size()),
       how_many(rows, [](const Measured& m) { return m.excess() <= 0.01; }),
       how_many(rows, [](const Measured& m) { return m.excess() <= 0.05; }),
       how_many(rows, [](const Measured& m) { return m.excess() < -repeats_to; }),
       how_many(rows, [](const Measured& m) { return m.got.status != Status::penetrating; }),
       how_many(rows, [](const Measured& m) { return m.got.status != Status::failed && !m.free; }),
       *std::max_element(excess.begin(), excess.end()), bench::median(times), p99(times),
       budget_us > 0 ? Cell{1e3 * p99(times) / budget_us} : Cell{}, bench::median(bounds),
       p99(bounds), number_or_nothing(ratios, [](const auto& v) { return bench::median(v); }),
       number_or_nothing(ratios,
                         [](const auto& v) { return *std::min_element(v.begin(), v.end()); })});
}

Chosen chosen(const std::vector<Measured>& all, const Wanted& wanted) {
  Chosen out;
  for (const Measured& m : all)
    if (wanted(m)) out.push_back(&m);
  return out;
}

const std::vector<bench::Column> detail_columns = {
    {"case", ""},      {"triangles a", ""}, {"triangles b", ""},  {"reference", "m"},
    {"agreed", ""},    {"hits", ""},        {"starts", ""},       {"depth", "m"},
    {"excess", "%"},   {"time", "ms"},      {"iterations", ""},   {"residual", ""},
    {"converged", ""}, {"contacts", ""},    {"lower bound", "m"}, {"bound time", "ms"},
    {"free", ""}};

void add_detail(Table& table, const Measured& m) {
  table.rows.push_back({name(m.row), count(m.row.triangles_a), count(m.row.triangles_b),
                        m.reference, count(agreed(m.row)), count(m.row.hits),
                        count(3 * m.row.starts), m.got.depth, 100 * m.excess(), 1e-3 * m.time_us,
                        count(m.got.iterations), m.got.residual, count(m.got.converged),
                        count(m.got.contacts.size), m.lower_bound ? Cell{*m.lower_bound} : Cell{},
                        1e-3 * m.bound_us, count(m.free)});
}

}  // namespace

Table summary(const std::vector<Measured>& all, double budget_us) {
  Table out{summary_columns, {}};
  std::vector<std::string> pairs;
  for (const Measured& m : all)
    if (pairs.empty() || pairs.back() != m.row.pair) pairs.push_back(m.row.pair);
  const auto add = [&](const std::string& name, const Wanted& wanted) {
    add_line(out, name, chosen(all, wanted), budget_us);
  };
  for (const std::string& pair : pairs)
    add(pair, [&](const Measured& m) { return m.row.pair == pair; });
  for (const char* kind : {"shallow", "medium", "deep", "linked"})
    add(std::string("all ") + kind, [&](const Measured& m) { return m.row.kind == kind; });
  add("all agreed", [](const Measured& m) { return agreed(m.row); });
  add("all not agreed", [](const Measured& m) { return !agreed(m.row); });
  add("all", [](const Measured&) { return true; });
  return out;
}

Table details(const std::vector<Measured>& all) {
  Table out{detail_columns, {}};
  for (const Measured& m : all) add_detail(out, m);
  return out;
}

Table worst(const std::vector<Measured>& all, std::size_t most) {
  Chosen rows = chosen(all, [](const Measured& m) { return m.excess() > 0.01; });
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Measured* a, const Measured* b) { return a->excess() > b->excess(); });
  Table out{detail_columns, {}};
  for (std::size_t i = 0; i < std::min(most, rows.size()); ++i) add_detail(out, *rows[i]);
  return out;
}

Table better(const std::vector<Measured>& all) {
  Table out{detail_columns, {}};
  for (const Measured* m :
       chosen(all, [](const Measured& each) { return each.excess() < -repeats_to; }))
    add_detail(out, *m);
  return out;
}

}  // namespace sonde::reference
