// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sonde::app {

/// Joins the results of the shares of one query, files of CSV (results, or contacts) or JSON, into
/// what one run of all poses would have written: the rows in the order of their index, without the
/// column that names the share. Throws InputError, naming the file, where one is no such result,
/// is of another run, or is there twice, and where a share is missing.
std::string merge_results(const std::vector<std::string>& files);

}  // namespace sonde::app
