// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/recording/block.hpp"

namespace sonde {

/// The bytes of a block, including its header, from wherever they are stored. Throws InputError if
/// they are no longer available.
using BlockBytes = std::function<std::string()>;

/// The ticks of one probe in order, in compressed blocks, with the searches, from a running servo
/// or from a file. For one thread.
class TickLog {
 public:
  /// Drops the oldest block if there is more; 0: no limit.
  struct Limits {
    std::uint64_t ticks = 0;
    std::size_t bytes = 0;
  };
  static constexpr std::size_t block_ticks = 512;

  /// For a probe of that radius, m, at that rate, Hz.
  TickLog(double probe_radius, double rate_hz, Limits limits);
  TickLog(double probe_radius, double rate_hz) : TickLog(probe_radius, rate_hz, Limits{}) {}

  /// Adds a tick. Times never decrease: a tick that is not later than the one before is the first
  /// of another run of the servo, and gets a time one period later. A paused tick is not added;
  /// then it returns false.
  bool add(const Snapshot& tick);
  /// Adds a search that has just ended, at the time of the last tick.
  void add(const BackgroundResult& search);
  /// Adds a search with its own time.
  void add(const RecordedSearch& search) { searches_.push_back(search); }
  /// Adds a finished block, whose ticks follow the existing ones. `place` is the beginning of error
  /// messages about its content.
  void add(const BlockHead& head, BlockBytes bytes, std::string place = "");
  /// Puts the ticks that are not yet in a block into one.
  void seal();
  /// Called with each block made here, searches before the ticks of their time.
  std::function<void(const std::shared_ptr<const std::string>&)> sealed;

  /// The ticks are those of a path: the time between two is known, however long it is. For a servo,
  /// the time across a pause and across lost ticks is unknown.
  bool along_path = false;

  /// Ticks are counted from 0, including dropped ones; [begin, end) are available.
  std::uint64_t begin() const { return blocks_.empty() ? sealed_ : blocks_.front().begin; }
  std::uint64_t end() const { return sealed_ + open_.size(); }
  bool empty() const { return begin() == end(); }
  double first_time() const;  ///< s; 0 if there are no ticks
  double last_time() const;
  /// One of these ticks. Throws InputError if the file no longer contains it.
  Snapshot at(std::uint64_t index) const;
  /// The last tick at or before that time; the first one if all are later. The log must not be
  /// empty.
  std::uint64_t find(double time) const;
  /// The newest search that had ended by then; null if there is none.
  const RecordedSearch* searched(double time) const;
  const std::deque<RecordedSearch>& searches() const { return searches_; }

  double probe_radius() const { return probe_radius_; }
  double rate_hz() const { return rate_hz_; }
  std::size_t bytes() const;  ///< of memory, for ticks and searches
  /// All blocks, in the order of a file: the searches in one, then the ticks.
  std::vector<BlockBytes> all() const;

 private:
  struct Stored {
    BlockHead head;
    std::uint64_t begin = 0;
    std::size_t in_memory = 0;  ///< bytes
    BlockBytes bytes;
    std::string place;  ///< in a file; empty in memory
  };
  const std::vector<Snapshot>& decoded(const Stored& block) const;
  const Stored& block_of(std::uint64_t index) const;
  void store(const BlockHead& head, std::size_t in_memory, BlockBytes bytes,
             std::string place = "");
  void forget();

  double probe_radius_;
  double rate_hz_;
  Limits limits_;
  std::deque<Stored> blocks_;
  std::uint64_t sealed_ = 0;    ///< number of ticks in blocks so far
  std::vector<Snapshot> open_;  ///< the ticks after those
  std::deque<RecordedSearch> searches_;
  std::vector<RecordedSearch> open_searches_;
  std::size_t stored_bytes_ = 0;
  double shift_ = 0;      ///< s, from the servo's time to the log's
  double last_raw_ = -1;  ///< s, of the servo
  struct Decoded {
    std::uint64_t begin;
    std::vector<Snapshot> ticks;
  };
  mutable std::deque<Decoded> cache_;  ///< most recently used first
};

}  // namespace sonde
