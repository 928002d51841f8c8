// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/saved_views.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <optional>

#include "ui/document/vector_in.hpp"

namespace sonde::ui {
namespace {

QJsonObject view_of(const Scene& scene) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(scene.view)).object();
}

QJsonArray array_of(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

}  // namespace

std::vector<SavedView> saved_views(const Scene& scene) {
  std::vector<SavedView> views;
  const Pose X_FW = inverse(scene.fixed.pose);
  const QJsonArray saved = view_of(scene).value(QStringLiteral("saved")).toArray();
  for (const QJsonValue& value : saved) {
    const QJsonObject one = value.toObject();
    const auto position = vector_in(one, "camera_position");
    const auto target = vector_in(one, "camera_target");
    const auto up = vector_in(one, "camera_up");
    if (!position || !target || !up || !((*position - *target).cross(*up).norm() > 0)) continue;
    views.push_back(
        {one.value(QStringLiteral("name")).toString(),
         {X_FW * Vec3(*position * scene.unit), X_FW * Vec3(*target * scene.unit), X_FW.q * *up}});
  }
  return views;
}

std::string view_with(const Scene& scene, const std::vector<SavedView>& views) {
  QJsonObject view = view_of(scene);
  const Pose& X_WF = scene.fixed.pose;
  QJsonArray saved;
  for (const SavedView& one : views)
    saved.push_back(QJsonObject{
        {QStringLiteral("name"), one.name},
        {QStringLiteral("camera_position"), array_of(X_WF * one.place.position / scene.unit)},
        {QStringLiteral("camera_target"), array_of(X_WF * one.place.target / scene.unit)},
        {QStringLiteral("camera_up"), array_of(X_WF.q * one.place.up)}});
  if (saved.isEmpty())
    view.remove(QStringLiteral("saved"));
  else
    view.insert(QStringLiteral("saved"), saved);
  return QJsonDocument(view).toJson(QJsonDocument::Compact).toStdString();
}

}  // namespace sonde::ui
