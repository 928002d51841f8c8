// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/demo.hpp"

#include <QImage>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "engine/scene/path_hand.hpp"
#include "engine/text/printable.hpp"
#include "ui/base/terminal.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr int step_ms = 4;
constexpr double numbers_seconds = 0.4;  // for them to be written
constexpr double least_lit = 0.01;

/// With no trajectory: from the start straight towards the fixed body's centre, a third of the way
/// past where the two balls round the bodies would meet.
std::vector<TimedPose> path_inwards(const Session& session) {
  const Pose from = session.loaded().start;
  const Vec3 com = from * session.probe().mass.com;
  const Vec3 way = session.fixed().mass.com - com;
  Pose to = from;
  to.p += 0.75 * way;
  return {{0, from}, {1, to}};
}

}  // namespace

double lit_share(const QImage& picture) {
  if (picture.isNull()) return 0;
  const QImage image = picture.convertToFormat(QImage::Format_RGB32);
  std::size_t lit = 0;
  for (int y = 0; y < image.height(); ++y) {
    const auto* line = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    for (int x = 0; x < image.width(); ++x) {
      const int off = std::abs(qRed(line[x]) - qRed(line[0])) +
                      std::abs(qGreen(line[x]) - qGreen(line[0])) +
                      std::abs(qBlue(line[x]) - qBlue(line[0]));
      lit += off > 24;
    }
  }
  return double(lit) / (double(image.width()) * image.height());
}

Demo::Demo(MainWindow& window, std::string picture)
    : window_(window), picture_(std::move(picture)), job_(&window) {
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Demo::step);
}

void Demo::play() {
  path_ = window_.session()->loaded().trajectory;
  if (path_.size() < 2) path_ = path_inwards(*window_.session());
  frames_at_start_ = window_.frames();
  begin(Act::forward);
  timer_.start(step_ms);
}

void Demo::begin(Act act) {
  act_ = act;
  clock_.start();
}

Pose Demo::at(double place) const {
  return pose_at(path_, path_.front().t + place * (path_.back().t - path_.front().t));
}

void Demo::step() {
  const double seconds = double(clock_.elapsed()) / 1000;
  return act_ == Act::forward ? forward(seconds) : rest(seconds);
}

void Demo::forward(double seconds) {
  const double place = std::min(seconds / forward_seconds_, 1.0);
  window_.set_device_pose(at(place));
  if (place < 1) return;
  timer_.stop();
  frames_per_second_ = double(window_.frames() - frames_at_start_) / seconds;
  live_ = window_.shown();
  run_by_tick();
}

void Demo::run_by_tick() {
  run_ = std::make_shared<DemoRun>();
  const LoadedScene& loaded = window_.session()->loaded();
  job_.start(
      QStringLiteral("Looking for the deepest pose of the path"),
      [run = run_, pair = loaded.pair, path = path_, coupling = loaded.coupling](
          const Progress& progress) { *run = run_demo(pair, path, coupling, progress); },
      [this](const std::exception_ptr& error) { show_deepest(error); });
}

void Demo::show_deepest(const std::exception_ptr& error) {
  if (error) {
    const QString reason = reason_of(error);
    tell_terminal(reason.isEmpty() ? "cancelled" : reason.toStdString());
    return end(4);
  }
  window_.show_kept(run_->kept, run_->deepest);
  begin(Act::rest);
  timer_.start(step_ms);
}

void Demo::rest(double seconds) {
  const auto& shown = window_.shown();
  if (!fitted_) {
    if (!shown || shown->time != run_->kept->log().at(run_->kept->log().find(run_->deepest)).time)
      return;
    window_.viewport().fit();  // the path may have begun far away
    fitted_ = true;
    begin(Act::rest);
    return;
  }
  if (seconds < numbers_seconds) return;
  timer_.stop();
  end(finish());
}

void Demo::end(int exit_code) { emit ended(exit_code); }

int Demo::finish() {
  if (!window_.shown() || lit_share(window_.viewport().picture()) < least_lit) {
    tell_terminal("nothing was drawn");
    return 4;
  }
  if (!window_.save_picture(QString::fromStdString(picture_))) return 3;
  const Snapshot& s = *window_.shown();
  std::printf("%s\n", printable(picture_).c_str());
  std::printf("depth held %.4g m (translation %.4g, rotation %.4g), ", s.separation.depth,
              s.separation.translation, s.separation.rotation);
  if (const auto c = window_.searched()) {
    if (c->nearest) std::printf("nearest way out %.4g m, ", c->nearest->depth);
    if (c->pdt) std::printf("PD_t %.4g m, ", c->pdt->depth);
    if (c->lower_bound) std::printf("lower bound %.4g m, ", *c->lower_bound);
  }
  const Snapshot live = live_.value_or(Snapshot{});
  std::printf("|F| %.3g N, |tau| %.3g N·m, tick %.0f us, servo %.0f Hz, %.0f frames/s\n",
              s.wrench.force.norm(), s.wrench.torque.norm(), live.tick_us, live.rate_hz,
              frames_per_second_);
  if (!run_->touches) std::printf("The path never touches: its last pose is shown.\n");
  if (const auto c = window_.searched())
    if (const char* way = words(way_out(s.separation, *c)); *way != 0) std::printf("%s\n", way);
  std::fflush(stdout);
  return 0;
}

}  // namespace sonde::ui
