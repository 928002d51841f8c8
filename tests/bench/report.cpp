// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report.hpp"

#include <algorithm>

namespace sonde::bench {
namespace {

Cell count(std::size_t value) { return static_cast<std::int64_t>(value); }

bool timed(const LibraryResult* result) { return result && !result->calls.empty(); }

/// How many times as long it took as Sonde; nothing where one was not timed.
std::optional<double> ratio(const Result& result, const LibraryResult& library) {
  const LibraryResult* mine = result.find(ours);
  if (!timed(mine) || library.calls.empty() || library.library == ours) return {};
  return ratio_of_medians(library.calls, mine->calls);
}

std::vector<Cell> long_row(const Result& result, const LibraryResult& library) {
  const Statistics s = summarize(library.calls);
  return {result.query,
          result.poses,
          result.pair,
          count(result.triangles_a),
          count(result.triangles_b),
          library.library,
          count(s.poses),
          count(s.calls),
          s.median_us,
          s.p99_us,
          cell(s.tail),
          cell(ratio(result, library)),
          result.amount_name,
          cell(library.amount),
          count(library.compared),
          count(library.excused),
          count(library.missed)};
}

/// The libraries of one query, each once, in order of appearance.
std::vector<std::string> libraries_of(const std::vector<Result>& results,
                                      const std::string& query) {
  std::vector<std::string> out;
  for (const Result& result : results)
    for (const LibraryResult& library : result.libraries)
      if (result.query == query && std::find(out.begin(), out.end(), library.library) == out.end())
        out.push_back(library.library);
  return out;
}

struct Wide {
  std::vector<std::string> libraries;
  bool amounts = false, tails = false, excused = false, missed = false;
};

Wide wide_columns(const std::vector<Result>& results, const std::string& query) {
  Wide out{libraries_of(results, query)};
  for (const Result& result : results) {
    if (result.query != query) continue;
    out.amounts |= !result.amount_name.empty();
    for (const LibraryResult& library : result.libraries) {
      out.tails |= library.library == ours && timed(&library) && summarize(library.calls).tail;
      out.excused |= library.excused > 0;
      out.missed |= library.missed > 0;
    }
  }
  return out;
}

void add_library_columns(const Wide& wide, const std::string& library,
                         const std::string& amount_name, Table& table) {
  table.columns.push_back({library, "median us"});
  table.columns.push_back({"", "p99 us"});
  if (library == ours && wide.tails) table.columns.push_back({"p99.9/p99", "of calls"});
  if (library != ours) {
    table.columns.push_back({"", "/ Sonde"});
    if (wide.excused) table.columns.push_back({"", "in doubt"});
    if (wide.missed) table.columns.push_back({"", "missed"});
  }
  if (wide.amounts) table.columns.push_back({"", amount_name});
}

void add_library_cells(const Wide& wide, const Result& result, const std::string& name,
                       std::vector<Cell>& row) {
  const LibraryResult* library = result.find(name);
  if (!timed(library)) {
    Table columns;
    add_library_columns(wide, name, {}, columns);
    row.resize(row.size() + columns.columns.size());
    return;
  }
  const Statistics s = summarize(library->calls);
  row.emplace_back(s.median_us);
  row.emplace_back(s.p99_us);
  if (name == ours && wide.tails) row.push_back(cell(s.tail));
  if (name != ours) {
    row.push_back(cell(ratio(result, *library)));
    if (wide.excused) row.push_back(count(library->excused));
    if (wide.missed) row.push_back(count(library->missed));
  }
  if (wide.amounts) row.push_back(cell(library->amount));
}

std::string amount_name_of(const std::vector<Result>& results, const std::string& query) {
  for (const Result& result : results)
    if (result.query == query && !result.amount_name.empty()) return result.amount_name;
  return {};
}

Table wide_table(const std::vector<Result>& results, const std::string& query) {
  const Wide wide = wide_columns(results, query);
  Table out;
  out.columns = {
      {"poses", ""}, {"pair", ""}, {"triangles", "of A"}, {"", "of B"}, {"number", "of poses"}};
  for (const std::string& library : wide.libraries)
    add_library_columns(wide, library, amount_name_of(results, query), out);
  for (const Result& result : results) {
    if (result.query != query) continue;
    const LibraryResult* mine = result.find(ours);
    auto& row = out.rows.emplace_back(
        std::vector<Cell>{result.poses, result.pair, count(result.triangles_a),
                          count(result.triangles_b), mine ? count(mine->compared) : Cell{}});
    for (const std::string& library : wide.libraries) add_library_cells(wide, result, library, row);
  }
  // By poses, in the order in which these came; then by pair.
  std::vector<Cell> order;
  for (const auto& row : out.rows)
    if (std::find(order.begin(), order.end(), row.front()) == order.end())
      order.push_back(row.front());
  const auto rank = [&](const std::vector<Cell>& row) {
    return std::find(order.begin(), order.end(), row.front()) - order.begin();
  };
  std::stable_sort(out.rows.begin(), out.rows.end(),
                   [&](const auto& x, const auto& y) { return rank(x) < rank(y); });
  return out;
}

/// Where one library's curve is drawn from, and what of it.
enum class Value { median_us, median_ms, amount };

Series series(const std::vector<Result>& results, const std::string& name, const std::string& query,
              const std::string& poses, const std::string& library, Value value) {
  Series out{name, {}, {}, library != ours};
  for (const Result& result : results) {
    const LibraryResult* r = result.find(library);
    if (!result.scale || result.query != query || result.poses != poses || !r) continue;
    if (value == Value::amount ? !r->amount : r->calls.empty()) continue;
    out.x.push_back(static_cast<double>(result.triangles_a));
    const double scale = value == Value::median_ms ? 1e-3 : 1;
    out.y.push_back(value == Value::amount ? *r->amount : scale * summarize(r->calls).median_us);
  }
  return out;
}

}  // namespace

Table long_table(const std::vector<Result>& results) {
  Table out;
  out.columns = {{"query", ""},       {"poses", ""},    {"pair", ""},          {"triangles_a", ""},
                 {"triangles_b", ""}, {"library", ""},  {"pose_count", ""},    {"calls", ""},
                 {"median_us", "us"}, {"p99_us", "us"}, {"p999_over_p99", ""}, {"over_sonde", ""},
                 {"amount_name", ""}, {"amount", ""},   {"compared", ""},      {"in_doubt", ""},
                 {"missed", ""}};
  for (const Result& result : results)
    for (const LibraryResult& library : result.libraries)
      if (timed(&library)) out.rows.push_back(long_row(result, library));
  return out;
}

std::string wide_tables(const std::vector<Result>& results) {
  std::vector<std::string> names;
  for (const Result& result : results)
    if (std::find(names.begin(), names.end(), result.query) == names.end())
      names.push_back(result.query);
  std::string out;
  for (const std::string& query : names)
    out += query + "\n\n" + to_text(wide_table(results, query)) + "\n";
  return out;
}

std::map<std::string, Plot> plots(const std::vector<Result>& results) {
  const auto curve = [&](const char* name, const char* query, const char* poses,
                         const char* library, Value value) {
    return series(results, name, query, poses, library, value);
  };
  const std::string x = "triangles a side";
  std::map<std::string, Plot> out;
  out["query-times.svg"] = {
      "Queries along a trajectory at a gap of 1 % of R, two trefoils",
      x,
      "median time, µs",
      {curve("touch", "touch", "trajectory", ours, Value::median_us),
       curve("distance, warm", "distance-warm", "trajectory", ours, Value::median_us),
       curve("near pairs", "near-pairs", "trajectory", ours, Value::median_us),
       curve("touch, FCL", "touch", "trajectory", "FCL", Value::median_us),
       curve("touch, Bullet", "touch", "trajectory", "Bullet", Value::median_us),
       curve("distance, FCL", "distance-warm", "trajectory", "FCL", Value::median_us)}};
  out["near-rows.svg"] = {"Near pairs within 2 % of R",
                          x,
                          "rows",
                          {curve("rows", "near-pairs", "trajectory", ours, Value::amount)}};
  Plot build{"Building", x, "median time, ms", {}}, memory{"Memory", x, "bytes per triangle", {}};
  for (const char* library : {ours, "FCL", "Bullet"}) {
    build.series.push_back(curve(library, "build", "-", library, Value::median_ms));
    memory.series.push_back(curve(library, "build", "-", library, Value::amount));
  }
  out["build-times.svg"] = build;
  out["memory.svg"] = memory;
  return out;
}

}  // namespace sonde::bench
