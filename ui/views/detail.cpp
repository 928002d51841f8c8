// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/detail.hpp"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "ui/views/simplified.hpp"
#include "ui/views/surface.hpp"

namespace sonde::ui {
namespace {

/// A simplified surface lies a little before or behind the real one. Moved back, it hides nothing
/// that is painted on the body. VTK's unit is 1.6e-5 of the picture's depth.
constexpr double moved_back = 100;

bool ready(const std::future<vtkSmartPointer<vtkPolyData>>& surface) {
  return surface.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

vtkSmartPointer<vtkMapper> mapper_like(vtkMapper& full, vtkPolyData* surface) {
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(surface);
  mapper->SetScalarVisibility(has_colours(*surface));
  double factor = 0, units = 0;
  full.GetRelativeCoincidentTopologyPolygonOffsetParameters(factor, units);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(factor, units + moved_back);
  return mapper;
}

}  // namespace

Detail::Detail() = default;
Detail::~Detail() = default;

void Detail::clear() {
  draw_simplified(false);
  actors_.clear();
  std::erase_if(abandoned_, ready);
  for (Coming& coming : coming_) abandoned_.push_back(std::move(coming.surface));
  coming_.clear();
}

void Detail::add(vtkPolyData& surface, int small, const std::vector<vtkActor*>& actors) {
  if (surface.GetNumberOfPolys() <= small) return;
  surface.ComputeBounds();  // while no other thread reads it
  Coming coming;
  coming.actors.assign(actors.begin(), actors.end());
  coming.surface = std::async(std::launch::async, [kept = vtkSmartPointer<vtkPolyData>(&surface)] {
    return ui::simplified(*kept);
  });
  coming_.push_back(std::move(coming));
}

bool Detail::made() const {
  return std::all_of(coming_.begin(), coming_.end(),
                     [](const Coming& coming) { return ready(coming.surface); });
}

void Detail::take() {
  std::erase_if(coming_, [this](Coming& coming) {
    if (!ready(coming.surface)) return false;
    const vtkSmartPointer<vtkPolyData> surface = coming.surface.get();
    for (const auto& actor : coming.actors) {
      vtkMapper* const full = actor->GetMapper();
      actors_.push_back({actor, full, mapper_like(*full, surface)});
    }
    return true;
  });
}

void Detail::draw_simplified(bool wanted) {
  if (!wanted && !simplified_) return;
  take();
  simplified_ = wanted && !actors_.empty();
  for (const Actor& a : actors_) {
    vtkMapper* const mapper = simplified_ ? a.simple : a.full;
    mapper->SetClippingPlanes(a.actor->GetMapper()->GetClippingPlanes());
    a.actor->SetMapper(mapper);
  }
}

}  // namespace sonde::ui
