// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/cases.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::reference {
namespace {

/// Seeded by the name of the pair and the index (FNV-1a): a case does not change when others come.
std::mt19937_64 random_of(const std::string& pair, int index) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : pair + "/" + std::to_string(index))
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return std::mt19937_64(hash);
}

/// Finds a pose of one kind at which two bodies overlap.
class PoseFinder {
 public:
  PoseFinder(const PairSpec& spec, const Body& probe, const Body& fixed, int index)
      : spec_(spec), probe_(probe), fixed_(fixed), random_(random_of(spec.name, index)) {}

  Pose find(Kind kind) {
    for (int tries = 0; tries < most_tries; ++tries) {
      Pose X = propose(kind, tries);
      if (overlaps(X)) return X;
    }
    throw std::runtime_error("no overlapping pose found: " + spec_.name + ", " + name(kind));
  }

 private:
  bool overlaps(const Pose& X) const { return overlap(probe_, fixed_, Transform(X), Doubt::exact); }
  /// The probe turned, its centre of mass away from the other's by this much.
  Pose placed(const Quat& q, const Vec3& apart) const {
    return {q, fixed_.mass.com + apart - q * probe_.mass.com};
  }
  Vec3 direction() { return test::random_rotation(random_) * Vec3::UnitX(); }

  Pose propose(Kind kind, int tries) {
    const double both = probe_.mass.radius + fixed_.mass.radius;
    const double smaller = std::min(probe_.mass.radius, fixed_.mass.radius);
    const Quat q = test::random_rotation(random_);
    switch (kind) {
      case Kind::shallow:
        return touching(q, direction(), test::uniform(random_, 0.01, 0.06) * smaller);
      case Kind::medium:
        return placed(q, test::uniform(random_, 0.3, 0.6) * both * direction());
      case Kind::deep:
        return placed(q, test::random_in_ball(random_, 0.15 * smaller * std::pow(1.05, tries)));
      case Kind::linked:
        break;
    }
    return disturbed(std::pow(1.05, tries));
  }

  /// From outside along a direction to the first pose of a fine row that overlaps, back to contact
  /// by halving, and on by `further`.
  Pose touching(const Quat& q, const Vec3& from, double further) const {
    double away = 1.01 * (probe_.mass.radius + fixed_.mass.radius);
    const double stride = away / 400;
    while (away > 0 && !overlaps(placed(q, away * from))) away -= stride;
    double low = away, high = away + stride;
    for (int i = 0; i < 30; ++i) {
      const double middle = (low + high) / 2;
      (overlaps(placed(q, middle * from)) ? low : high) = middle;
    }
    return placed(q, (low - further) * from);
  }

  Pose disturbed(double more) {
    const double angle = test::uniform(random_, 0, std::min(1.0, spec_.turn * more));
    const Quat turn(Eigen::AngleAxisd(angle, direction()));
    const Vec3 com = spec_.linked * probe_.mass.com +
                     test::random_in_ball(random_, spec_.shift * more * probe_.mass.radius);
    const Quat q = (turn * spec_.linked.q).normalized();
    return {q, com - q * probe_.mass.com};
  }

  static constexpr int most_tries = 1000;
  const PairSpec& spec_;
  const Body& probe_;
  const Body& fixed_;
  std::mt19937_64 random_;
};

}  // namespace

const char* name(Kind kind) {
  constexpr std::array names = {"shallow", "medium", "deep", "linked"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<Case> cases(const PairSpec& spec, const Body& probe, const Body& fixed) {
  std::vector<Case> out;
  for (std::size_t k = 0; k < kinds; ++k)
    for (int i = 0; i < spec.count[k]; ++i) {
      const auto kind = static_cast<Kind>(k);
      const int index = static_cast<int>(out.size());
      out.push_back({index, kind, PoseFinder(spec, probe, fixed, index).find(kind)});
    }
  return out;
}

int case_count(const PairSpec& spec) {
  return std::accumulate(spec.count.begin(), spec.count.end(), 0);
}

}  // namespace sonde::reference
