// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/search_control.hpp"

#include <algorithm>
#include <array>

#include "ui/actions/history_control.hpp"
#include "ui/document/session.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {

bool SearchControl::is_drawn() const {
  constexpr std::array layers{Layer::nearest, Layer::straight, Layer::bound};
  return std::ranges::any_of(layers, [this](Layer each) { return view_.shown(each); });
}

void SearchControl::frame(Session& session, const Separation& followed, qint64 now, bool wanted) {
  if (session.paused()) return;
  if (!wanted) return end(session);
  const Pose& device = followed.device;
  if (const auto result = session.searched(); result && schedule_.takes(*result, device)) {
    const auto& before = newest();
    if (is_drawn() && !(before && same_pose(before->device, result->device))) view_.invalidate();
    schedule_.answered(*result);
    history_.add(with_followed(*result, followed));
  }
  if (!schedule_.asks(device, now)) return;
  const bool held = followed.status == Status::penetrating;
  session.ask_search(device, held ? std::optional(followed.separated) : std::nullopt);
}

/// What was found last is of another pose by the time it is wanted again.
void SearchControl::end(Session& session) {
  if (newest()) {
    BackgroundResult nothing;
    nothing.device = newest()->device;
    history_.add(nothing);
  }
  if (const auto result = session.searched()) schedule_.pass_over(*result);
}

}  // namespace sonde::ui
