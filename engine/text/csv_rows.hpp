// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

namespace sonde {

/// Calls `take` with the numbers of each line below the header, which must name exactly these
/// columns. Throws InputError with file, line and reason: a file that is longer than `most_bytes`
/// or unreadable, a wrong header, a wrong column count, a field that is not a finite number, a
/// blank line between rows, or the reason of a std::invalid_argument thrown by `take`.
void read_csv_rows(const std::filesystem::path& file, std::span<const std::string_view> columns,
                   std::size_t most_bytes,
                   const std::function<void(std::span<const double>)>& take);

/// The same with a header that may name either of two lists of columns. Returns whether it was
/// `second`.
bool read_csv_rows(const std::filesystem::path& file, std::span<const std::string_view> first,
                   std::span<const std::string_view> second, std::size_t most_bytes,
                   const std::function<void(std::span<const double>)>& take);

/// For `take`: throws std::invalid_argument if a time is not later than the previous one.
void expect_later(double t, double before);

}  // namespace sonde
