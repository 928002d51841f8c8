// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "ui/actions/click_taker.hpp"
#include "ui/document/snap.hpp"

namespace sonde::ui {

class DocumentControl;
class PosePanel;
class Session;
class Viewport;
struct Pick;

/// Lays a face, an edge or the axis of a round face of the probe onto one of the fixed body: asked
/// for in the dock of the pose, by two clicks in the view, in either order.
class SnapControl : public QObject, public ClickTaker {
 public:
  SnapControl(Viewport& viewport, DocumentControl& documents, PosePanel& panel, QObject* parent);

  /// Null: nothing is open. What was begun is given up.
  void attach(Session* session);
  /// None: no click is waited for any more.
  void start(std::optional<SnapKind> kind);
  /// A click in the view; true where one was waited for.
  bool click(QPointF at) override;

 private:
  std::optional<Feature> feature_of(const Pick& hit) const;
  void tell(const QString& what);
  void finish();

  Viewport& viewport_;
  DocumentControl& documents_;
  PosePanel& panel_;
  Session* session_ = nullptr;
  std::optional<SnapKind> kind_;
  /// Of the probe in its mesh frame, of the other in its own; none: to be clicked yet.
  std::optional<Feature> own_, onto_;
};

}  // namespace sonde::ui
