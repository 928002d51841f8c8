// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "ui/actions/export_dialog.hpp"
#include "ui/base/job.hpp"
#include "ui/document/instant.hpp"
#include "ui/export/vtk_scene.hpp"

namespace sonde::ui {

struct DrawnSession;
class HistoryControl;
class ProgressDialog;
struct Prompts;

/// Writes what the window shows to files for other programs: pictures, tables, ParaView's, glTF.
/// Each appears whole or not at all.
class ExportControl : public QObject {
  Q_OBJECT
 public:
  /// `shown`: what the window shows, none before the first; the history has what the timeline leads
  /// over. Both outlive this.
  ExportControl(Viewport& viewport, const std::optional<Instant>& shown, HistoryControl& history,
                const Prompts& prompts, QWidget& window);
  ~ExportControl() override;

  void attach(const DrawnSession* drawn);

  // Ask, then write; nothing where nothing is open.
  void export_picture();
  void export_tables();
  void export_vtk(bool series);
  void export_gltf();
  void export_animation();
  // Of the ticks that the timeline leads over (export_recording.cpp).
  void export_recording_pictures();
  void export_recording_tables();
  void export_recording_vtk();
  bool busy() const { return job_.running() || animation_ != nullptr; }

  // What is asked; tests answer themselves. An empty name: do nothing.
  std::function<std::optional<PictureWanted>(ExportDialog::Of)> ask_picture;
  std::function<QString(const QString& title, const QString& name, const QString& filter)> ask_file;

 signals:
  void say(const QString& what);
  void failed(const QString& reason);

 private:
  struct Animation;
  bool may_begin();
  bool may_write_contacts(const QString& file) const;
  void write(const QString& file, const std::function<void()>& write);
  void ended(const QString& file, const std::exception_ptr& error);
  void animate(std::unique_ptr<Animation> animation);
  void draw_next();
  void make_film();
  void finish(const QString& reason);
  Surfaces surfaces() const;

  Viewport& viewport_;
  const std::optional<Instant>& shown_;
  HistoryControl& history_;
  const Prompts& prompts_;
  Job job_;
  const DrawnSession* drawn_ = nullptr;
  QTimer timer_;
  std::unique_ptr<Animation> animation_;
  ProgressDialog* progress_ = nullptr;  ///< of the animation
};

}  // namespace sonde::ui
