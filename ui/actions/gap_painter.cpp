// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/gap_painter.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "ui/actions/gap_reach.hpp"
#include "ui/document/same_pose.hpp"
#include "ui/document/session.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
GapPainter::GapPainter(Viewport& viewport) : viewport_(viewport) {}

GapPainter::~GapPainter() { stop(); }

void GapPainter::set_on(bool on) {
  on_ = on;
  fitted_.reset();
  asked_.reset();
  if (!on) stop();
  viewport_.set_shown(Layer::gaps, on);
}

void GapPainter::set_reach(std::optional<double> reach) {
  stop();
  reach_ = reach;
  fitted_.reset();
  asked_.reset();
}

void GapPainter::attach(const Session* session) {
  stop();
  session_ = session;
  fitted_.reset();
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
  fitted_ = painted.reach;
  viewport_.set_gaps({painted.probe, painted.fixed, painted.separated, painted.reach});
}

void GapPainter::begin(const Pose& separated) {
  asked_ = separated;
  stopping_ = std::make_shared<std::atomic<bool>>(false);
  // Once fitted it stays: colours that change their meaning with each frame say nothing.
  const std::optional<double> wanted = reach_ ? reach_ : fitted_;
  // The pair keeps its bodies for as long as the thread needs them.
  coming_ = std::async(std::launch::async, [pair = session_->loaded().pair, separated, wanted,
                                            stopping = stopping_] {
    const auto stop = [stopping] { return stopping->load(); };
    const Body &probe = pair.probe(), &fixed = pair.fixed();
    const double reach = wanted ? *wanted : fitted_reach(probe, fixed, separated, stop);
    const GapOptions options{.reach = reach, .cell = gap_cell(probe, reach)};
    return Painted{separated, gap_field(probe, fixed, separated, options, stop),
                   gap_field(fixed, probe, inverse(separated), options, stop), reach};
  });
}

}  // namespace sonde::ui
