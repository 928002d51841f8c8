// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/penetration/sensitivity/feature_row.hpp"

namespace sonde {

/// The features of two bodies that face each other at a pose, each listed once. Never allocates.
class FacingFeatures {
 public:
  static constexpr std::size_t capacity = 256;
  FacingFeatures(const Body& probe, const Body& fixed) noexcept : probe_(probe), fixed_(fixed) {}

  /// Starts an empty list for a probe at X_FM. `reach`, m: features further apart do not count.
  void begin(const Transform& X_FM, double reach) noexcept {
    X_ = X_FM;
    reach_ = reach;
    close_ = {1e-4, 1e-3 * reach, -reach};
    size_ = 0;
    overflowed_ = false;
  }

  /// Adds the features at a contact, from the triangles around its points: features whose gap lies
  /// along the contact's normal. If larger features lie on each other, these are the corners of
  /// their common part. Returns the number of features found there, including known ones.
  int add_around(const Vec3& on_probe, const Vec3& on_fixed, const Vec3& normal) noexcept;
  /// Adds features of the triangles around these points whatever their normal is, provided that it
  /// separates the triangles. Also adds features that face each other only after the probe has
  /// moved by up to the reach. Example: an edge lies across a hollow corner, in which two other
  /// edges meet. It rests on both of these, but the clearance lets it float above one of them, at
  /// the point nearest to the corner.
  void add_hollow(const Vec3& on_probe, const Vec3& on_fixed, const Vec3& normal) noexcept;
  /// Adds the features of a pair of triangles along `normal` (unit, from the fixed body to the
  /// probe).
  int add_pair(std::uint32_t a, std::uint32_t b, const Vec3& normal) noexcept;

  std::span<const FeatureRow> rows() const { return {rows_.data(), size_}; }
  bool overflowed() const { return overflowed_; }

 private:
  /// A triangle in F, and those of its features that may face the other body along a normal.
  struct Facing {
    std::array<Vec3, 3> at, edge;  ///< corners; unit directions of the edges
    std::array<double, 3> length;  ///< of the edges, m
    std::array<std::uint32_t, 3> vertex;
    Vec3 face;                 ///< unit normal, along the contact's
    bool faces;                ///< the face is perpendicular to the normal
    std::array<bool, 3> lies;  ///< an edge is perpendicular to the normal
  };
  /// Identifies a row: vertices of the probe and of the fixed body.
  using Names = std::array<std::uint32_t, 4>;

  /// The triangles around the points of a contact.
  struct Around {
    std::array<std::uint32_t, 64> a, b;
    std::size_t count_a, count_b;
  };
  void find_around(const Vec3& on_probe, const Vec3& on_fixed, Around& out) noexcept;
  /// Tolerances.
  struct Slack {
    double angle = 0;   ///< sine: largest angle of a feature's normal and the given one
    double border = 0;  ///< m: largest distance beyond the border of a feature
    double least = 0;   ///< m: least gap of the triangles along its normal
  };
  Facing facing(const Soup& soup, std::uint32_t triangle, const Transform& X, const Vec3& normal,
                const Slack& slack) const noexcept;
  int add(const Facing& a, const Facing& b, const Vec3& normal, const Slack& slack) noexcept;
  bool add_vertex_on_face(const Facing& a, std::size_t i, const Facing& b,
                          const Slack& slack) noexcept;
  bool add_face_on_vertex(const Facing& a, const Facing& b, std::size_t j,
                          const Slack& slack) noexcept;
  bool add_edges(const Facing& a, std::size_t i, const Facing& b, std::size_t j, const Vec3& normal,
                 const Slack& slack) noexcept;
  void push(const FeatureRow& row, const Names& names, const Vec3& face) noexcept;
  bool knows(FeatureRow::Kind kind, const Names& names, const Vec3& face) const noexcept;

  const Body& probe_;
  const Body& fixed_;
  Transform X_;
  double reach_ = 0;
  Slack close_;  ///< tolerances of features at a contact
  std::array<FeatureRow, capacity> rows_;
  std::array<Names, capacity> names_;
  std::array<Vec3, capacity> faces_;  // the row's normal in F at X_
  std::size_t size_ = 0;
  bool overflowed_ = false;
};

}  // namespace sonde
