// SPDX-License-Identifier: GPL-3.0-or-later
// Sorting and selection that leave equal elements in the same places with every standard library.
// The standard's own algorithms leave their order open, and the order of evaluation affects the
// last bits of an answer. The steps are those of GCC's library (Musser's introsort and introselect,
// and binary heaps), so there the results equal those of std::sort and the others. The engine uses
// no others of these except std::stable_sort (packaging/check-style refuses them).
#pragma once

#include <bit>
#include <cstddef>
#include <functional>
#include <iterator>
#include <ranges>
#include <utility>
#include <vector>

namespace sonde::ordering {

namespace steps {

/// Shorter ranges are sorted by insertion only.
inline constexpr std::ptrdiff_t few = 16;

template <std::random_access_iterator It, class T, class Less>
void sift_up(It first, std::ptrdiff_t at, std::ptrdiff_t top, T value, Less less) {
  while (at > top && less(first[(at - 1) / 2], value)) {
    first[at] = std::move(first[(at - 1) / 2]);
    at = (at - 1) / 2;
  }
  first[at] = std::move(value);
}

template <std::random_access_iterator It, class T, class Less>
void sift_down(It first, std::ptrdiff_t at, std::ptrdiff_t size, T value, Less less) {
  const std::ptrdiff_t top = at;
  std::ptrdiff_t child = 2 * at + 2;
  for (; child < size; child = 2 * at + 2) {
    if (less(first[child], first[child - 1])) --child;
    first[at] = std::move(first[child]);
    at = child;
  }
  if (child == size) {
    first[at] = std::move(first[child - 1]);
    at = child - 1;
  }
  sift_up(first, at, top, std::move(value), less);
}

/// Moves the largest to `to`, whose element is inserted into the heap.
template <std::random_access_iterator It, class Less>
void exchange_largest(It first, It last, It to, Less less) {
  auto value = std::move(*to);
  *to = std::move(*first);
  sift_down(first, 0, last - first, std::move(value), less);
}

template <std::random_access_iterator It, class Less>
void insertion_sort(It first, It last, Less less) {
  if (first == last) return;
  for (It next = first + 1; next != last; ++next) {
    auto value = std::move(*next);
    It at = next;
    for (; at != first && less(value, *(at - 1)); --at) *at = std::move(*(at - 1));
    *at = std::move(value);
  }
}

/// Moves the median of three to the front; returns where the elements not less than it begin.
template <std::random_access_iterator It, class Less>
It cut(It first, It last, Less less) {
  const It a = first + 1, b = first + (last - first) / 2, c = last - 1;
  It median = a;
  if (less(*a, *b))
    median = less(*b, *c) ? b : less(*a, *c) ? c : a;
  else
    median = less(*a, *c) ? a : less(*b, *c) ? c : b;
  std::iter_swap(first, median);
  It low = first + 1, high = last;
  for (;; ++low) {
    while (less(*low, *first)) ++low;
    do {
      --high;
    } while (less(*first, *high));
    if (!(low < high)) return low;
    std::iter_swap(low, high);
  }
}

inline int most_cuts(std::ptrdiff_t size) {
  return 2 * (static_cast<int>(std::bit_width(static_cast<std::size_t>(size))) - 1);
}

}  // namespace steps

template <std::random_access_iterator It, class Less>
void push_heap(It first, It last, Less less) {
  auto value = std::move(*(last - 1));
  steps::sift_up(first, last - first - 1, 0, std::move(value), less);
}

template <std::random_access_iterator It, class Less>
void pop_heap(It first, It last, Less less) {
  if (last - first > 1) steps::exchange_largest(first, last - 1, last - 1, less);
}

namespace steps {

/// Moves the least elements to the front, as a heap.
template <std::random_access_iterator It, class Less>
void gather_least(It first, It middle, It last, Less less) {
  const std::ptrdiff_t size = middle - first;
  for (std::ptrdiff_t parent = (size - 2) / 2; size > 1 && parent >= 0; --parent) {
    auto value = std::move(first[parent]);
    sift_down(first, parent, size, std::move(value), less);
  }
  for (It next = middle; next < last; ++next)
    if (less(*next, *first)) exchange_largest(first, middle, next, less);
}

}  // namespace steps

/// Moves the least elements to the front, in order.
template <std::random_access_iterator It, class Less>
void partial_sort(It first, It middle, It last, Less less) {
  if (first == middle) return;
  steps::gather_least(first, middle, last, less);
  for (; middle - first > 1; --middle) steps::exchange_largest(first, middle - 1, middle - 1, less);
}

namespace steps {

template <std::random_access_iterator It, class Less>
void sort_roughly(It first, It last, int cuts, Less less) {
  while (last - first > few) {
    if (cuts-- == 0) return partial_sort(first, last, last, less);
    const It middle = cut(first, last, less);
    sort_roughly(middle, last, cuts, less);
    last = middle;
  }
}

}  // namespace steps

template <std::random_access_iterator It, class Less = std::less<>>
void sort(It first, It last, Less less = {}) {
  if (first == last) return;
  steps::sort_roughly(first, last, steps::most_cuts(last - first), less);
  steps::insertion_sort(first, last, less);
}

/// Sorts by the projections of the elements.
template <std::ranges::random_access_range Range, class Less = std::less<>,
          class Projection = std::identity>
void sort(Range&& range, Less less = {}, Projection projection = {}) {
  sort(std::ranges::begin(range), std::ranges::end(range), [&](const auto& x, const auto& y) {
    return std::invoke(less, std::invoke(projection, x), std::invoke(projection, y));
  });
}

/// Puts the element at `nth` that sorting would put there; none before it is greater than any after
/// it.
template <std::random_access_iterator It, class Less = std::less<>>
void nth_element(It first, It nth, It last, Less less = {}) {
  if (first == last || nth == last) return;
  for (int cuts = steps::most_cuts(last - first); last - first > 3; --cuts) {
    if (cuts == 0) {
      steps::gather_least(first, nth + 1, last, less);
      return std::iter_swap(first, nth);
    }
    const It middle = steps::cut(first, last, less);
    (middle <= nth ? first : last) = middle;
  }
  steps::insertion_sort(first, last, less);
}

/// Moves the elements that fit to the front; returns where the others begin.
template <std::random_access_iterator It, class Fits>
It partition(It first, It last, Fits fits) {
  for (;; ++first) {
    while (first != last && fits(*first)) ++first;
    if (first == last) return first;
    do {
      if (--last == first) return first;
    } while (!fits(*last));
    std::iter_swap(first, last);
  }
}

/// A priority queue: the greatest element comes out first.
template <class T>
class Queue {
 public:
  bool empty() const { return all_.empty(); }
  std::size_t size() const { return all_.size(); }
  const T& top() const { return all_.front(); }
  void push(T x) {
    all_.push_back(std::move(x));
    push_heap(all_.begin(), all_.end(), std::less<>());
  }
  void pop() {
    pop_heap(all_.begin(), all_.end(), std::less<>());
    all_.pop_back();
  }

 private:
  std::vector<T> all_;
};

}  // namespace sonde::ordering
