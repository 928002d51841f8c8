// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/split.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/ordering.hpp"
#include "engine/simd/vectors.hpp"

namespace sonde {
namespace {

constexpr int bins = 16;
constexpr std::size_t small_range = 512;

FloatX4 load(const float* p) { return FloatX4{p[0], p[1], p[2], 0}; }
FloatX4 smaller(FloatX4 a, FloatX4 b) { return a < b ? a : b; }
FloatX4 larger(FloatX4 a, FloatX4 b) { return a > b ? a : b; }

struct Box {
  static constexpr float big = std::numeric_limits<float>::max();
  FloatX4 low{big, big, big, 0};
  FloatX4 high{-big, -big, -big, 0};
  void add(const SplitItem& item) {
    low = smaller(low, load(item.low));
    high = larger(high, load(item.high));
  }
  void add(const Box& o) {
    low = smaller(low, o.low);
    high = larger(high, o.high);
  }
  void add(FloatX4 x) {
    low = smaller(low, x);
    high = larger(high, x);
  }
  bool empty() const { return low[0] > high[0]; }
  double half_area() const {
    if (empty()) return 0;
    const FloatX4 s = high - low;
    return static_cast<double>(s[0] * s[1] + s[1] * s[2] + s[2] * s[0]);
  }
};

/// Twice the centre of the item's box.
FloatX4 middle(const SplitItem& item) { return load(item.low) + load(item.high); }

float middle(const SplitItem& item, int axis) { return item.low[axis] + item.high[axis]; }

Box middles_of(std::span<const SplitItem> items) {
  Box box;
  for (const SplitItem& item : items) box.add(middle(item));
  return box;
}

struct Cut {
  double cost = std::numeric_limits<double>::infinity();
  int axis = 0;
  int bin = 0;            ///< the last bin of the left side
  std::size_t count = 0;  ///< number of items of the left side
};

/// Maps box centres to bins along the three axes.
struct Bins {
  FloatX4 low, per_length;
  explicit Bins(const Box& middles) : low(middles.low), per_length{} {
    for (int axis = 0; axis < 3; ++axis) {
      const float length = middles.high[axis] - middles.low[axis];
      per_length[axis] = length > 0 ? bins / length : 0;
      if (!std::isfinite(per_length[axis])) per_length[axis] = 0;
    }
  }
  int operator()(float x, int axis) const {
    return std::clamp(static_cast<int>((x - low[axis]) * per_length[axis]), 0, bins - 1);
  }
};

struct Bin {
  Box box;
  std::size_t count = 0;
};

void try_axis(const Bin* bin, int axis, Cut& best) {
  double right_cost[bins];
  Bin side;
  for (int b = bins - 1; b > 0; --b) {
    side.box.add(bin[b].box);
    side.count += bin[b].count;
    right_cost[b] = side.box.half_area() * static_cast<double>(side.count);
  }
  const std::size_t all = side.count + bin[0].count;
  side = Bin();
  for (int b = 0; b + 1 < bins; ++b) {
    side.box.add(bin[b].box);
    side.count += bin[b].count;
    if (side.count == 0 || side.count == all) continue;
    const double cost = side.box.half_area() * static_cast<double>(side.count) + right_cost[b + 1];
    if (cost < best.cost) best = {cost, axis, b, side.count};
  }
}

Cut cheapest_cut(std::span<const SplitItem> items, const Bins& bin_of) {
  Bin bin[3][bins];
  for (const SplitItem& item : items) {
    const FloatX4 x = middle(item);
    for (int axis = 0; axis < 3; ++axis) {
      Bin& b = bin[axis][bin_of(x[axis], axis)];
      b.box.add(item);
      ++b.count;
    }
  }
  Cut best;
  for (int axis = 0; axis < 3; ++axis)
    if (bin_of.per_length[axis] > 0) try_axis(bin[axis], axis, best);
  return best;
}

/// Moves the first `count` items along an axis to the left; the triangle's number breaks ties.
std::size_t cut_at(std::span<SplitItem> items, int axis, std::size_t count) {
  ordering::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(count),
                        items.end(), [axis](const SplitItem& a, const SplitItem& b) {
                          const float x = middle(a, axis), y = middle(b, axis);
                          return x != y ? x < y : a.triangle < b.triangle;
                        });
  return count;
}

/// The multiple of `whole` nearest to `count` that leaves neither side empty.
std::size_t to_whole(std::size_t count, std::size_t all, std::size_t whole) {
  const std::size_t near = (count + whole / 2) / whole * whole;
  return std::clamp(near, whole, (all - 1) / whole * whole);
}

int longest(const Box& box) {
  const FloatX4 s = box.high - box.low;
  if (s[0] >= s[1] && s[0] >= s[2]) return 0;
  return s[1] >= s[2] ? 1 : 2;
}

}  // namespace

std::pair<Eigen::Vector3f, Eigen::Vector3f> bounds(std::span<const SplitItem> items) {
  Box box;
  for (const SplitItem& item : items) box.add(item);
  return {{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}};
}

double half_area(std::span<const SplitItem> items) {
  Box box;
  for (const SplitItem& item : items) box.add(item);
  return box.half_area();
}

std::size_t split(std::span<SplitItem> items, SplitBy by, std::size_t whole) {
  const Box middles = middles_of(items);
  const bool small = items.size() <= small_range && items.size() > whole;
  if (by == SplitBy::cost) {
    const Bins bin_of(middles);
    const Cut cut = cheapest_cut(items, bin_of);
    if (cut.cost > 0 && cut.cost < std::numeric_limits<double>::infinity()) {
      if (small) return cut_at(items, cut.axis, to_whole(cut.count, items.size(), whole));
      const auto right =
          ordering::partition(items.begin(), items.end(), [&](const SplitItem& item) {
            return bin_of(middle(item, cut.axis), cut.axis) <= cut.bin;
          });
      return static_cast<std::size_t>(right - items.begin());
    }
  }
  const std::size_t half = items.size() / 2;
  return cut_at(items, longest(middles), small ? to_whole(half, items.size(), whole) : half);
}

}  // namespace sonde
