// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/crossing_finder.hpp"

#include <memory>

#include "engine/base/progress.hpp"
#include "engine/proximity/queries/self_intersections.hpp"
#include "ui/document/session.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

struct Found {
  SelfIntersections probe, fixed;
};

QString text_of(const char* body, const SelfIntersections& found) {
  if (found.triangles.empty()) return QStringLiteral("%1: none").arg(QLatin1String(body));
  return QStringLiteral("%1: %2%3 triangles")
      .arg(QLatin1String(body), QLatin1String(found.all ? "" : "more than "))
      .arg(found.triangles.size());
}

}  // namespace

CrossingFinder::CrossingFinder(Viewport& viewport, QWidget& window)
    : viewport_(viewport), job_(&window) {}

void CrossingFinder::set_on(bool on) {
  on_ = on;
  viewport_.set_shown(Layer::crossings, on);
  if (!on) job_.abandon();
  if (on && session_ && !known_) begin();
}

void CrossingFinder::attach(const Session* session) {
  job_.abandon();
  session_ = session;
  known_ = false;
  viewport_.set_crossings({}, {});
  if (on_ && session_) begin();
}

void CrossingFinder::begin() {
  const auto found = std::make_shared<Found>();
  job_.start(
      QStringLiteral("Looking for triangles that go through others of their mesh"),
      // The pair keeps its bodies for as long as the thread needs them.
      [found, pair = session_->loaded().pair](const Progress& progress) {
        found->probe = self_intersections(pair.probe().soup, part_of(progress, 0, 0.5));
        found->fixed = self_intersections(pair.fixed().soup, part_of(progress, 0.5, 1));
      },
      [this, found](const std::exception_ptr& error) {
        if (error) {
          const QString reason = reason_of(error);
          if (!reason.isEmpty()) emit say(reason);
          emit given_up();
          return;
        }
        known_ = true;
        viewport_.set_crossings(found->probe.triangles, found->fixed.triangles);
        emit say(QStringLiteral("Self-intersections – %1, %2")
                     .arg(text_of("probe", found->probe), text_of("fixed body", found->fixed)));
      });
}

}  // namespace sonde::ui
