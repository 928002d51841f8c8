// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <atomic>
#include <future>
#include <memory>
#include <optional>

#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/queries/gap_field.hpp"

namespace sonde::ui {

class Session;
class Viewport;

/// Paints the gaps between the separated probe and the fixed body on both, where they are near each
/// other. A thread of its own computes them, for the newest pose each time it has finished the
/// last.
class GapPainter {
 public:
  explicit GapPainter(Viewport& viewport);
  ~GapPainter();
  GapPainter(const GapPainter&) = delete;
  GapPainter& operator=(const GapPainter&) = delete;

  void set_on(bool on);
  bool on() const { return on_; }
  /// The gap that the last colour stands for, m; none: what fits the gaps at the next frame, and
  /// then stays until the colours are switched on again.
  void set_reach(std::optional<double> reach);
  /// Other bodies from now on; null: none.
  void attach(const Session* session);
  /// To be called with every frame.
  void frame(const Separation& separation);

 private:
  struct Painted {
    Pose separated;
    GapField probe, fixed;
    double reach = 0;
  };
  void stop();
  void begin(const Pose& separated);
  void take();

  Viewport& viewport_;
  const Session* session_ = nullptr;
  bool on_ = false;
  std::optional<double> reach_, fitted_;
  std::shared_ptr<std::atomic<bool>> stopping_;
  std::future<Painted> coming_;
  std::optional<Pose> asked_;
};

}  // namespace sonde::ui
