// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QVTKInteractor.h>
#include <QVTKOpenGLNativeWidget.h>
#include <vtkActor.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "engine/penetration/search/pair.hpp"
#include "ui/views/cap_view.hpp"
#include "ui/views/clearance_view.hpp"
#include "ui/views/contact_view.hpp"
#include "ui/views/crossing_view.hpp"
#include "ui/views/cut_view.hpp"
#include "ui/views/defect_view.hpp"
#include "ui/views/detail.hpp"
#include "ui/views/gap_view.hpp"
#include "ui/views/grid_view.hpp"
#include "ui/views/handle_view.hpp"
#include "ui/views/hint_view.hpp"
#include "ui/views/measure_view.hpp"
#include "ui/views/movement.hpp"
#include "ui/views/place_view.hpp"
#include "ui/views/probe_view.hpp"
#include "ui/views/section_view.hpp"
#include "ui/views/separation_view.hpp"
#include "ui/views/stiffness_view.hpp"
#include "ui/views/tone.hpp"
#include "ui/views/trail_view.hpp"
#include "ui/views/viewport.hpp"
#include "ui/views/witness_view.hpp"
#include "ui/views/wrench_view.hpp"

namespace sonde::ui {

/// What a Viewport holds. For its own sources, which see VTK, and not for others.
struct Viewport::Scenery {
  explicit Scenery(Viewport& owner)
      : widget(new QVTKOpenGLNativeWidget(&owner)),
        hints(new HintView(&owner)),
        screw(*above, shapes),
        contacts(*top, shapes),
        clearance(*top, shapes),
        stiffness(*top, shapes),
        wrench(*above, shapes),
        trail(*above),
        handles(*above, shapes),
        cut(*above, shapes),
        measures(*top, shapes),
        witness(*top, shapes),
        place(*top),
        grid(*bodies),
        probe_gaps(*bodies),
        fixed_gaps(*bodies),
        probe_crossings(*bodies, true),
        fixed_crossings(*bodies, false),
        sections(*bodies) {}

  // The overlays have depth buffers of their own: no body hides an arrow, and neither a contact.
  vtkNew<vtkRenderer> bodies;
  vtkNew<vtkRenderer> above;
  vtkNew<vtkRenderer> top;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  QVTKOpenGLNativeWidget* widget;
  HintView* hints;
  GlyphShapes shapes;
  vtkSmartPointer<vtkActor> fixed_actor;
  vtkNew<vtkActor> part_box;  ///< round the chosen part
  std::unique_ptr<ProbeView> probe;
  std::unique_ptr<GhostView> ghost;
  std::unique_ptr<FoundView> nearest, straight;
  SeparationView screw;
  ContactView contacts;
  ClearanceView clearance;
  StiffnessView stiffness;
  WrenchView wrench;
  TrailView trail;
  HandleView handles;
  CutView cut;
  MeasureView measures;
  WitnessView witness;
  PlaceView place;
  GridView grid;
  GapView probe_gaps, fixed_gaps;
  CrossingView probe_crossings, fixed_crossings;
  SectionView sections;
  Tone tone;
  std::unique_ptr<DefectView> defects;
  std::unique_ptr<CapView> caps;
  Detail detail;
  Movement movement;

  // Of the session on show.
  std::optional<Pair> pair;
  vtkSmartPointer<vtkPolyData> probe_surface, fixed_surface;
  std::vector<BodyPart> parts;  ///< of the fixed body; empty where it is one mesh
  PartSurface part_surface;
  std::vector<PartLook> part_looks;
  bool fixed_is_solid = false;  ///< all that is drawn of it
  bool software_drawn = false;
  MassProperties mass;
  LengthUnit unit;
  std::array<QString, 2> descriptions;
  Eigen::AlignedBox3d probe_box, fixed_box;
  Vec3 centre = Vec3::Zero();  ///< of the fixed body
  Quat q_FW = Quat::Identity();
  double radius = 1;  ///< of the fixed body, about centre
  Pose last_device, last_separated;
  std::optional<QSize> picture_size;  ///< while one is drawn for a file
  Seeing seeing;
  double gap_reach = 0;  ///< m, of the gaps on show
  std::array<bool, 19> shown{true,  true, true,  true,  false, false, false, true, false, false,
                             false, true, false, false, false, true,  true,  false};  ///< by Layer

  std::array<std::pair<Layer, Overlay*>, 21> overlays() {
    return {{{Layer::ghost, ghost.get()},
             {Layer::nearest, nearest.get()},
             {Layer::straight, straight.get()},
             {Layer::trail, &trail},
             {Layer::wrench, &wrench},
             {Layer::screw, &screw},
             {Layer::contacts, &contacts},
             {Layer::clearance, &clearance},
             {Layer::stiffness, &stiffness},
             {Layer::handles, &handles},
             {Layer::defects, defects.get()},
             {Layer::gaps, &probe_gaps},
             {Layer::gaps, &fixed_gaps},
             {Layer::crossings, &probe_crossings},
             {Layer::crossings, &fixed_crossings},
             {Layer::cut, &cut},
             {Layer::mended, caps.get()},
             {Layer::mended, &place},
             {Layer::bound, &witness},
             {Layer::grid, &grid},
             {Layer::measures, &measures}}};
  }
};

}  // namespace sonde::ui
