// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/document_control.hpp"

#include <vtkPolyData.h>

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/base/error.hpp"
#include "ui/actions/meshes_dialog.hpp"
#include "ui/actions/opener.hpp"
#include "ui/document/paths_asked_for.hpp"
#include "ui/document/pose_text.hpp"
#include "ui/document/recent_files.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr int recovery_ms = 2000;

bool is_scene(const QString& file) {
  return file.endsWith(QStringLiteral(".json"), Qt::CaseInsensitive);
}

QString text_of(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

}  // namespace

DocumentControl::DocumentControl(Opener& opener, Prompts& prompts, const Viewport& view)
    : opener_(opener), prompts_(prompts), view_(view), recovery_(recovery_folder()) {
  connect(&document_, &Document::changed, this, &DocumentControl::apply);
  connect(&document_.stack(), &QUndoStack::indexChanged, this, [this](int index) {
    note_index(index);
    emit changed();
  });
  connect(&opener_, &Opener::failed, this, &DocumentControl::show_what_was_not);
  connect(&watch_, &FileWatch::changed, this, &DocumentControl::file_changed);
  connect(&watch_, &FileWatch::vanished, this, &DocumentControl::file_vanished);
  connect(&recovery_timer_, &QTimer::timeout, this, &DocumentControl::keep_for_recovery);
  recovery_timer_.start(recovery_ms);
}

void DocumentControl::file_vanished(const QString& file) {
  emit say(QStringLiteral("%1 is no longer on the disk. What is open stays.").arg(file));
}

void DocumentControl::open(const QStringList& files, std::optional<double> unit) {
  if (may_leave()) opener_.open_files(files, unit);
}

void DocumentControl::ask_scene() {
  const QString file = prompts_.ask_scene();
  if (file.isEmpty() || !may_leave()) return;
  remember_folder_of(file);
  opener_.open_scene(file);
}

bool DocumentControl::ask_meshes(const QString& first) {
  const auto files = prompts_.ask_meshes(first);
  if (!files || !may_leave()) return false;
  opener_.open_meshes(files->first, files->second, std::nullopt);
  return true;
}

bool DocumentControl::is_one_mesh(const QStringList& files) {
  return files.size() == 1 && !is_scene(files[0]);
}

void DocumentControl::drop(const QStringList& files) {
  const bool meshes = std::ranges::none_of(files, is_scene);
  if (document_.empty() || !meshes) return open(files, std::nullopt);
  const QString name = files.size() == 1 ? QFileInfo(files[0]).fileName()
                                         : QStringLiteral("%1 meshes").arg(files.size());
  const auto role = prompts_.ask_role(name, static_cast<int>(files.size()));
  if (!role) return;
  if (*role == Role::parts) return add_parts(files);
  if (*role == Role::pair) return open(files, std::nullopt);
  replace_body(*role, files[0]);
}

bool DocumentControl::may_leave() {
  if (!document_.modified()) return true;
  const Leaving answer =
      prompts_.ask_leaving(QString::fromStdString(document_.content().scene.name));
  return answer == Leaving::discard || (answer == Leaving::save && save());
}

void DocumentControl::start_anew() {
  if (!may_leave()) return;
  opener_.abandon();
  showing_ = reading_scene_ = false;
  watch_.watch({});
  recovery_.clear();
  kept_.clear();
  on_show_.reset();
  document_.close();
  emit emptied();
  emit changed();
}

bool DocumentControl::save() {
  if (document_.empty()) return false;
  return document_.file().empty() ? save_as() : write(document_.file());
}

bool DocumentControl::save_as() {
  if (document_.empty()) return false;
  QString name = QString::fromStdString(document_.content().scene.name);
  name.replace(' ', '-');
  const QDir folder = document_.file().empty() ? QDir(last_folder())
                                               : QFileInfo(text_of(document_.file())).absoluteDir();
  const QString file = prompts_.ask_save(folder.filePath(name + QStringLiteral(".sonde.json")));
  if (file.isEmpty()) return false;
  remember_folder_of(file);
  return write(file.toStdString());
}

bool DocumentControl::write(const std::filesystem::path& file) {
  const bool changed_meanwhile =
      watch_.has_untold(text_of(file)) || (reading_scene_ && file == document_.file());
  if (changed_meanwhile && !prompts_.ask_overwrite(text_of(file))) return false;
  watch_.watch({});  // what we write ourselves is no news
  bool written = false;
  try {
    document_.save(file);
    written = true;
    remember_recent({text_of(file)});
    agree_to_paths(file, paths_to_ask_for(file));  // the user's own
    emit say(QStringLiteral("Saved %1").arg(text_of(file)));
    recovery_.clear();
    kept_ = text_for_recovery();
  } catch (const std::exception& bad) {
    prompts_.report_error(QString::fromUtf8(bad.what()));
  }
  watch();
  emit changed();
  if (written) emit saved(document_.content().scene);
  return written;
}

QStringList DocumentControl::files() const {
  const Scene& scene = document_.content().scene;
  QStringList files;
  for (const SceneBody* whole : {&scene.probe, &scene.fixed})
    for (const SceneBody& body : meshes_of(*whole)) files.append(text_of(body.mesh));
  if (!scene.file.empty()) files.prepend(text_of(scene.file));
  files.removeDuplicates();
  return files;
}

void DocumentControl::watch() { watch_.watch(document_.empty() ? QStringList() : files()); }

void DocumentControl::opened(const Session& session) {
  const LoadedScene& opened = session.loaded();
  auto bodies = std::make_shared<const Bodies>(
      Bodies{opened.pair, opened.trajectory, opened.marks, opened.parts});
  on_show_ = bodies;
  document_.open({opened.scene, opened.here.value_or(opened.start), std::move(bodies)});
  // Only now: while the steps of the document before go, they count as others than those on show.
  index_on_show_ = 0;
  setup_failed_ = false;
  recovery_.clear();
  kept_ = document_.text() + pose_text(document_.content().here);
  showing_ = reading_scene_ = false;
  const Scene& scene = opened.scene;
  remember_recent(scene.file.empty()
                      ? QStringList{text_of(scene.probe.mesh), text_of(scene.fixed.mesh)}
                      : QStringList{text_of(scene.file)});
  watch();
  emit changed();
}

// ---- Files that others change

void DocumentControl::file_changed(const QString& file) {
  const bool is_scene = file == text_of(document_.file());
  if (!is_scene && reading_scene_) return;  // which reads its meshes as well
  if (is_scene && document_.modified() && !prompts_.ask_reload(file)) return;
  const QString what = QStringLiteral("Reading %1 again").arg(QFileInfo(file).fileName());
  const Scene scene = document_.content().scene;
  if (is_scene)
    reload(file, what, [path = scene.file](const Progress& p) {
      if (!paths_to_ask_for(path).isEmpty())
        throw InputError::in(
            path.string(),
            "it names other files outside of its folder now: open it again to be asked");
      return open_scene(path, p);
    });
  else
    reload(file, what, [scene](const Progress& p) { return open_scene(scene, p); });
  reading_scene_ = is_scene;
}

/// Nothing but what the file says changes: the probe and the eye stay where they are.
void DocumentControl::reload(const QString& file, const QString& what,
                             std::function<LoadedScene(const Progress&)> open) {
  const std::string saved = document_.saved_text();
  const bool was_modified = document_.modified();
  const std::string before = document_.text();
  opener_.make(
      what, [open = std::move(open)](const Progress& progress) { return open(progress); },
      [this, file, saved, before, was_modified](DrawnSession drawn) {
        reading_scene_ = false;
        // What was changed while it was read counts: once more, from there.
        if (document_.text() != before) return file_changed(file);
        const CameraPlace camera = view_.place();
        const Pose stays = here();
        emit show_wanted(drawn, false);
        emit look_wanted(camera);
        emit place_wanted(stays);
        document_.set_here(stays);
        // A mesh that was read again leaves the scene as it was, saved or not.
        if (was_modified && document_.text() == before) document_.set_saved_text(saved);
        kept_.clear();
        keep_for_recovery();
        emit say(QStringLiteral("Read again from the disk"));
        emit changed();
      },
      [this] { reading_scene_ = false; });
}

// ---- Recovery

std::string DocumentControl::text_for_recovery() const {
  return document_.text() + pose_text(here());
}

Recovered DocumentControl::for_recovery() const {
  const Content content = now();
  return {content.scene, document_.saved_text(), content.here, view_.place(),
          QDateTime::currentDateTime()};
}

void DocumentControl::keep_for_recovery() {
  if (document_.empty() || !session_) return;
  const std::string text = text_for_recovery();
  if (text != kept_ && recovery_.keep(for_recovery())) kept_ = text;
}

void DocumentControl::leave_to_recovery() {
  if (!document_.empty() && session_ && text_for_recovery() != kept_)
    recovery_.keep_now(for_recovery());
  recovery_.leave();
}

bool DocumentControl::offer_recovery() {
  for (const std::filesystem::path& file : recovery_.left_over()) try {
      const Recovered found = recovered_from(file);
      const QString name =
          QStringLiteral("%1 (%2)").arg(QString::fromStdString(found.scene.name),
                                        found.when.toString(QStringLiteral("yyyy-MM-dd hh:mm")));
      const Recovering answer = prompts_.ask_recover(name);
      if (answer == Recovering::later) return false;
      if (answer == Recovering::discard) {
        Recovery::remove(file);
        continue;
      }
      recover(file);
      return true;
    } catch (const InputError& bad) {
      prompts_.report_error(QString::fromUtf8(bad.what()));
      Recovery::set_aside(file);
    }
  return false;
}

void DocumentControl::recover(const std::filesystem::path& file) {
  const Recovered found = recovered_from(file);
  opener_.make(
      QStringLiteral("Recovering %1").arg(QString::fromStdString(found.scene.name)),
      [found](const Progress& progress) {
        LoadedScene opened = open_scene(found.scene, progress);
        opened.here = found.here;
        return opened;
      },
      [this, found, file](DrawnSession drawn) {
        emit show_wanted(drawn, false);
        document_.set_saved_text(found.saved_text);
        if (found.camera) emit look_wanted(*found.camera);
        // The other goes only once this one is there.
        kept_.clear();
        if (recovery_.keep_now(for_recovery())) {
          kept_ = text_for_recovery();
          Recovery::remove(file);
        }
        emit changed();
      },
      {});
}

}  // namespace sonde::ui
