// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/nudge_control.hpp"

#include "ui/document/loaded_scene.hpp"
#include "ui/panels/pose_panel.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {

NudgeControl::NudgeControl(Viewport& viewport, PosePanel& panel, QObject* parent)
    : QObject(parent), viewport_(viewport), panel_(panel) {}

void NudgeControl::attach(const LoadedScene& loaded) {
  parts_.clear();
  for (const BodyPart& part : loaded.parts) parts_ << QString::fromStdString(part.name);
  panel_.show_face({});
  panel_.set_scene_axes(loaded.scene.fixed.pose.q.conjugate());
}

void NudgeControl::click(QPointF at) {
  const auto hit = viewport_.pick(at);
  if (!hit) return;
  const QString body =
      hit->on_probe ? QStringLiteral("the probe") : QStringLiteral("the fixed body");
  const Quat q_BF = viewport_.pose_of(hit->on_probe).q.conjugate();
  panel_.show_face(PickedFace{hit->part ? parts_.value(static_cast<int>(*hit->part), body) : body,
                              hit->on_probe, q_BF * hit->normal});
}

}  // namespace sonde::ui
