// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/fingerprint.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/sonde.hpp"

namespace sonde {
namespace {

std::shared_ptr<const Body> wedge(double top, Model model = Model::solid, bool turned = false) {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, top}};
  std::vector<std::array<std::uint32_t, 3>> faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  if (turned) std::swap(faces[0], faces[1]);
  return make_body(corners, faces, model, "wedge");
}

TEST(Fingerprint, a_body_made_again_has_the_same) {
  EXPECT_EQ(fingerprint(*wedge(1)), fingerprint(*wedge(1)));
  const auto mirrored = [](double zero) {
    const std::vector<Vec3> corners{{zero, 0, 0}, {1, zero, 0}, {0, 1, zero}, {0, 0, 1}};
    const std::vector<std::array<std::uint32_t, 3>> faces{
        {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    return fingerprint(*make_body(corners, faces, Model::solid, "wedge"));
  };
  EXPECT_EQ(mirrored(-0.0), mirrored(0.0));
}

TEST(Fingerprint, the_last_bit_of_a_corner_the_model_the_mass_and_the_order_count) {
  const auto body = wedge(1);
  MassProperties heavy = facts(*body).mass;
  heavy.inertia *= 1 + 1e-15;
  std::set<std::uint64_t> all{fingerprint(*body), fingerprint(*wedge(std::nextafter(1.0, 2.0))),
                              fingerprint(*wedge(1, Model::surface)),
                              fingerprint(*wedge(1, Model::solid, true)),
                              fingerprint(*with_mass(*body, heavy))};
  EXPECT_EQ(all.size(), 5u);
}

}  // namespace
}  // namespace sonde
