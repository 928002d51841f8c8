// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QProcess>
#include <functional>
#include <future>
#include <memory>

#include "ui/actions/export_control.hpp"
#include "ui/export/new_folder.hpp"

namespace sonde::ui {

/// A row of pictures, between which the window stays alive. For the sources of ExportControl.
struct ExportControl::Animation {
  struct Picture {
    Instant instant;
    double swing = 1;
  };
  Animation(const QString& name, const PictureWanted& what)
      : folder_name(name), folder(name.toStdString()), wanted(what) {}
  QString folder_name;
  NewFolder folder;
  PictureWanted wanted;
  int count = 0;
  std::function<Picture(int)> picture;
  QString film_name;
  double film_rate = 25;  ///< pictures a second
  int next = 0;
  QElapsedTimer since;
  std::unique_ptr<QProcess> film;
  std::future<void> writing;  ///< of the picture before the next
};

}  // namespace sonde::ui
