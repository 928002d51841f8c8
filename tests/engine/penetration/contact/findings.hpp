// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/penetration/contact/contact_rows.hpp"

namespace sonde::test {

/// The two ways to find what is near: in a list of pairs, and in the trees.
inline constexpr ContactRows::Finding by_list{}, by_trees{48, 0};

}  // namespace sonde::test
