// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/tone.hpp"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkRenderer.h>

#include <algorithm>

#include "ui/base/theme.hpp"

namespace sonde::ui {

void Tone::apply(vtkRenderer& renderer, const QPalette& palette,
                 const std::vector<const vtkActor*>& but) {
  // Of actors that are gone.
  std::erase_if(own_, [](const auto& entry) { return entry.first->GetReferenceCount() == 1; });
  vtkActorCollection& actors = *renderer.GetActors();
  vtkCollectionSimpleIterator at;
  actors.InitTraversal(at);
  while (vtkActor* actor = actors.GetNextActor(at)) {
    if (std::ranges::find(but, actor) != but.end()) continue;
    vtkSmartPointer<vtkProperty> property = actor->GetProperty();
    double rgb[3];
    property->GetColor(rgb);
    const QColor own =
        own_.try_emplace(property, QColor::fromRgbF(rgb[0], rgb[1], rgb[2])).first->second;
    const QColor now = readable(own, palette);
    property->SetColor(now.redF(), now.greenF(), now.blueF());
  }
}

}  // namespace sonde::ui
