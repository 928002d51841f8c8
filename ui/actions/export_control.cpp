// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/export_control.hpp"

#include <vtkPolyData.h>

#include <QDir>
#include <QFileDialog>
#include <QProcess>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include "engine/base/error.hpp"
#include "ui/actions/animation.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/actions/meshes_dialog.hpp"
#include "ui/actions/prompts.hpp"
#include "ui/base/progress_dialog.hpp"
#include "ui/export/image_file.hpp"
#include "ui/export/tables.hpp"
#include "ui/views/drawn_session.hpp"
#include "ui/views/surface.hpp"

namespace sonde::ui {
namespace {

constexpr int patient_pictures = 5;  // before a dialog appears
constexpr int steps_of_series = 25;  // frames a second of the separation's one second

std::filesystem::path path_of(const QString& file) { return file.toStdString(); }

}  // namespace

ExportControl::ExportControl(Viewport& viewport, const std::optional<Instant>& shown,
                             HistoryControl& history, const Prompts& prompts, QWidget& window)
    : QObject(&window),
      viewport_(viewport),
      shown_(shown),
      history_(history),
      prompts_(prompts),
      job_(&window) {
  QWidget* parent = &window;
  ask_picture = [parent, this](ExportDialog::Of of) -> std::optional<PictureWanted> {
    Span all;
    if (const auto kept = history_.ticks_on_show()) all = {kept->first, kept->last};
    ExportDialog dialog(of, viewport_.size(), all, parent);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return dialog.wanted();
  };
  ask_file = [parent](const QString& title, const QString& name, const QString& filter) {
    QString file =
        QFileDialog::getSaveFileName(parent, title, QDir(last_folder()).filePath(name), filter);
    if (!file.isEmpty()) remember_folder_of(file);
    return file;
  };
  connect(&timer_, &QTimer::timeout, this, &ExportControl::draw_next);
}

ExportControl::~ExportControl() = default;

void ExportControl::attach(const DrawnSession* drawn) {
  if (animation_) finish(QStringLiteral("another document was opened meanwhile"));
  drawn_ = drawn;
}

/// For another thread.
Surfaces ExportControl::surfaces() const {
  return {shell_of(*drawn_->bodies.probe_surface), shell_of(*drawn_->bodies.fixed_surface),
          drawn_->session->probe().mass.com};
}

/// One at a time: a second one would abandon the first.
bool ExportControl::may_begin() {
  if (!drawn_ || !shown_) return false;
  if (!busy()) return true;
  emit failed(QStringLiteral("An export is going on: wait until it has ended, or cancel it."));
  return false;
}

/// Whoever chose the name of one table has not been asked about the other.
bool ExportControl::may_write_contacts(const QString& file) const {
  const std::filesystem::path contacts = contacts_file_of(path_of(file));
  std::error_code none;
  return !std::filesystem::exists(contacts, none) ||
         prompts_.ask_replace(QString::fromStdString(contacts.string()));
}

/// Does it, and says how it went.
void ExportControl::write(const QString& file, const std::function<void()>& write) {
  try {
    write();
    emit say(QStringLiteral("Saved %1").arg(file));
  } catch (const std::exception& bad) {
    emit failed(QString::fromUtf8(bad.what()));
  }
}

void ExportControl::ended(const QString& file, const std::exception_ptr& error) {
  const QString reason = error ? reason_of(error) : QString();
  if (!error) emit say(QStringLiteral("Saved %1").arg(file));
  if (!reason.isEmpty()) emit failed(reason);
}

void ExportControl::export_picture() {
  if (!may_begin()) return;
  const auto wanted = ask_picture(ExportDialog::Of::picture);
  if (!wanted) return;
  const QString file = ask_file(QStringLiteral("Export a picture"), QStringLiteral("sonde.png"),
                                QStringLiteral("Pictures (*.png)"));
  if (file.isEmpty() || !drawn_ || !shown_) return;
  job_.start(
      QStringLiteral("Exporting a picture"),
      [file, image = viewport_.picture(*shown_, wanted->options)](const Progress& progress) {
        write_image(path_of(file), image, progress);
      },
      [this, file](const std::exception_ptr& error) { ended(file, error); });
}

void ExportControl::export_tables() {
  if (!drawn_ || !shown_) return;
  const QString file = ask_file(QStringLiteral("Export numbers"), QStringLiteral("sonde.csv"),
                                QStringLiteral("Tables (*.csv)"));
  if (file.isEmpty() || !may_write_contacts(file) || !drawn_ || !shown_) return;
  const ExportedInstant shown = exported_instant_of(*shown_);
  write(file, [&] {
    write_tables(path_of(file), instants_csv({&shown, 1}), contacts_csv({&shown, 1}));
  });
}

void ExportControl::export_gltf() {
  if (!may_begin()) return;
  const QString file = ask_file(QStringLiteral("Export glTF"), QStringLiteral("sonde.gltf"),
                                QStringLiteral("glTF (*.gltf)"));
  if (file.isEmpty() || !drawn_ || !shown_) return;
  job_.start(
      QStringLiteral("Exporting glTF"),
      [file, what = surfaces(), shown = exported_instant_of(*shown_)](const Progress& progress) {
        write_gltf(path_of(file), what, shown, progress);
      },
      [this, file](const std::exception_ptr& error) { ended(file, error); });
}

void ExportControl::export_vtk(bool series) {
  if (!may_begin()) return;
  const QString folder =
      ask_file(series ? QStringLiteral("Export the separation for ParaView: a new folder")
                      : QStringLiteral("Export for ParaView: a new folder"),
               QStringLiteral("sonde-vtk"), QString());
  if (folder.isEmpty() || !drawn_ || !shown_) return;
  const Snapshot now = shown_->snapshot;
  std::vector<ExportedInstant> instants{exported_instant_of(*shown_)};
  if (series) instants = separation_in_steps(now, drawn_->session->probe().mass, steps_of_series);
  job_.start(
      QStringLiteral("Exporting for ParaView"),
      [folder, what = surfaces(), instants = std::move(instants)](const Progress& progress) {
        write_vtk(path_of(folder), what, instants, progress);
      },
      [this, folder](const std::exception_ptr& error) { ended(folder, error); });
}

void ExportControl::export_animation() {
  if (!may_begin()) return;
  const auto wanted = ask_picture(ExportDialog::Of::animation);
  if (!wanted) return;
  const QString folder = ask_file(QStringLiteral("Export the separation: a new folder of pictures"),
                                  QStringLiteral("sonde-separation"), QString());
  if (folder.isEmpty() || !drawn_ || !shown_) return;
  try {
    auto animation = std::make_unique<Animation>(folder, *wanted);
    animation->count = wanted->frames;
    animation->picture = [shown = shown_->snapshot, last = wanted->frames - 1](int i) {
      return Animation::Picture{{.snapshot = shown, .searched = {}, .live = false},
                                double(i) / std::max(last, 1)};
    };
    animation->film_name = QStringLiteral("separation.mp4");
    animate(std::move(animation));
  } catch (const InputError& bad) {
    emit failed(QString::fromUtf8(bad.what()));
  }
}

void ExportControl::animate(std::unique_ptr<Animation> animation) {
  animation_ = std::move(animation);
  progress_ = new ProgressDialog(QStringLiteral("Drawing %1 pictures").arg(animation_->count),
                                 static_cast<QWidget*>(parent()));
  connect(progress_, &QDialog::rejected, this, [this] {
    timer_.stop();
    animation_.reset();
    finish({});
  });
  animation_->since.start();
  timer_.start(1);  // ms
}

/// One a turn of the event loop, once the one before is written, by another thread: Esc and the
/// window work meanwhile.
void ExportControl::draw_next() {
  Animation& a = *animation_;
  try {
    if (a.writing.valid()) {
      if (a.writing.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
      a.writing.get();
    }
    if (a.next == a.count) {
      timer_.stop();
      return a.wanted.film ? make_film() : finish({});
    }
    const Animation::Picture picture = a.picture(a.next);
    PictureOptions options = a.wanted.options;
    options.swing = picture.swing;
    const QString name = QStringLiteral("frame_%1.png").arg(a.next, 4, 10, QLatin1Char('0'));
    a.writing = std::async(std::launch::async, write_image, a.folder.path() / name.toStdString(),
                           viewport_.picture(picture.instant, options), Progress());
  } catch (const std::exception& bad) {
    return finish(QString::fromUtf8(bad.what()));
  }
  ++a.next;
  if (a.next > patient_pictures && !progress_->isVisible()) progress_->show();
  progress_->show_progress(double(a.next) / a.count, 1e-3 * double(a.since.elapsed()));
}

void ExportControl::make_film() {
  animation_->film = std::make_unique<QProcess>();
  QProcess& film = *animation_->film;
  film.setWorkingDirectory(QString::fromStdString(animation_->folder.path().string()));
  const auto ended = [this, &film] {
    if (!animation_ || animation_->film.get() != &film) return;  // given up meanwhile
    if (film.error() == QProcess::FailedToStart)
      return finish(QStringLiteral("%1: %2").arg(film.program(), film.errorString()));
    if (film.exitStatus() == QProcess::NormalExit && film.exitCode() == 0) return finish({});
    const QByteArray said = film.readAllStandardError().trimmed();
    finish(QStringLiteral("ffmpeg: %1").arg(QString::fromUtf8(said.split('\n').last())));
  };
  connect(&film, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this, ended,
          Qt::QueuedConnection);
  connect(&film, &QProcess::errorOccurred, this, ended, Qt::QueuedConnection);
  // An even number of pixels each way: most players want no other.
  film.start(find_ffmpeg(),
             {QStringLiteral("-y"), QStringLiteral("-loglevel"), QStringLiteral("error"),
              QStringLiteral("-framerate"), QString::number(animation_->film_rate),
              QStringLiteral("-i"), QStringLiteral("frame_%04d.png"), QStringLiteral("-vf"),
              QStringLiteral("pad=ceil(iw/2)*2:ceil(ih/2)*2"), QStringLiteral("-pix_fmt"),
              QStringLiteral("yuv420p"), animation_->film_name});
}

void ExportControl::finish(const QString& reason) {
  timer_.stop();
  if (progress_) {
    progress_->disconnect(this);
    progress_->hide();
    progress_->deleteLater();
    progress_ = nullptr;
  }
  const std::unique_ptr<Animation> done = std::move(animation_);
  viewport_.invalidate();
  if (!done) return;  // given up: there is no folder
  if (!reason.isEmpty()) return emit failed(reason);
  write(done->folder_name, [&] { done->folder.commit(); });
}

}  // namespace sonde::ui
