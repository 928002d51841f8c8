// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/kept_gains.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

#include "engine/base/error.hpp"
#include "engine/settings/settings.hpp"
#include "engine/study/parts/study_parts.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/text_file.hpp"
#include "ui/base/resources.hpp"

namespace sonde::ui {
namespace {

namespace fs = std::filesystem;

constexpr int kept_gains_version = 1;
constexpr std::size_t most_kept_bytes = 1 << 16;  // of three couplings: more is no such file

QJsonObject json_of(const Coupling& gains) {
  QJsonObject json{{QStringLiteral("mode"), QLatin1String(name_of(gains.mode))}};
  for (const Setting& setting : coupling_settings())
    json[QLatin1String(setting.key)] = get(gains, setting.key);
  return json;
}

Coupling coupling_of(const fs::path& file, const QJsonValue& value) {
  const QJsonObject json = value.toObject();
  const auto mode = coupling_mode(json[QStringLiteral("mode")].toString().toStdString());
  if (!mode) throw InputError::in(file.string(), "has no mode of coupling");
  Coupling gains;
  gains.mode = *mode;
  for (const Setting& setting : coupling_settings()) {
    const double own = json[QLatin1String(setting.key)].toDouble(setting.maximum + 1);
    if (!allowed(setting, own))
      throw InputError::in(file.string(),
                           std::string(setting.key) + " must be " + range_text(setting));
    set(gains, setting.key, own);
  }
  return gains;
}

std::string place_of_file(const fs::path& file) {
  return fs::absolute(file).lexically_normal().string();
}

}  // namespace

bool same(const Coupling& a, const Coupling& b) {
  return a.mode == b.mode && std::ranges::all_of(coupling_settings(), [&](const Setting& setting) {
           return get(a, setting.key) == get(b, setting.key);
         });
}

fs::path kept_gains_file(const Scene& scene, const std::string& device) {
  const std::string of =
      scene.file.empty() ? place_of_file(scene.probe.mesh) + '\n' + place_of_file(scene.fixed.mesh)
                         : place_of_file(scene.file);
  return device_settings_folder().parent_path() / "gains" /
         (fingerprint(of + '\n' + device) + ".json");
}

std::optional<KeptGains> read_kept_gains(const fs::path& file, const Coupling& of_scene) {
  std::error_code none;
  if (!fs::exists(file, none)) return {};
  const QJsonObject json =
      QJsonDocument::fromJson(QByteArray::fromStdString(read_text(file, most_kept_bytes))).object();
  if (json[QStringLiteral("version")].toInt() != kept_gains_version)
    throw InputError::in(file.string(), "holds no gains of this version");
  const QJsonArray sets = json[QStringLiteral("sets")].toArray();
  KeptGains kept{.sets = {coupling_of(file, sets.at(0)), coupling_of(file, sets.at(1))},
                 .active = json[QStringLiteral("active")].toInt() == 1 ? 1U : 0U,
                 .of_scene = coupling_of(file, json[QStringLiteral("scene")])};
  // Saved since, the scene has the active set.
  const bool as_then = same(kept.of_scene, of_scene) || same(kept.sets.at(kept.active), of_scene);
  return as_then ? std::optional(kept) : std::nullopt;
}

void write_kept_gains(const fs::path& file, const KeptGains& gains) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw InputError::in(file.parent_path().string(), error.message());
  const QJsonObject json{
      {QStringLiteral("version"), kept_gains_version},
      {QStringLiteral("sets"), QJsonArray{json_of(gains.sets[0]), json_of(gains.sets[1])}},
      {QStringLiteral("active"), static_cast<int>(gains.active)},
      {QStringLiteral("scene"), json_of(gains.of_scene)}};
  write_whole(file, QJsonDocument(json).toJson().toStdString());
}

}  // namespace sonde::ui
