// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/repair_sentences.hpp"

#include "engine/text/counted.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

std::string percent(double share) { return number_text(100 * share, 3) + " %"; }

}  // namespace

std::vector<std::string> sentences(const Repairs& r) {
  std::vector<std::string> out;
  if (r.joined > 0)
    out.push_back(counted(r.joined, "corner") + " joined with others up to " +
                  number_text(r.reach, 3) + " m away");
  if (r.on_edges > 0)
    out.push_back(counted(r.on_edges, "corner") + " found on edges of others, which count as cut");
  if (r.unsearched > 0)
    out.push_back(counted(r.unsearched, "open edge") +
                  ", too many to look for corners that lie on them (T-junctions): such edges stay "
                  "open, are capped, and may leave parts that belong together apart");
  if (r.repeated > 0) out.push_back(counted(r.repeated, "repeated triangle") + " counted once");
  if (r.turned_triangles > 0)
    out.push_back(counted(r.turned_triangles, "triangle") + " turned to agree with neighbours");
  if (r.turned_parts > 0 && r.turned_parts == r.parts)
    out.emplace_back("was inside out and has been turned");
  else if (r.turned_parts > 0)
    out.push_back(counted(r.turned_parts, "part") + " of " + std::to_string(r.parts) +
                  " inside out, turned");
  if (r.caps > 0)
    out.push_back(counted(r.caps, "opening") + " closed by " +
                  counted(r.cap_triangles, "triangle") + " of " + number_text(r.cap_area, 3) +
                  " m², the widest " + percent(r.widest_cap) + " of what is seen from outside");
  if (r.solid_parts > 0 && r.solid_parts < r.parts) {
    const std::size_t open = r.parts - r.solid_parts;
    out.push_back(std::to_string(open) + " of " + counted(r.parts, "part") +
                  (open == 1 ? " stays open: only its triangles count"
                             : " stay open: only their triangles count"));
  }
  if (r.torn_parts > 0)
    out.push_back(counted(r.torn_parts, "part") + " of " + std::to_string(r.parts) +
                  " with one side only (non-orientable)");
  if (r.hidden > 0)
    out.push_back(counted(r.hidden, "triangle") +
                  " inside the body, which nothing can touch, left out");
  if (r.overlaps)
    out.push_back("parts that overlap are counted once" +
                  (r.overlap_error > 0
                       ? ", to " + number_text(r.overlap_error, 2) + " of the volume"
                       : std::string()));
  if (r.overlap_unknown)
    out.emplace_back(
        "parts cross each other or themselves in more places than are looked at: what overlaps "
        "there counts more than once, and by how much the mass is off is not known");
  return out;
}

}  // namespace sonde
