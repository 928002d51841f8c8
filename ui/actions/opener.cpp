// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/opener.hpp"

#include <vtkPolyData.h>

#include <QDir>
#include <QFileInfo>
#include <memory>
#include <stdexcept>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/mesh_io/read_mesh.hpp"
#include "engine/scene/write_scene.hpp"
#include "ui/actions/meshes_dialog.hpp"
#include "ui/base/absolute_path.hpp"
#include "ui/document/paths_asked_for.hpp"

namespace sonde::ui {
namespace {

/// What is open is written as text, for saving and recovery: a name that no text can hold is told
/// of here, before anything is on show.
LoadedScene nameable(LoadedScene opened) {
  try {
    scene_text(opened.scene, "/");
  } catch (const std::invalid_argument& bad) {
    throw InputError::in(opened.scene.probe.mesh.string(), bad.what());
  } catch (const std::exception&) {
    throw InputError::in(opened.scene.probe.mesh.string(), "its path is not UTF-8");
  }
  return opened;
}

bool is_mesh(const QString& file) {
  const QString patterns = mesh_filter().section(QLatin1Char('('), 1).chopped(1);
  return QDir::match(patterns.split(QLatin1Char(' ')), QFileInfo(file).fileName());
}

}  // namespace

Opener::Opener(QWidget& window, Prompts& prompts) : prompts_(prompts), job_(&window) {}

void Opener::open_scene(const QString& file) {
  if (is_mesh(file))
    return refuse(QStringLiteral("%1 is a mesh, not a scene. Open two meshes (Ctrl+M): the probe "
                                 "first, then the fixed body.")
                      .arg(QDir::toNativeSeparators(file)));
  const auto scene = absolute_path(file);
  make_asking(
      QStringLiteral("Opening %1").arg(QFileInfo(file).fileName()), file,
      [scene](const Progress&) { return paths_to_ask_for(scene); },
      [scene](const Progress& progress) { return ui::open_scene(scene, progress); },
      [this](DrawnSession drawn) { emit ready(drawn); });
}

void Opener::open_meshes(const QString& probe, const QString& fixed, std::optional<double> unit) {
  give_up();
  what_ = QStringLiteral("Reading %1 and %2")
              .arg(QFileInfo(probe).fileName(), QFileInfo(fixed).fileName());
  const auto pair = std::make_shared<MeshPair>();
  job_.start(
      what_,
      [pair, a = absolute_path(probe), b = absolute_path(fixed)](const Progress& progress) {
        *pair = read_pair(a, b, progress);
      },
      [this, pair, unit](std::exception_ptr error) {
        if (error)
          fail(error);
        else
          ask_and_build(pair, unit);
      });
}

void Opener::check_mesh(const QString& file, std::function<void()> done) {
  give_up();
  what_ = QStringLiteral("Reading %1").arg(QFileInfo(file).fileName());
  job_.start(
      what_,
      [mesh = absolute_path(file)](const Progress& progress) { read_mesh(mesh, 1, progress); },
      [this, done = std::move(done)](const std::exception_ptr& error) {
        if (error)
          fail(error);
        else
          done();
      });
}

void Opener::open_files(const QStringList& files, std::optional<double> unit) {
  if (files.size() == 1 && files[0].endsWith(QStringLiteral(".json"), Qt::CaseInsensitive))
    open_scene(files[0]);
  else if (files.size() == 2)
    open_meshes(files[0], files[1], unit);
  else
    refuse(
        QStringLiteral("Open one scene (NAME.sonde.json), or two meshes: the probe first, then "
                       "the fixed body."));
}

void Opener::ask_and_build(const std::shared_ptr<MeshPair>& pair, std::optional<double> unit) {
  const std::optional<PairSetup> setup =
      unit ? same_unit(*pair, *unit) : prompts_.ask_bodies(*pair, guess_setup(*pair));
  if (!setup) return fail(std::make_exception_ptr(Cancelled()));
  begin(QStringLiteral("Building both bodies"), [pair, said = *setup](const Progress& progress) {
    return build_pair(std::move(*pair), said, progress);
  });
}

void Opener::begin(const QString& what, std::function<LoadedScene(const Progress&)> open) {
  make(what, std::move(open), [this](DrawnSession drawn) { emit ready(drawn); }, {});
}

void Opener::make(const QString& what, std::function<LoadedScene(const Progress&)> open,
                  std::function<void(DrawnSession)> done, std::function<void()> given_up) {
  give_up();
  given_up_ = std::move(given_up);
  what_ = what;
  const auto drawn = std::make_shared<DrawnSession>();
  job_.start(
      what,
      [drawn, open = std::move(open)](const Progress& progress) {
        *drawn = draw_session(nameable(open(progress)));
      },
      [this, drawn, done = std::move(done)](const std::exception_ptr& error) {
        if (error) {
          give_up();
          return fail(error);
        }
        given_up_ = {};
        done(std::move(*drawn));
      });
}

void Opener::make_asking(const QString& what, const QString& file,
                         std::function<QStringList(const Progress&)> paths,
                         std::function<LoadedScene(const Progress&)> open,
                         std::function<void(DrawnSession)> done) {
  give_up();
  what_ = what;
  const auto found = std::make_shared<QStringList>();
  job_.start(
      what,
      [found, paths = std::move(paths)](const Progress& progress) { *found = paths(progress); },
      [this, found, what, file, open = std::move(open),
       done = std::move(done)](const std::exception_ptr& error) {
        if (error) return fail(error);
        const Consent consent = found->isEmpty()
                                    ? Consent::once
                                    : prompts_.ask_paths(QFileInfo(file).fileName(), *found);
        if (consent == Consent::refused) return fail(std::make_exception_ptr(Cancelled()));
        if (consent == Consent::kept) agree_to_paths(absolute_path(file), *found);
        make(what, open, done, {});
      });
}

void Opener::give_up() {
  if (job_.running())
    emit say(QStringLiteral("%1: given up, for what is opened instead").arg(what_));
  if (const auto given_up = std::exchange(given_up_, {})) given_up();
}

void Opener::fail(const std::exception_ptr& error) { refuse(reason_of(error)); }

void Opener::refuse(const QString& reason) {
  if (!reason.isEmpty() && prompts_.report_error) prompts_.report_error(reason);
  emit failed(reason);
}

}  // namespace sonde::ui
