// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

namespace sonde {

/// Calls `take` with the numbers of each line below the header, which must name just these columns.
/// Throws InputError with file, line and reason: a file that is longer than `most_bytes` or cannot
/// be read, a wrong header, a wrong column count, a field that is no number or not finite, a blank
/// line between rows, and where `take` throws std::invalid_argument, its reason.
void read_csv_rows(const std::filesystem::path& file, std::span<const std::string_view> columns,
                   std::size_t most_bytes,
                   const std::function<void(std::span<const double>)>& take);

/// The same where the header may name either of two lists of columns. Returns which it was.
bool read_csv_rows(const std::filesystem::path& file, std::span<const std::string_view> first,
                   std::span<const std::string_view> second, std::size_t most_bytes,
                   const std::function<void(std::span<const double>)>& take);

/// For `take`: throws std::invalid_argument where a time does not come after the one before.
void expect_later(double t, double before);

}  // namespace sonde
