// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/peer.hpp"

namespace sonde::bench {

std::vector<PeerLibrary> installed_peers() {
  std::vector<PeerLibrary> out;
#ifdef SONDE_BENCH_FCL
  out.push_back(fcl_library());
#endif
#ifdef SONDE_BENCH_BULLET
  out.push_back(bullet_library());
#endif
  return out;
}

}  // namespace sonde::bench
