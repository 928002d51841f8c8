// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recovery.hpp"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <system_error>

#include "engine/base/error.hpp"
#include "engine/scene/write_scene.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/text_file.hpp"
#include "ui/document/pose_text.hpp"

namespace sonde::ui {
namespace {

namespace fs = std::filesystem;

constexpr int recovery_version = 1;
constexpr std::size_t most_recovery_bytes = std::size_t{1} << 22;

QString lock_name(const fs::path& file) { return QString::fromStdString(file.string() + ".lock"); }

QJsonArray numbers(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Vec3 vector_of(const QJsonValue& value) {
  const QJsonArray array = value.toArray();
  return {array.at(0).toDouble(), array.at(1).toDouble(), array.at(2).toDouble()};
}

std::string string_of(const QJsonObject& object, const char* key) {
  return object.value(QLatin1String(key)).toString().toStdString();
}

/// A lock is stale where its program has died, however young it is.
std::unique_ptr<QLockFile> lock_of(const fs::path& file) {
  auto lock = std::make_unique<QLockFile>(lock_name(file));
  lock->setStaleLockTime(0);
  return lock;
}

}  // namespace

std::string recovery_text(const Recovered& recovered) {
  QJsonObject json;
  json[QStringLiteral("version")] = recovery_version;
  json[QStringLiteral("when")] = recovered.when.toString(Qt::ISODate);
  const fs::path& open = recovered.scene.file;
  const fs::path whole = open.empty() ? open : fs::absolute(open);
  json[QStringLiteral("file")] = QString::fromStdString(whole.string());
  json[QStringLiteral("name")] = QString::fromStdString(recovered.scene.name);
  json[QStringLiteral("scene")] = QString::fromStdString(scene_text(recovered.scene, "/"));
  json[QStringLiteral("saved")] = QString::fromStdString(recovered.saved_text);
  json[QStringLiteral("here")] = QString::fromStdString(pose_text(recovered.here));
  if (recovered.camera)
    json[QStringLiteral("camera")] =
        QJsonObject{{QStringLiteral("position"), numbers(recovered.camera->position)},
                    {QStringLiteral("target"), numbers(recovered.camera->target)},
                    {QStringLiteral("up"), numbers(recovered.camera->up)}};
  return QJsonDocument(json).toJson().toStdString();
}

Recovered recovered_from(const fs::path& file) {
  const QJsonObject json =
      QJsonDocument::fromJson(QByteArray::fromStdString(read_text(file, most_recovery_bytes)))
          .object();
  if (json.value(QStringLiteral("version")).toInt() != recovery_version)
    throw InputError::in(file.string(), "is no recovery file of this version");
  Recovered recovered;
  try {
    recovered.scene = scene_in(string_of(json, "scene"), "/recovered.sonde.json");
  } catch (const InputError& bad) {
    throw InputError::in(file.string(), bad.what());
  }
  for (SceneBody* body : {&recovered.scene.probe, &recovered.scene.fixed})
    body->scene_file.clear();  // which never was
  recovered.scene.file = string_of(json, "file");
  recovered.scene.name = string_of(json, "name");
  recovered.saved_text = string_of(json, "saved");
  recovered.when =
      QDateTime::fromString(json.value(QStringLiteral("when")).toString(), Qt::ISODate);
  try {
    recovered.here = pose_in(string_of(json, "here"));
  } catch (const std::invalid_argument& bad) {
    throw InputError::in(file.string(), bad.what());
  }
  if (const QJsonValue camera = json.value(QStringLiteral("camera")); camera.isObject())
    recovered.camera = CameraPlace{vector_of(camera[QStringLiteral("position")]),
                                   vector_of(camera[QStringLiteral("target")]),
                                   vector_of(camera[QStringLiteral("up")])};
  return recovered;
}

Recovery::Recovery(fs::path folder) : folder_(std::move(folder)) {}

Recovery::~Recovery() { clear(); }

bool Recovery::keep(const Recovered& recovered) {
  if (writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return false;
  if (!lock_) {
    std::error_code failed;
    fs::create_directories(folder_, failed);
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    file_ = folder_ / (std::to_string(QCoreApplication::applicationPid()) + '-' +
                       std::to_string(now) + ".json");
    lock_ = lock_of(file_);
    if (!lock_->tryLock(0)) return lock_.reset(), false;
  }
  writing_ = std::async(std::launch::async, [file = file_, recovered] {
    try {
      write_whole(file, recovery_text(recovered));
    } catch (const std::exception&) {
      return false;  // a disk that is full now: the next change tries again, and saving says why
    }
    return true;
  });
  return true;
}

bool Recovery::keep_now(const Recovered& recovered) {
  if (writing_.valid()) writing_.wait();
  return keep(recovered) && writing_.get();
}

void Recovery::clear() {
  if (writing_.valid()) writing_.wait();
  if (!lock_) return;
  std::error_code ignored;
  fs::remove(file_, ignored);
  lock_.reset();  // takes its file away
}

void Recovery::leave() {
  if (writing_.valid()) writing_.wait();
  lock_.reset();
}

std::vector<fs::path> Recovery::left_over() const {
  std::vector<fs::path> found;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, none)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".json" || name.starts_with('.') || entry.path() == file_)
      continue;
    if (lock_of(entry.path())->tryLock(0)) found.push_back(entry.path());
  }
  std::ranges::sort(found, [](const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    return fs::last_write_time(a, ignored) > fs::last_write_time(b, ignored);
  });
  return found;
}

void Recovery::set_aside(const fs::path& file) {
  std::error_code ignored;
  fs::rename(file, file.string() + ".bad", ignored);
}

void Recovery::remove(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

fs::path recovery_folder() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return fs::path(folder.toStdString()) / "recovery";
}

}  // namespace sonde::ui
