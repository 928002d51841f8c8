// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QMap>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <functional>

namespace sonde::ui {

/// Hears of files that others change. A file that is being written is left until it rests; one that
/// is replaced by another of its name is followed.
class FileWatch : public QObject {
 public:
  FileWatch();

  /// From now on these, as they are now.
  void watch(const QStringList& files);

  std::function<void(const QString& file)> changed;
  std::function<void(const QString& file)> vanished;  ///< once, until it is there again

 private:
  struct Stamp {
    bool exists = false;
    qint64 size = 0;
    QDateTime time;
    bool operator==(const Stamp&) const = default;
  };
  static Stamp stamp_of(const QString& file);
  void look();

  QFileSystemWatcher watcher_;
  QTimer timer_;
  QMap<QString, Stamp> known_;   ///< as it was told last
  QMap<QString, Stamp> newest_;  ///< as it was at the last look
};

}  // namespace sonde::ui
