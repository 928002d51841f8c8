// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/room.hpp"

#include <algorithm>

namespace sonde::app {

Room room_of(const Separation& separation) {
  if (separation.status == Status::failed) return {};
  if (separation.status == Status::separated) {
    if (!separation.clearance) return {};
    return {separation.clearance->distance, separation.clearance->on_fixed};
  }
  const auto& contacts = separation.contacts;
  const auto most =
      std::ranges::max_element(contacts, {}, [](const Contact& c) { return c.multiplier; });
  // From zero, so that a depth of none has no sign.
  return {0 - separation.depth,
          most == contacts.end() ? std::nullopt : std::optional(most->on_fixed)};
}

}  // namespace sonde::app
