// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recent_files.hpp"

#include <QFileInfo>
#include <QSettings>

namespace sonde::ui {
namespace {

constexpr int most = 10;
const QString key = QStringLiteral("recent");
const QChar separator('\n');  // in no name that anybody has given

QStringList entries() { return QSettings().value(key).toStringList(); }

}  // namespace

std::vector<QStringList> recent_files() {
  std::vector<QStringList> files;
  for (const QString& entry : entries()) files.push_back(entry.split(separator));
  return files;
}

void remember_recent(const QStringList& files) {
  QStringList whole;
  for (const QString& file : files) whole << QFileInfo(file).absoluteFilePath();
  QStringList all = entries();
  all.removeAll(whole.join(separator));
  all.prepend(whole.join(separator));
  QSettings().setValue(key, QStringList(all.mid(0, most)));
}

QString recent_name(const QStringList& files) {
  QStringList names;
  for (const QString& file : files) names << QFileInfo(file).fileName();
  return names.join(QStringLiteral(" and "));
}

}  // namespace sonde::ui
