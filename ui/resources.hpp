// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace sonde::ui {

/// A file or folder of the program's resources: beside the installed program
/// (../share/sonde), else in the source tree. Empty where there is none.
QString resource(const QString& name);

}  // namespace sonde::ui
