// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <QColor>
#include <optional>
#include <vector>

#include "engine/body/body.hpp"
#include "ui/views/seeing.hpp"

class vtkActor;
class vtkRenderer;

namespace sonde::ui {

/// What is cut: a body where it stands, and the colour of its section. Whoever says so keeps it.
struct CutBody {
  const Body* body;
  Pose X_FB;
  QColor colour;
};

/// The sections of bodies that a plane cuts, those of solids filled, in the plane itself: the
/// probe's over the fixed body's, with the outlines of both over these, so that one sees where they
/// overlap.
class SectionView {
 public:
  explicit SectionView(vtkRenderer& renderer);
  ~SectionView();
  SectionView(const SectionView&) = delete;
  SectionView& operator=(const SectionView&) = delete;

  /// What is cut of the fixed body, and of the probe, from now on; nothing: it is not cut.
  void set_fixed(std::vector<CutBody> fixed);
  void set_probe(std::optional<CutBody> probe);
  /// Computes anew what is not of this plane and this pose of the probe.
  void show(const CutPlane& cut, const Pose& device);
  /// Of a theme they keep their colour.
  std::vector<const vtkActor*> actors() const;

 private:
  struct Drawn {
    vtkSmartPointer<vtkActor> faces, lines;
    bool stale = true;
  };
  static Drawn drawn_of(vtkRenderer& renderer, int order);
  static void fill(Drawn& drawn, const std::vector<CutBody>& bodies, const CutPlane& cut);

  vtkSmartPointer<vtkRenderer> renderer_;
  Drawn fixed_, probe_;
  std::vector<CutBody> of_fixed_, of_probe_;
  CutPlane cut_;
};

}  // namespace sonde::ui
