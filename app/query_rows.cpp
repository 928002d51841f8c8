// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/query_rows.hpp"

#include <array>
#include <iostream>
#include <optional>

#include "app/room.hpp"
#include "engine/text/number_text.hpp"

namespace sonde::app {
namespace {

constexpr std::array<Column, 16> query_columns{{{"index", ""},
                                                {"status", ""},
                                                {"depth", "m"},
                                                {"sigma", "m^2"},
                                                {"px", "m"},
                                                {"py", "m"},
                                                {"pz", "m"},
                                                {"qw", ""},
                                                {"qx", ""},
                                                {"qy", ""},
                                                {"qz", ""},
                                                {"lower_bound", "m"},
                                                {"contacts", ""},
                                                {"residual", ""},
                                                {"iterations", ""},
                                                {"time_us", "us"}}};
constexpr std::array<Column, 8> clearance_columns{{{"clearance", "m"},
                                                   {"ax", "m"},
                                                   {"ay", "m"},
                                                   {"az", "m"},
                                                   {"bx", "m"},
                                                   {"by", "m"},
                                                   {"bz", "m"},
                                                   {"part", ""}}};

constexpr std::array<Column, 16> sweep_columns{{{"index", ""},
                                                {"status", ""},
                                                {"free", ""},
                                                {"px", "m"},
                                                {"py", "m"},
                                                {"pz", "m"},
                                                {"qw", ""},
                                                {"qx", ""},
                                                {"qy", ""},
                                                {"qz", ""},
                                                {"x", "m"},
                                                {"y", "m"},
                                                {"z", "m"},
                                                {"nx", ""},
                                                {"ny", ""},
                                                {"nz", ""}}};

void add(std::vector<Column>& columns, std::span<const Column> more) {
  columns.insert(columns.end(), more.begin(), more.end());
}

Row search_row(std::size_t index, const QueryAnswer& answer) {
  const Separation& s = answer.separation;
  const bool failed = s.status == Status::failed;
  Row row{static_cast<std::int64_t>(index), name_of(s.status)};
  if (failed) {
    append_nothing(row, 10);  // from depth to lower_bound
  } else {
    row.insert(row.end(), {s.depth, s.sigma});
    append(row, s.separated);
    row.push_back(s.lower_bound ? Cell(*s.lower_bound) : Cell());
  }
  row.push_back(std::int64_t{failed ? 0 : s.clusters.size});
  row.push_back(failed ? Cell() : Cell(s.residual));
  row.push_back(std::int64_t{s.iterations});
  row.push_back(answer.time_us);
  return row;
}

Row sweep_row(std::size_t index, const QueryAnswer& answer) {
  const SweptPath& path = answer.path;
  const bool failed = answer.separation.status == Status::failed;
  const char* status = failed             ? name_of(Status::failed)
                       : path.overlapping ? "overlapping"
                       : path.hit         ? "hit"
                                          : "free";
  Row row{static_cast<std::int64_t>(index), status};
  if (failed) {
    append_nothing(row, 14);
    return row;
  }
  row.push_back(path.free);
  append(row, path.X_FM);
  if (path.hit && !path.overlapping) {
    append(row, path.contact.on_fixed);
    append(row, path.contact.normal);
  } else {
    append_nothing(row, 6);
  }
  return row;
}

Cell cell_of(const std::optional<double>& number) { return number ? Cell(*number) : Cell(); }

void append_clearance(Row& row, const QueryAnswer& answer, const PartName& name_of_part) {
  const Separation& s = answer.separation;
  if (s.status == Status::penetrating && !answer.of_all_motions)
    return append_nothing(row, clearance_columns.size());
  const Room room = room_of(s);
  row.push_back(cell_of(room.clearance));
  if (s.status == Status::separated && s.clearance) {
    append(row, s.clearance->on_probe);
    append(row, s.clearance->on_fixed);
  } else {
    append_nothing(row, 6);  // a depth is taken along a motion, not between two points
  }
  row.push_back(room.on_fixed ? Cell(name_of_part(*room.on_fixed)) : Cell());
}

}  // namespace

void add_flags(CLI::App& parser, QueryQuestion& question) {
  const char* group = "What is asked";
  parser
      .add_flag("--touch", question.touch,
                "only whether the bodies touch or overlap: index,status, and no search")
      ->group(group);
  parser
      .add_flag("--sweep", question.sweep,
                "how far the motion from each pose to the next is free, the pose there and the "
                "contact: index,status,free, px to qz, x,y,z, nx,ny,nz, and no search")
      ->group(group);
  parser
      .add_flag("--signed-distance", question.signed_distance,
                "one number as a last column: the least distance where the bodies are apart, less "
                "than 0, by the depth, where they are not")
      ->group(group);
  parser
      .add_flag(
          "--clearance", question.clearance,
          "where the bodies are apart, their least distance, the points of probe (ax,ay,az) and "
          "fixed body (bx,by,bz) where it is taken, and the part of the fixed body there; where "
          "they are not, less than 0, by the depth, without points, and the part that bears most; "
          "with --touch, --along, --about and --in-plane only where they are apart")
      ->group(group);
  parser
      .add_option("--contacts", question.contacts,
                  "file to write, a row for each contact of a separated pose: index,x,y,z, "
                  "nx,ny,nz, multiplier,part")
      ->group(group);
  parser
      .add_option("--seeds", question.seeds,
                  "searches of each pose, with seeds of their own: the nearest way out counts, and "
                  "the largest lower bound")
      ->check(CLI::Range(std::size_t{1}, std::size_t{10'000}))
      ->capture_default_str()
      ->group(group);
}

QueryRows::QueryRows(const QueryQuestion& question, const Accuracy& accuracy,
                     const PhaseOptions& phases, const char* shard)
    : question_(question),
      accuracy_(accuracy),
      phases_(phases),
      shard_(shard),
      limit_us_(accuracy.time_us()) {
  if (question.sweep) {
    columns_.assign(sweep_columns.begin(), sweep_columns.end());
  } else if (question.touch) {
    columns_.assign(query_columns.begin(), query_columns.begin() + 2);
    if (question.clearance) add(columns_, clearance_columns);
  } else {
    add(columns_, query_columns);
    if (question.clearance) add(columns_, clearance_columns);
    columns_ = accuracy.with_claims(columns_);
    if (limit_us_ > 0) columns_.push_back({"late", ""});
    columns_ = with_phases(phases, columns_);
    if (question.signed_distance) columns_.push_back({"signed_distance", "m"});
  }
  if (shard) columns_.push_back({"shard", ""});
}

Row QueryRows::row(std::size_t index, const QueryAnswer& answer, const PartName& name_of_part) {
  const Separation& s = answer.separation;
  ++all_;
  Row row;
  if (question_.sweep) {
    row = sweep_row(index, answer);
  } else if (question_.touch) {
    row = {static_cast<std::int64_t>(index), name_of(s.status)};
    if (question_.clearance) append_clearance(row, answer, name_of_part);
  } else {
    row = search_row(index, answer);
    if (question_.clearance) append_clearance(row, answer, name_of_part);
    accuracy_.append_claim(row, s);
    if (limit_us_ > 0) {
      const bool late = answer.time_us > not_late * limit_us_;
      row.push_back(late);
      late_ += late;
    }
    append_phases(phases_, row, s);
    if (question_.signed_distance) row.push_back(cell_of(room_of(s).clearance));
    unfinished_ += s.status == Status::penetrating && !s.converged;
  }
  if (shard_) row.push_back(shard_);
  return row;
}

void QueryRows::note() const {
  if (late_ > 0)
    std::cerr << "sonde: " << late_ << " of " << all_ << " poses took over "
              << number_text(not_late, 2) << " times the time for each, "
              << number_text(1e-3 * limit_us_, 3) << " ms (late)\n";
  if (unfinished_ > 0)
    std::cerr << "sonde: " << unfinished_ << " of " << all_
              << " poses did not converge: their depths are upper bounds\n";
}

std::span<const Column> contact_columns(const char* shard) {
  static constexpr std::array<Column, 10> all{{{"index", ""},
                                               {"x", "m"},
                                               {"y", "m"},
                                               {"z", "m"},
                                               {"nx", ""},
                                               {"ny", ""},
                                               {"nz", ""},
                                               {"multiplier", "m"},
                                               {"part", ""},
                                               {"shard", ""}}};
  return std::span(all).first(shard ? all.size() : all.size() - 1);
}

std::vector<Row> contact_rows(std::size_t index, const Separation& answer,
                              const PartName& name_of_part, const char* shard) {
  std::vector<Row> rows;
  if (answer.status != Status::penetrating) return rows;
  for (const Contact& contact : answer.contacts) {
    Row row{static_cast<std::int64_t>(index)};
    append(row, contact.on_fixed);
    append(row, contact.normal);
    row.push_back(contact.multiplier);
    row.push_back(name_of_part(contact.on_fixed));
    if (shard) row.push_back(shard);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace sonde::app
