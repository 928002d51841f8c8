// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/file_watch.hpp"

#include <QFileInfo>

namespace sonde::ui {
namespace {

constexpr int rest_ms = 300;  // for so long a file must not change before it is read

}  // namespace

FileWatch::FileWatch() {
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, [this] { timer_.start(rest_ms); });
  connect(&timer_, &QTimer::timeout, this, &FileWatch::look);
}

void FileWatch::watch(const QStringList& files) {
  timer_.stop();
  if (!watcher_.files().isEmpty()) watcher_.removePaths(watcher_.files());
  known_.clear();
  for (const QString& file : files) {
    known_[file] = stamp_of(file);
    watcher_.addPath(file);
  }
  newest_ = known_;
}

FileWatch::Stamp FileWatch::stamp_of(const QString& file) {
  const QFileInfo info(file);
  if (!info.exists()) return {};
  return {true, info.size(), info.lastModified()};
}

bool FileWatch::has_untold(const QString& file) const {
  const Stamp now = stamp_of(file);
  return now.exists && known_.contains(file) && !(now == known_[file]);
}

/// Again and again until all that changed has come to rest. What is gone may come back: it is
/// looked for as long as it is missing.
void FileWatch::look() {
  bool rests = true;
  QStringList told;
  for (auto it = known_.begin(); it != known_.end(); ++it) {
    const Stamp now = stamp_of(it.key());
    const bool moving = !(now == newest_[it.key()]);
    newest_[it.key()] = now;
    // The watch of a file ends with the file, also where another takes its name.
    if (now.exists && !watcher_.files().contains(it.key())) watcher_.addPath(it.key());
    rests = rests && !moving && now.exists;
    if (moving || now == it.value()) continue;
    it.value() = now;
    told << it.key();
  }
  if (rests) timer_.stop();
  for (const QString& file : told) {
    if (known_.value(file).exists)
      emit changed(file);
    else
      emit vanished(file);
    if (!known_.contains(file)) return;  // by now others are watched
  }
}

}  // namespace sonde::ui
