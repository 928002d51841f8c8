// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>
#include <exception>
#include <functional>
#include <optional>

#include "ui/actions/prompts.hpp"
#include "ui/base/job.hpp"
#include "ui/views/drawn_session.hpp"

namespace sonde::ui {

/// Opens scenes and pairs of meshes, in a worker. The present document stays until the new pair is
/// ready, and stays on bad input or when the user cancels.
class Opener : public QObject {
  Q_OBJECT
 public:
  Opener(QWidget& window, Prompts& prompts);

  /// Asks first where it names files outside of its folder (paths_to_ask_for).
  void open_scene(const QString& file);
  /// Without a unit, asks for it once both files are read.
  void open_meshes(const QString& probe, const QString& fixed, std::optional<double> unit);
  /// Reads a mesh to see that it can be; `done` is told where it can.
  void check_mesh(const QString& file, std::function<void()> done);
  /// Opens whatever `open` makes in the worker. `done` gets it; `given_up` reports that nothing was
  /// opened, also where something else is opened instead.
  void make(const QString& what, std::function<LoadedScene(const Progress&)> open,
            std::function<void(DrawnSession)> done, std::function<void()> given_up);
  /// The same, where `paths` finds the files that this file names and that are to be asked for
  /// (paths_to_ask_for). It runs first, in the worker too.
  void make_asking(const QString& what, const QString& file,
                   std::function<QStringList(const Progress&)> paths,
                   std::function<LoadedScene(const Progress&)> open,
                   std::function<void(DrawnSession)> done);
  /// Abandons the present work; its end is not reported.
  void abandon() { given_up_ = {}, job_.abandon(); }
  /// Whether something is being opened. In `given_up`: whether that is for something else.
  bool is_busy() const { return job_.running(); }
  /// Opens files that were dropped, or given on a command line: one scene, or the probe and the
  /// fixed body.
  void open_files(const QStringList& files, std::optional<double> unit);

 signals:
  void ready(DrawnSession& drawn);  ///< to be taken
  void say(const QString& what);    ///< in passing
  /// Nothing was opened. The reason (empty if the user cancelled) was already reported.
  void failed(const QString& reason);

 private:
  void begin(const QString& what, std::function<LoadedScene(const Progress&)> open);
  void ask_and_build(const std::shared_ptr<MeshPair>& pair, std::optional<double> unit);
  void give_up();
  void fail(const std::exception_ptr& error);
  void refuse(const QString& reason);

  Prompts& prompts_;
  Job job_;
  QString what_;                    ///< is going on
  std::function<void()> given_up_;  ///< of what is being opened
};

}  // namespace sonde::ui
