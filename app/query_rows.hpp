// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/accuracy.hpp"
#include "app/phases.hpp"
#include "app/result_table.hpp"
#include "engine/sonde.hpp"

namespace sonde::app {

/// What is asked about each pose of a query.
struct QueryQuestion {
  bool touch = false;      ///< whether the bodies touch, and no more: no search
  bool sweep = false;      ///< how far the motion from each pose to the next is free: no search
  bool clearance = false;  ///< how far apart they are where they are
  bool signed_distance = false;  ///< that, and less than 0, by the depth, where they are not
  std::string contacts = {};     ///< a file for the contacts; empty: none
  std::size_t seeds = 1;         ///< searches of a pose, of which the nearest way out counts
};
void add_flags(CLI::App& parser, QueryQuestion& question);

/// The answer to one pose.
struct QueryAnswer {
  Separation separation;
  bool of_all_motions = true;  ///< false where no depth was sought, or one among some motions only
  SweptPath path;              ///< where a motion was asked about; failed where the separation has
  double time_us = 0;
};

/// A name for a point of the fixed body, that outlives the rows.
using PartName = std::function<const char*(const Vec3&)>;

/// The row of an answer: `index,status` and what follows it.
class QueryRows {
 public:
  /// `limit_us`: the time for each pose, 0: none. It and the others must outlive the rows.
  QueryRows(const QueryQuestion& question, const Accuracy& accuracy, const PhaseOptions& phases,
            const char* shard);

  const std::vector<Column>& columns() const { return columns_; }
  Row row(std::size_t index, const QueryAnswer& answer, const PartName& name_of_part);
  /// On stderr: how many poses took too long, and how many did not converge.
  void note() const;

 private:
  const QueryQuestion& question_;
  const Accuracy& accuracy_;
  const PhaseOptions& phases_;
  const char* shard_;  // in a column of its own; null: none
  double limit_us_;
  std::vector<Column> columns_;
  std::size_t all_ = 0, late_ = 0, unfinished_ = 0;
};

/// The columns of contacts, and the rows of those that hold one separated pose. `shard`: in a
/// column of its own; null: none.
std::span<const Column> contact_columns(const char* shard);
std::vector<Row> contact_rows(std::size_t index, const Separation& answer,
                              const PartName& name_of_part, const char* shard);

}  // namespace sonde::app
