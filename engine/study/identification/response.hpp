// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/pose.hpp"
#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

/// One sample of a handle's response to commands.
struct ResponseSample {
  double t = 0;    ///< s
  Wrench command;  ///< given at t: on the handle, in the device's base, about the handle's point
  Pose X_BH;       ///< measured at t: the handle in the device's base
};
using Response = std::vector<ResponseSample>;

/// The columns of a recorded response.
inline constexpr std::array<std::string_view, 14> response_columns{
    "t", "fx", "fy", "fz", "tx", "ty", "tz", "px", "py", "pz", "qw", "qx", "qy", "qz"};

/// Reads a CSV with these columns, t strictly increasing. Throws InputError with file, line and
/// reason, as read_trajectory does.
Response read_response(const std::filesystem::path& file);
/// The response as text; every number is read back to the bit.
std::string response_text(const Response& response);

}  // namespace sonde
