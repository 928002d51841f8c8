// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QMap>
#include <QObject>
#include <QStringList>
#include <QTimer>

namespace sonde::ui {

/// Reports files that others change. It waits until a file is no longer being written, and follows
/// a file that is replaced by another of its name.
class FileWatch : public QObject {
  Q_OBJECT
 public:
  FileWatch();

  /// Watches these files from now on, starting from their present state.
  void watch(const QStringList& files);

  /// Whether a watched file has changed, and that has not been reported yet.
  bool has_untold(const QString& file) const;

 signals:
  void changed(const QString& file);
  void vanished(const QString& file);  ///< once, until it is there again

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
  QMap<QString, Stamp> known_;   ///< the last reported state
  QMap<QString, Stamp> newest_;  ///< the state at the last look
};

}  // namespace sonde::ui
