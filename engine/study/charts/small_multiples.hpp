// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sonde {

/// A quantity that each cell draws in its own strip.
struct CellQuantity {
  std::string label;  ///< with the unit: "force, N"
};

/// One cell: a line for each quantity, over the same x.
struct ChartTableCell {
  std::vector<double> x;
  std::vector<std::vector<double>> y;  ///< by quantity; values that are not finite are left out
  std::string note;                    ///< a short text under the lines
  bool bad = false;                    ///< the note is a warning
};

/// Small charts in rows and columns, so that their shapes can be compared at a glance: a strip for
/// each quantity, with the same axes in all cells.
struct SmallMultiples {
  std::string title, x_label;
  std::vector<CellQuantity> quantities = {};
  std::vector<std::string> columns = {}, rows = {};  ///< their names
  std::vector<ChartTableCell> cells = {};            ///< row by row
};

/// The picture as an SVG file, the same bytes for the same charts. Throws std::invalid_argument
/// unless there is a cell for each row and column, with a line for each quantity.
std::string to_svg(const SmallMultiples& table);

}  // namespace sonde
