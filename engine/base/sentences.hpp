// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>

namespace sonde {

/// Sentences about one thing, immutable; copies share them. Not a std::vector, whose layout is
/// another in programs compiled with _GLIBCXX_DEBUG.
class Sentences {
 public:
  Sentences() = default;  ///< None.
  /// The sentences from `first` up to `last`.
  Sentences(const std::string* first, const std::string* last)
      : items_(new std::string[static_cast<std::size_t>(last - first)]),
        size_(static_cast<std::size_t>(last - first)) {
    std::copy(first, last, items_.get());
  }

  std::size_t size() const noexcept { return size_; }  ///< How many there are.
  bool empty() const noexcept { return size_ == 0; }   ///< Whether there are none.
  /// The first one.
  const std::string* begin() const noexcept { return items_.get(); }
  /// One past the last one.
  const std::string* end() const noexcept { return items_.get() + size_; }
  /// @pre i < size().
  const std::string& operator[](std::size_t i) const {
    return items_[static_cast<std::ptrdiff_t>(i)];
  }

 private:
  std::shared_ptr<std::string[]> items_;
  std::size_t size_ = 0;
};

}  // namespace sonde
