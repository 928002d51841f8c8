// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/tick_log.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

constexpr std::size_t most_cached = 3;

BlockBytes in_memory(std::shared_ptr<const std::string> bytes) {
  return [bytes = std::move(bytes)] { return *bytes; };
}

/// The header is used instead of the ticks until they are decoded, so it must be correct.
void check(const std::vector<Snapshot>& ticks, const BlockHead& head) {
  if (ticks.size() != head.rows || ticks.empty())
    throw std::invalid_argument("a block holds other ticks than its head says");
  double before = head.first;
  for (const Snapshot& tick : ticks) {
    if (!(tick.time >= before)) throw std::invalid_argument("the times of a block fall");
    before = tick.time;
  }
  if (ticks.front().time != head.first || before != head.last)
    throw std::invalid_argument("a block holds other times than its head says");
}

}  // namespace

TickLog::TickLog(double probe_radius, double rate_hz, Limits limits)
    : probe_radius_(probe_radius), rate_hz_(rate_hz), limits_(limits) {
  open_.reserve(block_ticks);
}

bool TickLog::add(const Snapshot& tick) {
  if (tick.paused) return false;
  if (!(tick.time > last_raw_) && !empty()) shift_ = last_time() + 1 / rate_hz_ - tick.time;
  last_raw_ = tick.time;
  open_.push_back(tick);
  open_.back().time += shift_;
  if (open_.size() >= block_ticks) seal();
  return true;
}

void TickLog::add(const BackgroundResult& search) {
  searches_.push_back({last_time(), search});
  open_searches_.push_back(searches_.back());
}

void TickLog::add(const BlockHead& head, BlockBytes bytes, std::string place) {
  store(head, 0, std::move(bytes), std::move(place));
}

void TickLog::seal() {
  const auto hand_on = [this](std::string block) {
    auto bytes = std::make_shared<const std::string>(std::move(block));
    if (sealed) sealed(bytes);
    return bytes;
  };
  if (!open_searches_.empty()) hand_on(search_block(open_searches_));
  open_searches_.clear();
  if (open_.empty()) return;
  const auto bytes = hand_on(tick_block(open_));
  cache_.push_front({sealed_, std::exchange(open_, {})});  // it may be displayed
  if (cache_.size() > most_cached) cache_.pop_back();
  open_.reserve(block_ticks);
  store(head_of(*bytes), bytes->size(), in_memory(bytes));
}

void TickLog::store(const BlockHead& head, std::size_t in_memory, BlockBytes bytes,
                    std::string place) {
  blocks_.push_back({head, sealed_, in_memory, std::move(bytes), std::move(place)});
  sealed_ += head.rows;
  stored_bytes_ += in_memory;
  forget();
}

void TickLog::forget() {
  const auto too_much = [this] {
    return (limits_.ticks > 0 && end() - begin() > limits_.ticks) ||
           (limits_.bytes > 0 && bytes() > limits_.bytes);
  };
  while (blocks_.size() > 1 && too_much()) {
    stored_bytes_ -= blocks_.front().in_memory;
    blocks_.pop_front();
    // The last search before the remaining ticks still applies at their beginning.
    while (searches_.size() > 1 && searches_[1].time < first_time()) searches_.pop_front();
  }
}

std::size_t TickLog::bytes() const {
  std::size_t of_open = (block_ticks + most_cached * block_ticks) * sizeof(Snapshot);
  return of_open + stored_bytes_ + blocks_.size() * sizeof(Stored) +
         searches_.size() * sizeof(RecordedSearch);
}

double TickLog::first_time() const {
  if (!blocks_.empty()) return blocks_.front().head.first;
  return open_.empty() ? 0 : open_.front().time;
}

double TickLog::last_time() const {
  if (!open_.empty()) return open_.back().time;
  return blocks_.empty() ? 0 : blocks_.back().head.last;
}

const TickLog::Stored& TickLog::block_of(std::uint64_t index) const {
  const auto after =
      std::ranges::upper_bound(blocks_, index, {}, [](const Stored& b) { return b.begin; });
  return *std::prev(after);
}

const std::vector<Snapshot>& TickLog::decoded(const Stored& block) const {
  const auto found =
      std::ranges::find(cache_, block.begin, [](const Decoded& d) { return d.begin; });
  if (found != cache_.end()) return found->ticks;
  try {
    std::vector<Snapshot> ticks = ticks_in(content_of(block.head, block.bytes()), probe_radius_);
    check(ticks, block.head);
    cache_.push_front({block.begin, std::move(ticks)});
  } catch (const std::invalid_argument& bad) {
    throw block.place.empty() ? InputError(bad.what()) : InputError::in(block.place, bad.what());
  }
  if (cache_.size() > most_cached) cache_.pop_back();
  return cache_.front().ticks;
}

Snapshot TickLog::at(std::uint64_t index) const {
  if (index < begin() || index >= end()) throw std::out_of_range("no such tick");
  if (index >= sealed_) return open_[static_cast<std::size_t>(index - sealed_)];
  const Stored& block = block_of(index);
  return decoded(block)[static_cast<std::size_t>(index - block.begin)];
}

std::uint64_t TickLog::find(double time) const {
  const auto in = [time](const std::vector<Snapshot>& ticks) {
    const auto after = std::ranges::upper_bound(ticks, time, {}, &Snapshot::time);
    return static_cast<std::uint64_t>(std::max<std::ptrdiff_t>(0, after - ticks.begin() - 1));
  };
  if (!open_.empty() && (blocks_.empty() || time >= open_.front().time)) return sealed_ + in(open_);
  const auto after =
      std::ranges::upper_bound(blocks_, time, {}, [](const Stored& b) { return b.head.first; });
  const Stored& block = after == blocks_.begin() ? *after : *std::prev(after);
  return block.begin + in(decoded(block));
}

const RecordedSearch* TickLog::searched(double time) const {
  const auto after = std::ranges::upper_bound(searches_, time, {}, &RecordedSearch::time);
  return after == searches_.begin() ? nullptr : &*std::prev(after);
}

std::vector<BlockBytes> TickLog::all() const {
  std::vector<BlockBytes> bytes;
  std::vector<RecordedSearch> kept(searches_.begin(), searches_.end());
  kept.resize(kept.size() - open_searches_.size());  // those are written with their ticks
  if (!kept.empty()) bytes.emplace_back([kept] { return search_block(kept); });
  for (const Stored& block : blocks_) bytes.push_back(block.bytes);
  return bytes;
}

}  // namespace sonde
