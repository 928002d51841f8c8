// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/mass_integrals.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "engine/base/progress.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {
namespace {

/// Inertias that agree to this, relative to the largest, count as equal: their axes are only noise.
constexpr double agree = 1e-9;

/// The affine frame of an integration pass. The integrals lose accuracy far from the origin, in
/// units far from one and, for a thin body, in slanted axes; so each pass uses a better frame.
struct Frame {
  Vec3 origin = Vec3::Zero();
  Mat3 axes = Mat3::Identity();
  double unit = 1;  ///< a power of two: no rounding
  Vec3 local(const Vec3& x) const { return axes.transpose() * ((x - origin) / unit); }
};

struct Moments {
  double measure = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  Vec3 mean() const { return first / measure; }
  Mat3 covariance() const { return second / measure - mean() * mean().transpose(); }
};

/// Exact integrals of 1, x and x xᵀ. Over a simplex of weight w with corners v_i in d dimensions,
/// ∫x = w Σv/(d+1) and ∫x xᵀ = w (Σ v vᵀ + s sᵀ)/((d+1)(d+2)), s = Σ v. The fourth corner of a
/// tetrahedron is the origin, and drops out of both sums.
Moments integrate(const Soup& soup, const Frame& frame, bool by_volume, const Progress& progress) {
  Moments m;
  const double d = by_volume ? 3 : 2;
  for_each_index(soup.triangles.size(), progress, [&](std::size_t i) {
    const Triangle& t = soup.triangles[i];
    const Vec3 a = frame.local(soup.vertices[t[0]]);
    const Vec3 b = frame.local(soup.vertices[t[1]]);
    const Vec3 c = frame.local(soup.vertices[t[2]]);
    const double w = by_volume ? a.dot(b.cross(c)) / 6 : (b - a).cross(c - b).norm() / 2;
    const Vec3 s = a + b + c;
    m.measure += w;
    m.first += w * s;
    m.second += w * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  });
  m.first /= d + 1;
  m.second /= (d + 1) * (d + 2);
  return m;
}

Frame first_frame(const Soup& soup) {
  Eigen::AlignedBox3d box;
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t i : t) box.extend(soup.vertices[i]);
  Frame frame;
  if (box.isEmpty()) return frame;
  frame.origin = box.center();
  int exponent = 0;
  if (std::frexp(box.sizes().maxCoeff(), &exponent) > 0) frame.unit = std::ldexp(1.0, exponent);
  return frame;
}

/// The axis with the sign that makes its largest component positive; if components are equal up to
/// rounding, the first decides.
Vec3 sign_canonical(const Vec3& axis) {
  const double largest = axis.cwiseAbs().maxCoeff();
  for (int i = 0; i < 3; ++i)
    if (std::abs(axis[i]) >= largest * (1 - agree)) return axis[i] < 0 ? Vec3(-axis) : axis;
  return axis;
}

/// A unit vector perpendicular to the axis: the mesh axis that is most nearly so, projected.
Vec3 canonical_across(const Vec3& axis) {
  const double smallest = axis.cwiseAbs().minCoeff();
  int i = 0;
  while (std::abs(axis[i]) > smallest + agree) ++i;
  return (Vec3::Unit(i) - axis[i] * axis).normalized();
}

/// Replaces arbitrary axes (of equal inertias) by canonical ones, and fixes signs.
void make_canonical(MassProperties& mass) {
  Vec3& inertia = mass.inertia;
  const double tolerance = agree * inertia[2];
  if (inertia[2] - inertia[0] <= tolerance) {
    inertia.setConstant(inertia.mean());
    mass.R_MP.setIdentity();
    return;
  }
  Vec3 x = mass.R_MP.col(0), y = mass.R_MP.col(1);
  if (inertia[1] - inertia[0] <= tolerance) {
    inertia.head<2>().setConstant(inertia.head<2>().mean());
    const Vec3 z = mass.R_MP.col(2);
    x = canonical_across(z);
    y = z.cross(x);
  } else if (inertia[2] - inertia[1] <= tolerance) {
    inertia.tail<2>().setConstant(inertia.tail<2>().mean());
    y = canonical_across(x);
  }
  x = sign_canonical(x);
  y = sign_canonical(y);
  mass.R_MP << x, y, x.cross(y);
}

/// The axes of a covariance by falling spread, that is, by rising inertia; right-handed.
Mat3 principal_axes(const Mat3& covariance) {
  const Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(covariance).eigenvectors();
  Mat3 out;
  out << axes.col(2), axes.col(1), axes.col(2).cross(axes.col(1));
  return out;
}

/// Adds moments, converted to the units of a frame.
void add(Moments& m, const MassMoments& more, const Frame& frame) {
  if (more.measure == 0) return;
  const double unit = frame.unit, cube = unit * unit * unit;
  const Vec3 shift = more.origin - frame.origin;
  const Vec3 first = more.first + more.measure * shift;
  const Mat3 second = more.second + more.first * shift.transpose() +
                      shift * more.first.transpose() + more.measure * shift * shift.transpose();
  m.measure += more.measure / cube;
  m.first += frame.axes.transpose() * first / (cube * unit);
  m.second += frame.axes.transpose() * second * frame.axes / (cube * unit * unit);
}

MassProperties mass_properties(const Soup& soup, bool by_volume, const Progress& progress,
                               const MassMoments& more) {
  MassProperties mass;
  mass.by_volume = by_volume;
  Frame frame = first_frame(soup);
  Moments moments = integrate(soup, frame, by_volume, part_of(progress, 0, 0.4));
  add(moments, more, frame);
  mass.com = frame.origin;
  const double scale = by_volume ? frame.unit * frame.unit * frame.unit : frame.unit * frame.unit;
  mass.measure = moments.measure * scale;
  if (moments.measure != 0) {
    frame.origin += frame.unit * moments.mean();
    frame.axes = principal_axes(moments.covariance());
    moments = integrate(soup, frame, by_volume, part_of(progress, 0.4, 0.8));
    add(moments, more, frame);
    mass.measure = moments.measure * scale;
    mass.com = frame.origin + frame.unit * (frame.axes * moments.mean());
    const Mat3 covariance = moments.covariance();
    const Mat3 correction = principal_axes(covariance);
    // Uses sums of spreads along the axes, not eigenvalues, which are exact only relative to the
    // largest.
    const Vec3 spread =
        (correction.transpose() * covariance * correction).diagonal().cwiseMax(0.0) *
        (frame.unit * frame.unit);
    mass.inertia = Vec3(spread[1] + spread[2], spread[0] + spread[2], spread[0] + spread[1]);
    mass.R_MP = frame.axes * correction;
    make_canonical(mass);
    for (double& i : mass.inertia)
      if (i <= 1e-14 * mass.inertia[2]) i = 0;
  }
  mass.radius = radius_about(soup, mass.com);
  return mass;
}

}  // namespace

double radius_about(const Soup& soup, const Vec3& com) {
  double squared = 0;
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t i : t)
      squared = std::max(squared, (soup.vertices[i] - com).squaredNorm());
  return std::sqrt(squared);
}

MassProperties mass_by_volume(const Soup& soup, const Progress& progress, const MassMoments& more) {
  return mass_properties(soup, true, progress, more);
}
MassProperties mass_by_area(const Soup& soup, const Progress& progress) {
  return mass_properties(soup, false, progress, {});
}

}  // namespace sonde
