// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/fingerprint.hpp"

#include <bit>

namespace sonde::python {
namespace {

/// Takes numbers one by one, each by the steps of splitmix64 (Steele, Lea, Flood 2014).
class Taken {
 public:
  void add(std::uint64_t bits) {
    state_ = (state_ ^ bits) + 0x9e3779b97f4a7c15ULL;
    state_ = (state_ ^ (state_ >> 30)) * 0xbf58476d1ce4e5b9ULL;
    state_ = (state_ ^ (state_ >> 27)) * 0x94d049bb133111ebULL;
    state_ ^= state_ >> 31;
  }
  void add_all(const auto& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i)
      add(std::bit_cast<std::uint64_t>(double{matrix.data()[i]}));
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace

std::uint64_t fingerprint(const sonde::Body& body, const BodyFacts& known) {
  Taken taken;
  taken.add(known.solid);
  taken.add_all(known.mass.com);
  taken.add_all(known.mass.R_MP);
  taken.add_all(known.mass.inertia);
  taken.add(vertices(body).size());
  for (const Vec3& x : vertices(body)) taken.add_all(x);
  for (const auto& triangle : triangles(body))
    for (const std::uint32_t corner : triangle) taken.add(corner);
  return taken.value();
}

}  // namespace sonde::python
