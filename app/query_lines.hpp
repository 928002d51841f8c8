// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "app/part_file.hpp"
#include "app/result_table.hpp"

namespace sonde::app {

/// Where the lines of a query go.
struct QueryFiles {
  std::string result;    ///< empty: no part is kept
  std::string contacts;  ///< empty: nobody asked for contacts
  bool json = false;     ///< the lines of the result are JSON
  bool resume = false;   ///< goes on from the parts that are there
};

/// The lines of a query's results and of its contacts, with the parts on the disk while it runs. In
/// the part of the contacts each pose ends by a line of its own, so that it is known which poses
/// are whole there.
class QueryLines {
 public:
  /// `run`: as of PartFile. Throws InputError as that does, and where one of both parts is missing.
  QueryLines(const QueryFiles& files, const std::string& run);

  /// Where a run that does not resume writes over what an interrupted one has left: that file.
  std::string written_over() const;
  /// How many of the poses, given by their indices in order, are answered in the parts.
  std::size_t taken_over(std::span<const std::size_t> indices);
  /// A pose's row, and the rows of its contacts where these were asked for. In JSON, the row holds
  /// the contacts as well.
  void add(std::span<const Column> columns, const Row& row,
           std::span<const Column> contact_columns = {}, std::span<const Row> contacts = {});
  /// To the disk, once a second.
  void flush_now_and_then();
  std::span<const std::string> lines() const { return main_.lines(); }
  std::vector<std::string> contacts() const;
  void done() { main_.done(), contacts_.done(); }

 private:
  std::size_t keep_whole_contacts(std::span<const std::size_t> indices);

  bool json_, wants_contacts_, resume_;
  PartFile main_, contacts_;
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

}  // namespace sonde::app
