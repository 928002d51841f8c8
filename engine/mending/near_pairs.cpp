// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/near_pairs.hpp"

#include <algorithm>
#include <numeric>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"

namespace sonde {
namespace {

using Box = Eigen::AlignedBox3d;

class NearPairs {
 public:
  using Use = std::function<void(std::uint32_t, std::uint32_t)>;

  NearPairs(const std::vector<Box>& boxes, std::size_t most, const Use& use)
      : boxes_(boxes), most_(most), use_(use), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(boxes.size() / 2 + 1);
  }

  bool run(const Progress& progress) {
    report(progress, 0);
    if (boxes_.empty()) return true;
    build(0, order_.size());
    report(progress, 0.5);
    compare_all(progress);
    return compared_ <= most_;
  }

 private:
  static constexpr std::size_t leaf = 4;
  /// Some of the order, as two halves: the first follows in the list, unless it is a leaf.
  struct Node {
    Box box;
    std::size_t from, to, second = 0;
    bool is_leaf() const { return second == 0; }
  };
  struct Pair {
    std::size_t a, b;
  };

  std::size_t build(std::size_t from, std::size_t to) {
    const std::size_t own = nodes_.size();
    nodes_.push_back({{}, from, to});
    Box box, middles;
    for (std::size_t k = from; k < to; ++k) {
      box.extend(boxes_[order_[k]]);
      middles.extend(boxes_[order_[k]].center());
    }
    nodes_[own].box = box;
    if (to - from <= leaf) return own;
    Eigen::Index axis = 0;
    middles.sizes().maxCoeff(&axis);
    const std::size_t half = from + (to - from) / 2;
    const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    ordering::nth_element(at(from), at(half), at(to), [&](std::uint32_t i, std::uint32_t j) {
      const double a = boxes_[i].min()[axis] + boxes_[i].max()[axis],
                   b = boxes_[j].min()[axis] + boxes_[j].max()[axis];
      return a != b ? a < b : i < j;
    });
    build(from, half);
    const std::size_t second = build(half, to);
    nodes_[own].second = second;
    return own;
  }

  /// Two nodes of which some boxes may meet, or one and itself.
  void compare_all(const Progress& progress) {
    std::vector<Pair> left{{0, 0}};
    for (std::size_t n = 0; !left.empty() && compared_ <= most_; ++n) {
      if (n % 65536 == 0) report(progress, 0.75);
      const auto [a, b] = left.back();
      left.pop_back();
      const Node &x = nodes_[a], &y = nodes_[b];
      if (a != b && !x.box.intersects(y.box)) continue;
      if (x.is_leaf() && y.is_leaf()) {
        compare(x, y, a == b);
      } else if (a == b) {
        left.insert(left.end(), {{a + 1, x.second}, {x.second, x.second}, {a + 1, a + 1}});
      } else if (y.is_leaf() || (!x.is_leaf() && x.to - x.from >= y.to - y.from)) {
        left.insert(left.end(), {{a + 1, b}, {x.second, b}});
      } else {
        left.insert(left.end(), {{a, b + 1}, {a, y.second}});
      }
    }
  }

  void compare(const Node& x, const Node& y, bool same) {
    for (std::size_t k = x.from; k < x.to; ++k)
      for (std::size_t l = same ? k + 1 : y.from; l < y.to; ++l) {
        ++compared_;
        const std::uint32_t i = order_[k], j = order_[l];
        if (boxes_[i].intersects(boxes_[j])) use_(std::min(i, j), std::max(i, j));
      }
  }

  const std::vector<Box>& boxes_;
  std::size_t most_, compared_ = 0;
  const Use& use_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace

bool each_near_pair(const std::vector<Eigen::AlignedBox3d>& boxes, std::size_t most,
                    const std::function<void(std::uint32_t, std::uint32_t)>& use,
                    const Progress& progress) {
  return NearPairs(boxes, most, use).run(progress);
}

}  // namespace sonde
