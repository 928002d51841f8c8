// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <optional>

#include "engine/geometry/model.hpp"

namespace sonde::ui {

/// A vector of a JSON object; none where the key holds no three values.
inline std::optional<Vec3> vector_in(const QJsonObject& object, const char* key) {
  const QJsonArray array = object.value(QLatin1String(key)).toArray();
  if (array.size() != 3) return std::nullopt;
  return Vec3(array[0].toDouble(), array[1].toDouble(), array[2].toDouble());
}

}  // namespace sonde::ui
