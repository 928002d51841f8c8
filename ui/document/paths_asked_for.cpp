// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/paths_asked_for.hpp"

#include <QSettings>
#include <algorithm>
#include <system_error>

#include "engine/recording/recording.hpp"
#include "engine/scene/write_scene.hpp"
#include "ui/base/resources.hpp"

namespace sonde::ui {
namespace {

constexpr int most_files = 100;
const QString agreements_key = QStringLiteral("paths_agreed_to");
const QChar between_paths('\n');  // in no name that anybody has given

QString written(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

/// Links followed: agreed to is the file, not a name that may lead elsewhere tomorrow.
QString links_followed(const std::filesystem::path& path) {
  std::error_code error;
  const auto canonical = std::filesystem::weakly_canonical(path, error);
  return written(error ? path : canonical);
}

/// Each a scene or a recording, and what it may name.
QStringList agreements() { return QSettings().value(agreements_key).toStringList(); }

QStringList agreed_to(const QString& file) {
  for (const QString& entry : agreements())
    if (const QStringList parts = entry.split(between_paths); parts[0] == file) return parts.mid(1);
  return {};
}

bool is_our_own(const std::filesystem::path& file) {
  std::error_code error;
  const auto scenes =
      std::filesystem::canonical(resource(QStringLiteral("scenes")).toStdString(), error);
  return !error && lies_within(scenes.parent_path(), file);
}

/// Neither our own nor agreed to before.
QStringList to_ask_for(const std::vector<std::filesystem::path>& paths,
                       const std::filesystem::path& file) {
  const QStringList agreed = agreed_to(links_followed(file));
  QStringList out;
  for (const std::filesystem::path& path : paths)
    if (const QString named = links_followed(path); !is_our_own(path) && !agreed.contains(named))
      out << named;
  out.removeDuplicates();
  return out;
}

}  // namespace

QStringList paths_to_ask_for(const std::filesystem::path& scene) {
  return to_ask_for(paths_out_of(scene.parent_path(), scene), scene);
}

QStringList recorded_paths_to_ask_for(const std::filesystem::path& recording) {
  return to_ask_for(recorded_paths_out_of(recording.parent_path(), recording), recording);
}

void agree_to_paths(const std::filesystem::path& file, const QStringList& paths) {
  if (paths.isEmpty()) return;
  const QString name = links_followed(file);
  QStringList parts = QStringList(name) + agreed_to(name) + paths;
  parts.removeDuplicates();
  QStringList all = agreements();
  all.erase(std::remove_if(
                all.begin(), all.end(),
                [&](const QString& entry) { return entry.section(between_paths, 0, 0) == name; }),
            all.end());
  all.prepend(parts.join(between_paths));
  QSettings().setValue(agreements_key, QStringList(all.mid(0, most_files)));
}

void agree_to_paths_of(const Scene& scene, const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  agree_to_paths(file, to_ask_for(paths_out_of(folder, scene_text(scene, folder), file), file));
}

}  // namespace sonde::ui
