// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/snap_control.hpp"

#include "engine/geometry/round_face.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/document/session.hpp"
#include "ui/panels/pose_panel.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

Feature moved_by(const Pose& X, const Feature& feature) {
  return {X * feature.at, X.q * feature.along};
}

QString name_of(SnapKind kind) {
  if (kind == SnapKind::face) return QStringLiteral("a face");
  return kind == SnapKind::edge ? QStringLiteral("an edge") : QStringLiteral("a round face");
}

}  // namespace

SnapControl::SnapControl(Viewport& viewport, DocumentControl& documents, PosePanel& panel,
                         QObject* parent)
    : QObject(parent), viewport_(viewport), documents_(documents), panel_(panel) {
  connect(&panel_, &PosePanel::snap_wanted, this, &SnapControl::start);
}

void SnapControl::attach(Session* session) {
  session_ = session;
  start({});
}

void SnapControl::start(std::optional<SnapKind> kind) {
  kind_ = session_ ? kind : std::nullopt;
  own_.reset();
  onto_.reset();
  tell(
      kind_
          ? QStringLiteral("Click %1 of the probe, and one of the fixed body.").arg(name_of(*kind_))
          : QString());
}

void SnapControl::tell(const QString& what) { panel_.show_snap(kind_, what); }

/// In the mesh frame of the body that was hit.
std::optional<Feature> SnapControl::feature_of(const Pick& hit) const {
  const Pose X_BF = inverse(viewport_.pose_of(hit.on_probe));
  if (*kind_ == SnapKind::face) return Feature{hit.x, X_BF.q * hit.normal};
  if (*kind_ == SnapKind::edge) {
    if (!(hit.edge.norm() > 0)) return std::nullopt;
    return moved_by(X_BF, {hit.on_edge, hit.edge});
  }
  const Body& body = hit.on_probe ? session_->probe() : session_->fixed();
  const auto& parts = session_->loaded().parts;
  const BodyPart* part = hit.part ? &parts[*hit.part] : nullptr;
  const auto round = round_face((part ? *part->body : body).soup, hit.triangle);
  if (!round) return std::nullopt;
  const Feature axis{round->at, round->along};
  return part ? moved_by(part->X_BP, axis) : axis;
}

bool SnapControl::click(QPointF at) {
  if (!kind_) return false;
  const auto hit = viewport_.pick(at);
  if (!hit) return true;
  const auto feature = feature_of(*hit);
  if (!feature) {
    tell(*kind_ == SnapKind::edge ? QStringLiteral("There is no edge next to that place.")
                                  : QStringLiteral("That face is not round: it has no axis."));
    return true;
  }
  (hit->on_probe ? own_ : onto_) = feature;
  if (own_ && onto_)
    finish();
  else
    tell(QStringLiteral("Now %1 of the %2.")
             .arg(name_of(*kind_), own_ ? QStringLiteral("fixed body") : QStringLiteral("probe")));
  return true;
}

void SnapControl::finish() {
  const Pose here = session_->device_pose();
  const Pose there = snapped(here, *kind_, moved_by(here, *own_), *onto_);
  start({});
  documents_.place(there, QStringLiteral("Snap the probe"));
}

}  // namespace sonde::ui
