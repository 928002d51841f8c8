// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>

namespace sonde::ui {

inline std::filesystem::path absolute_path(const QString& file) {
  return std::filesystem::absolute(file.toStdString());
}

}  // namespace sonde::ui
