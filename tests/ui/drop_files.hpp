// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QStringList>
#include <QUrl>

namespace sonde::ui::test {

/// Drops files onto a widget, as a file manager does. Returns whether it would take them.
inline bool drop_files(QWidget& onto, const QStringList& files) {
  QMimeData data;
  QList<QUrl> urls;
  for (const QString& file : files)
    urls.push_back(file.contains("://") ? QUrl(file) : QUrl::fromLocalFile(file));
  data.setUrls(urls);
  QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&onto, &enter);
  QDropEvent drop({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&onto, &drop);
  return enter.isAccepted();
}

}  // namespace sonde::ui::test
