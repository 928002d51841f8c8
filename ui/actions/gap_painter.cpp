// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/gap_painter.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "ui/base/format.hpp"
#include "ui/document/same_pose.hpp"
#include "ui/document/session.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr double reach_part = 0.12;  // of the probe's radius: further away is not near
constexpr double cells = 8;          // over the reach

}  // namespace

GapPainter::GapPainter(Viewport& viewport) : viewport_(viewport) {}

GapPainter::~GapPainter() { stop(); }

void GapPainter::set_on(bool on) {
  on_ = on;
  asked_.reset();
  if (!on) stop();
  viewport_.set_shown(Layer::gaps, on);
}

void GapPainter::set_reach(std::optional<double> reach) {
  stop();
  reach_ = reach;
  asked_.reset();
}

void GapPainter::attach(const Session* session) {
  stop();
  session_ = session;
  asked_.reset();
}

void GapPainter::stop() {
  if (!coming_.valid()) return;
  *stopping_ = true;
  coming_.wait();  // it looks at the flag every few hundred points
  coming_ = {};
}

void GapPainter::frame(const Separation& separation) {
  if (!on_ || !session_ || separation.status == Status::failed) return;
  if (coming_.valid()) take();
  if (coming_.valid() || (asked_ && same(*asked_, separation.separated))) return;
  begin(separation.separated);
}

void GapPainter::take() {
  if (coming_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  const Painted painted = coming_.get();
  viewport_.set_gaps({painted.probe, painted.fixed, painted.separated, painted.reach});
}

void GapPainter::begin(const Pose& separated) {
  asked_ = separated;
  stopping_ = std::make_shared<std::atomic<bool>>(false);
  const double suited = round_down_125(reach_part * session_->probe().mass.radius);
  const double reach = reach_.value_or(suited);
  // Not finer than suits the probe: as many places as there are gaps to be told apart.
  const double cell = std::max(reach, suited) / cells;
  // The pair keeps its bodies for as long as the thread needs them.
  coming_ = std::async(std::launch::async, [pair = session_->loaded().pair, separated, reach, cell,
                                            stopping = stopping_] {
    const auto stop = [stopping] { return stopping->load(); };
    const GapOptions options{.reach = reach, .cell = cell};
    return Painted{separated, gap_field(pair.probe(), pair.fixed(), separated, options, stop),
                   gap_field(pair.fixed(), pair.probe(), inverse(separated), options, stop), reach};
  });
}

}  // namespace sonde::ui
