// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/resources.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace sonde::ui {

QString resource(const QString& name) {
  const QString installed = QCoreApplication::applicationDirPath() + "/../share/sonde";
  for (const QString& folder : {installed, QStringLiteral(SONDE_SOURCE_RESOURCES)}) {
    const QFileInfo file(QDir(folder), name);
    if (file.exists()) return file.canonicalFilePath();
  }
  return {};
}

}  // namespace sonde::ui
