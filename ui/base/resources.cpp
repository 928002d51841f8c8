// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/resources.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace sonde::ui {

QString resource(const QString& name) {
  const QDir folder(QCoreApplication::applicationDirPath() + "/../share/sonde");
  return QFileInfo(folder, name).canonicalFilePath();
}

namespace {

std::filesystem::path devices_in(QStandardPaths::StandardLocation location) {
  const QString folder = QStandardPaths::writableLocation(location);
  return std::filesystem::path(folder.toStdString()) / "sonde" / "devices";
}

}  // namespace

std::vector<std::filesystem::path> device_profile_folders() {
  return {devices_in(QStandardPaths::GenericDataLocation),
          resource(QStringLiteral("devices")).toStdString()};
}

std::filesystem::path device_settings_folder() {
  return devices_in(QStandardPaths::GenericConfigLocation);
}

}  // namespace sonde::ui
