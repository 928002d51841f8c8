// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>

namespace sonde::ui {

/// What is made of a name later must not depend on the folder that the program is in then.
inline std::filesystem::path absolute_path(const QString& file) {
  return std::filesystem::absolute(file.toStdString());
}

}  // namespace sonde::ui
