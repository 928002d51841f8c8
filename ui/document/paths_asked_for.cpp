// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/paths_asked_for.hpp"

#include <QSettings>
#include <algorithm>
#include <system_error>

#include "engine/scene/scene.hpp"
#include "ui/base/resources.hpp"

namespace sonde::ui {
namespace {

constexpr int most_scenes = 100;
const QString agreements_key = QStringLiteral("paths_agreed_to");
const QChar between_paths('\n');  // in no name that anybody has given

QString written(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

/// Links followed: agreed to is the file, not a name that may lead elsewhere tomorrow.
QString links_followed(const std::filesystem::path& path) {
  std::error_code error;
  const auto canonical = std::filesystem::weakly_canonical(path, error);
  return written(error ? path : canonical);
}

/// Each a scene and what it may name.
QStringList agreements() { return QSettings().value(agreements_key).toStringList(); }

QStringList agreed_to(const QString& scene) {
  for (const QString& entry : agreements())
    if (const QStringList parts = entry.split(between_paths); parts[0] == scene)
      return parts.mid(1);
  return {};
}

std::filesystem::path may_read_in(const std::filesystem::path& scene) {
  std::error_code error;
  const auto scenes =
      std::filesystem::canonical(resource(QStringLiteral("scenes")).toStdString(), error);
  return !error && lies_within(scenes, scene) ? scenes.parent_path() : scene.parent_path();
}

}  // namespace

QStringList paths_to_ask_for(const std::filesystem::path& scene) {
  const QStringList agreed = agreed_to(links_followed(scene));
  QStringList out;
  for (const std::filesystem::path& path : paths_out_of(may_read_in(scene), scene))
    if (const QString file = links_followed(path); !agreed.contains(file)) out << file;
  out.removeDuplicates();
  return out;
}

void agree_to_paths(const std::filesystem::path& scene, const QStringList& paths) {
  if (paths.isEmpty()) return;
  const QString name = links_followed(scene);
  QStringList parts = QStringList(name) + agreed_to(name) + paths;
  parts.removeDuplicates();
  QStringList all = agreements();
  all.erase(std::remove_if(
                all.begin(), all.end(),
                [&](const QString& entry) { return entry.section(between_paths, 0, 0) == name; }),
            all.end());
  all.prepend(parts.join(between_paths));
  QSettings().setValue(agreements_key, QStringList(all.mid(0, most_scenes)));
}

}  // namespace sonde::ui
