// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cmath>

/// What a test and a stand-in for a maker's library share: the arms it plays, the faults it is to
/// have, and what it was told. The stand-in is loaded as the real one would be, so the test finds
/// this by the function `standin`, which the real one does not have.
namespace sonde::test {

struct Standin {
  static constexpr int most = 4;

  // By the test, at any time.
  std::atomic<int> arms{1};   ///< connected
  std::atomic<int> major{3};  ///< of the version
  std::atomic<int> minor{14};
  std::atomic<double> p[3] = {};    ///< of the handle, in the library's own unit and axes
  std::atomic<double> angle{0};     ///< rad, about one of the library's axes
  std::atomic<int> axis{2};         ///< that axis
  std::atomic<bool> nan{false};     ///< in the pose
  std::atomic<bool> skewed{false};  ///< the rotation matrix is none
  std::atomic<bool> frozen{false};  ///< the clock stands: no new pose comes
  std::atomic<bool> unplugged{false};
  std::atomic<bool> uncalibrated{false};
  std::atomic<int> fault{0};  ///< libdhd: why the force is off; libHD: an error code, in one frame
  std::atomic<unsigned> buttons{0};
  std::atomic<double> stiffest{0}, most_damped{0};  ///< libHD: N/mm, N per mm/s; 0: it has neither
  std::atomic<int> model{104};  ///< libdhd: its system type. libHD: 6 takes torques, 3 does not

  // By the stand-in.
  std::atomic<double> force[3] = {}, torque[3] = {};  ///< as they were handed over
  std::atomic<bool> force_on{false}, gravity{false};
  std::atomic<int> open{0}, opened{0}, frames{0};
  std::atomic<int> which{-1};                ///< arm that was opened last
  std::atomic<const char*> broken{nullptr};  ///< the first rule of the library that was broken

  /// The handle's rotation, or none.
  void rotation(double rows[3][3]) const {
    const int a = axis, b = (a + 1) % 3, c = (a + 2) % 3;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) rows[i][j] = 0;
    rows[a][a] = skewed ? 2 : 1;
    rows[b][b] = rows[c][c] = std::cos(angle);
    rows[c][b] = std::sin(angle);
    rows[b][c] = -rows[c][b];
  }

  void rule(bool kept, const char* words) {
    const char* none = nullptr;
    if (!kept) broken.compare_exchange_strong(none, words);
  }
};

}  // namespace sonde::test

extern "C" sonde::test::Standin* standin();
