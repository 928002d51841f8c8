// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/settings/device_profile.hpp"

namespace sonde::ui {

struct SourceReport;

/// What a simulated device of this profile bears, and which of its figures are assumed.
QString words_of(const DeviceProfile& profile);
/// What a connected device tells of itself, what is wrong with it, and by which profile it is
/// judged which gains wait in a contact. A line each.
QString words_of(const SourceReport& report);

}  // namespace sonde::ui
