// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sonde {

/// A word for a CSV file: in quotes where it holds a comma, a quote or the end of a line.
std::string csv_word(const std::string& word);

}  // namespace sonde
