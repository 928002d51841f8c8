// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "engine/body/body.hpp"
#include "engine/geometry/pose.hpp"

namespace sonde {

/// Whether parts that meet overlap nowhere by more than an allowance, however far the way out is:
/// a peg as large as its hole. Each solid is taken smaller at most once for an allowance, by moving
/// its faces inwards (offset_faces). Any number of threads may ask.
class Fits {
 public:
  enum class Answer { fit, overlap, unknown };

  /// `fit` if the parts are free of each other by the exact test once the faces of either one have
  /// been moved inwards by `allowance` and some roundings (m). Both ways are tried, since a sharp
  /// tip moves further than its faces do. If only one part can be taken smaller (the other is too
  /// thin, or a surface), that one decides; `unknown` if neither can.
  /// @pre The parts meet at X_FM, whose quaternion is unit. They live as long as this object.
  Answer ask(const Body& probe, const Body& fixed, const Pose& X_FM, double allowance);

 private:
  struct Smaller {
    std::once_flag made;
    std::shared_ptr<const Body> body;  ///< none if it cannot be taken smaller
  };
  const Body* smaller(const Body& body, double by);

  std::mutex mutex_;
  std::map<std::pair<const Body*, double>, std::unique_ptr<Smaller>> known_;
};

}  // namespace sonde
