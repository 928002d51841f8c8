// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/fingerprint.hpp"

#include <cstring>
#include <type_traits>

#include "engine/body/body.hpp"

namespace sonde {
namespace {

class Fingerprint {
 public:
  template <class T>
  void add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::uint64_t bits = 0;
    static_assert(sizeof(T) <= sizeof bits);
    std::memcpy(&bits, &value, sizeof value);
    state_ = (state_ ^ bits) + 0x9e3779b97f4a7c15ULL;
    state_ = (state_ ^ (state_ >> 30)) * 0xbf58476d1ce4e5b9ULL;
    state_ = (state_ ^ (state_ >> 27)) * 0x94d049bb133111ebULL;
    state_ ^= state_ >> 31;
  }
  template <class Matrix>
  void add_all(const Matrix& m) {
    for (Eigen::Index i = 0; i < m.size(); ++i) add(m.data()[i] + 0.0);  // −0 is 0
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace

std::uint64_t fingerprint(const Body& body) {
  Fingerprint out;
  out.add(body.solid);
  out.add_all(body.mass.com);
  out.add_all(body.mass.R_MP);
  out.add_all(body.mass.inertia);
  out.add(body.mass.radius);
  const Soup& soup = surface(body);
  out.add(soup.vertices.size());
  for (const Vec3& x : soup.vertices) out.add_all(x);
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t i : t) out.add(i);
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) out.add(is_loose(body, i));
  return out.value();
}

}  // namespace sonde
