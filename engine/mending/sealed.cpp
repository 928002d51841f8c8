// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/sealed.hpp"

#include <algorithm>

namespace sonde {

Sealed seal(const Soup& soup, const Seams& seams, const Orientation& orientation,
            const std::vector<Cap>& caps) {
  Sealed out;
  out.soup.vertices = soup.vertices;
  const auto add = [&](const Triangle& t, std::uint32_t part, std::uint32_t cap) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    out.soup.triangles.push_back(t);
    out.part.push_back(part);
    out.cap.push_back(cap);
  };
  out.soup.triangles.reserve(soup.triangles.size());
  out.part.reserve(soup.triangles.size());
  out.cap.reserve(soup.triangles.size());
  auto cut = seams.cuts.begin();
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    corners.clear();
    for (std::uint32_t k = 0; k < 3; ++k) {
      corners.push_back(seams.label[soup.triangles[i][k]]);
      for (; cut != seams.cuts.end() && cut->side == 3 * i + k; ++cut)
        corners.insert(corners.end(), cut->at.begin(), cut->at.end());
    }
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      Triangle t{corners[0], corners[k], corners[k + 1]};
      if (orientation.turned[i]) std::swap(t[1], t[2]);
      add(t, orientation.part[i], Sealed::no_cap);
    }
  }
  for (std::uint32_t c = 0; c < caps.size(); ++c)
    for (const Triangle& t : caps[c].triangles) add(t, caps[c].part, c);
  return out;
}

Sealed parts_of(const Sealed& sealed, const std::vector<bool>& wanted) {
  Sealed out;
  out.soup.vertices = sealed.soup.vertices;
  for (std::size_t i = 0; i < sealed.part.size(); ++i) {
    if (!wanted[sealed.part[i]]) continue;
    out.soup.triangles.push_back(sealed.soup.triangles[i]);
    out.part.push_back(sealed.part[i]);
    out.cap.push_back(sealed.cap[i]);
  }
  return out;
}

}  // namespace sonde
