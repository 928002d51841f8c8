// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ui/views/glyphs.hpp"
#include "ui/views/overlay.hpp"

namespace sonde::ui {

/// The clusters of contact that carry the separation: the point on each body, and the normal, which
/// is longer for a larger share.
class ContactView : public Overlay {
 public:
  ContactView(vtkRenderer& renderer, GlyphShapes& shapes);
  /// The marked cluster, with a ring and its number; 0: none.
  void choose(std::uint64_t id) { chosen_ = id; }

 private:
  struct Marker {
    Marker(vtkRenderer& renderer, GlyphShapes& shapes);
    Ball on_probe;
    Ball on_fixed;
    Arrow normal;
  };
  void draw(const Frame& frame) override;
  void hide() override;
  void mark(const Frame& frame, const ContactCluster& cluster);
  Arc ring_;
  std::uint64_t chosen_ = 0;
  std::vector<std::unique_ptr<Marker>> markers_;  ///< ContactSet::capacity of them, made once
};

}  // namespace sonde::ui
