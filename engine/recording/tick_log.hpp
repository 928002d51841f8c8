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

/// The bytes of a block, head included, wherever they are stored. Throws InputError where they are
/// no longer available.
using BlockBytes = std::function<std::string()>;

/// The ticks of one probe in order, in compressed blocks, with the searches beside them, from a
/// running servo or from a file. For one thread.
class TickLog {
 public:
  /// Drops the oldest block where there is more; 0: no limit.
  struct Limits {
    std::uint64_t ticks = 0;
    std::size_t bytes = 0;
  };
  static constexpr std::size_t block_ticks = 512;

  /// For a probe of that radius, m, at that rate, Hz.
  TickLog(double probe_radius, double rate_hz, Limits limits);
  TickLog(double probe_radius, double rate_hz) : TickLog(probe_radius, rate_hz, Limits{}) {}

  /// Adds a tick. Times never fall: a tick that is not later than the one before is the first of
  /// another run of the servo, and gets a time one period after that. Leaves out a paused tick and
  /// returns false then.
  bool add(const Snapshot& tick);
  /// A search that has ended now, at the time of the last tick.
  void add(const BackgroundResult& search);
  /// A search with a time of its own.
  void add(const RecordedSearch& search) { searches_.push_back(search); }
  /// Adds a finished block. Its ticks come after those before.
  /// `place` is what a complaint about its content begins with.
  void add(const BlockHead& head, BlockBytes bytes, std::string place = "");
  /// Makes a block from the ticks that are not yet in one.
  void seal();
  /// Called with each block made here, searches before the ticks of their time.
  std::function<void(const std::shared_ptr<const std::string>&)> sealed;

  /// The ticks are those of a path: the time between two is known, however long. That of a servo is
  /// not known across a pause and across ticks that were lost.
  bool along_path = false;

  /// Ticks are counted from 0, including dropped ones; [begin, end) are there.
  std::uint64_t begin() const { return blocks_.empty() ? sealed_ : blocks_.front().begin; }
  std::uint64_t end() const { return sealed_ + open_.size(); }
  bool empty() const { return begin() == end(); }
  double first_time() const;  ///< s; 0 where there is no tick
  double last_time() const;
  /// One of these ticks. Throws InputError where the file no longer holds it.
  Snapshot at(std::uint64_t index) const;
  /// The last tick that is not later than that; the first where all are later. The log must not be
  /// empty.
  std::uint64_t find(double time) const;
  /// The newest search that had ended by then; null where there is none.
  const RecordedSearch* searched(double time) const;
  const std::deque<RecordedSearch>& searches() const { return searches_; }

  double probe_radius() const { return probe_radius_; }
  double rate_hz() const { return rate_hz_; }
  std::size_t bytes() const;  ///< of memory, for ticks and searches
  /// All blocks, as a file holds them: the searches in one, then the ticks.
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
  std::uint64_t sealed_ = 0;    ///< ticks in blocks so far
  std::vector<Snapshot> open_;  ///< those after them
  std::deque<RecordedSearch> searches_;
  std::vector<RecordedSearch> open_searches_;
  std::size_t stored_bytes_ = 0;
  double shift_ = 0;      ///< s, from the servo's time to this
  double last_raw_ = -1;  ///< s, of the servo
  struct Decoded {
    std::uint64_t begin;
    std::vector<Snapshot> ticks;
  };
  mutable std::deque<Decoded> cache_;  ///< the newest used first
};

}  // namespace sonde
