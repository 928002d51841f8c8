// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/way_in_control.hpp"

#include <QMainWindow>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <thread>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/body/body.hpp"
#include "engine/queries/body_queries.hpp"
#include "engine/text/number_text.hpp"
#include "ui/base/format.hpp"
#include "ui/document/same_pose.hpp"
#include "ui/document/session.hpp"
#include "ui/panels/way_in_panel.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr double to_degrees = 180 / std::numbers::pi;
constexpr int step_ms = 30;
constexpr double play_seconds = 4, seek_seconds = 0.4;  // for all of the way
constexpr double most_steps = 1e5, most_across = 501;
constexpr double seen_about = 0.1;  // of the probe's radius: what is seen around the first contact

/// A number of things, as it was typed.
std::size_t count_of(double typed, const char* what, double most) {
  if (typed >= 1 && typed <= most && typed == std::floor(typed))
    return static_cast<std::size_t>(typed);
  throw InputError(std::string("“") + what + "” takes a whole number from 1 to " +
                   number_text(most, 15));
}

double room_of(const InsertionStep& step) {
  if (!step.clearance.overlapping) return step.clearance.distance;
  return step.held.status == Status::failed ? 0 : -step.held.depth;
}

/// The part of a body there; of one mesh its short name.
QString part_text(const Body& body, const Vec3& x) {
  return body.parts.empty() ? short_name(body) : text(std::string(part_at(body, x)));
}

TravelCurves curves_of(const Insertion& found) {
  TravelCurves curves;
  for (const InsertionStep& step : found.steps) {
    curves.travel.push_back(step.travel);
    curves.room.push_back(room_of(step));
    curves.force.push_back(step.wrench.force.norm());
  }
  if (found.first) curves.first = found.first->travel;
  return curves;
}

}  // namespace

/// What the thread is given, and what it makes of that.
struct WayInControl::Work {
  Pair pair;
  WayWanted wanted;
  Pose start;
  std::vector<TimedPose> path;
  Coupling coupling;
  InsertionPath way = {};
  Insertion found = {};

  void run(const Progress& progress) {
    const std::size_t steps = count_of(wanted.steps, "steps", most_steps);
    std::vector<Pose> poses;
    for (const TimedPose& at : path) poses.push_back(at.pose);
    way = wanted.along_path ? way_through(pair, poses)
                            : way_along(pair, start, wanted.axis, wanted.travel, wanted.twist);
    found = insertion(pair, way, steps, coupling, progress);
  }
};

/// The same of the map.
struct WayInControl::MapWork {
  Pair pair;
  WayWanted wanted;
  MapWanted range;
  Pose start;
  InsertionPath way = {};
  OffsetMap map = {};

  void run(const Progress& progress) {
    way = way_along(pair, start, wanted.axis, wanted.travel, wanted.twist);
    map.wanted = way.travel.back();
    map.at.axis = wanted.axis.stableNormalized();
    map.at.lateral = lateral();
    map.at.largest_offset = range.offset;
    map.at.largest_tilt = range.tilt;
    map.at.offsets = map.at.tilts = count_of(range.across, "of each", most_across);
    const unsigned threads =
        std::max(2u, std::thread::hardware_concurrency()) - 1;  // but the loop's
    map.free = free_travels(pair, way, map.at, threads, progress);
  }

  Vec3 lateral() const {
    if (!range.lateral) return lateral_to(map.at.axis);
    if (const auto square = square_to(map.at.axis, *range.lateral)) return *square;
    throw InputError("aside of the axis takes three numbers that do not lie along it");
  }
};

WayInControl::WayInControl(Viewport& viewport, QMainWindow& window, QDockWidget& beside)
    : QObject(&window),
      viewport_(viewport),
      panel_(new WayInPanel(&window)),
      job_(&window),
      map_job_(&window),
      flight_(viewport, this) {
  window.addDockWidget(window.dockWidgetArea(&beside), panel_);
  connect(panel_, &WayInPanel::compute_wanted, this, &WayInControl::compute);
  connect(panel_, &WayInPanel::stop_wanted, this, &WayInControl::stop);
  connect(panel_, &WayInPanel::first_wanted, this, &WayInControl::to_first_contact);
  connect(panel_, &WayInPanel::play_wanted, this, &WayInControl::play);
  connect(panel_, &WayInPanel::sought, this, &WayInControl::seek);
  connect(panel_, &WayInPanel::pick_wanted, this, &WayInControl::pick);
  connect(panel_, &WayInPanel::map_asked, this, &WayInControl::compute_map);
  connect(panel_, &WayInPanel::map_stop_wanted, &map_job_, &Job::cancel);
  connect(panel_, &WayInPanel::map_place_wanted, this, &WayInControl::to_map_place);
  for (Job* job : {&job_, &map_job_}) job->stay_back();
  connect(&job_, &Job::progressed, panel_, &WayInPanel::show_progress);
  connect(&map_job_, &Job::progressed, panel_, &WayInPanel::show_map_progress);
  steps_.setInterval(step_ms);
  connect(&steps_, &QTimer::timeout, this, &WayInControl::step_on);
}

void WayInControl::attach(Session* session, bool same_document) {
  session_ = session;
  job_.abandon();
  flight_.stop();
  play(false);
  pick(WayPick::nothing);
  found_.reset();
  sent_.reset();
  panel_->show_progress({});
  map_job_.abandon();
  map_ = {};
  panel_->show_map_progress({});
  panel_->show_map({}, {});
  if (session && !same_document)
    panel_->take(session->probe().mass.radius, !session->loaded().trajectory.empty());
  else
    panel_->show_result({}, {});
}

void WayInControl::compute() {
  if (!session_) return;
  play(false);
  found_.reset();
  const LoadedScene& loaded = session_->loaded();
  const auto work =
      std::make_shared<Work>(Work{loaded.pair, panel_->wanted(), session_->device_pose(),
                                  loaded.trajectory, session_->coupling()});
  panel_->show_reason({});
  panel_->show_progress(0);
  job_.start(
      QStringLiteral("The way in"), [work](const Progress& progress) { work->run(progress); },
      [this, work](const std::exception_ptr& error) {
        panel_->show_progress({});
        if (!error) return take(*work);
        const QString reason = reason_of(error);
        panel_->show_reason(reason.isEmpty() ? QStringLiteral("Stopped.") : reason);
      });
}

void WayInControl::take(Work& work) {
  way_ = std::move(work.way);
  found_ = std::move(work.found);
  at_ = 0;
  sent_.reset();
  panel_->show_result(summary(), curves_of(*found_));
}

void WayInControl::compute_map() {
  if (!session_) return;
  const auto work = std::make_shared<MapWork>(MapWork{
      session_->loaded().pair, panel_->wanted(), panel_->map_wanted(), session_->device_pose()});
  map_ = {};
  panel_->show_map({}, {});
  panel_->show_map_progress(0);
  map_job_.start(
      QStringLiteral("What goes in"), [work](const Progress& progress) { work->run(progress); },
      [this, work](const std::exception_ptr& error) {
        panel_->show_map_progress({});
        if (!error) return take_map(*work);
        const QString reason = reason_of(error);
        panel_->show_map(reason.isEmpty() ? QStringLiteral("Stopped.") : reason, {});
      });
}

void WayInControl::take_map(MapWork& work) {
  map_way_ = std::move(work.way);
  map_ = std::move(work.map);
  panel_->show_map(words_of_map(), map_);
}

QString WayInControl::words_of_map() const {
  const auto in =
      std::ranges::count_if(map_.free, [this](double free) { return free >= map_.wanted; });
  const Vec3& side = map_.at.lateral;
  return QStringLiteral("%1 of %2 go in. Offsets are along (%3, %4, %5).")
      .arg(in)
      .arg(map_.free.size())
      .arg(number(side.x()), number(side.y()), number(side.z()));
}

void WayInControl::to_map_place(const MapPlace& place) {
  if (!session_ || map_.free.empty()) return;
  play(false);
  const double offset = map_.at.offset(place.offset), tilt = map_.at.tilt(place.tilt);
  const double free = map_.free[place.offset * map_.at.tilts + place.tilt];
  const InsertionPath way = moved(map_way_, session_->loaded().pair, map_.at, offset, tilt);
  sent_.reset();
  emit place_wanted(way.poses.front());
  const LengthUnit unit(session_->probe().mass.radius);
  const QString how = free < 0              ? QStringLiteral("overlaps where it begins")
                      : free >= map_.wanted ? QStringLiteral("goes in")
                                            : QStringLiteral("binds at %1").arg(unit.text(free));
  panel_->show_map_place(place, QStringLiteral("Offset %1, tilt %2°: %3.")
                                    .arg(unit.text(offset), number(tilt * to_degrees), how));
}

/// In a sentence: whether it goes in, and what holds it back.
QString WayInControl::summary() const {
  const LengthUnit unit(session_->probe().mass.radius);
  const auto& steps = found_->steps;
  if (!found_->first) {
    const LeastRoom& least = found_->room;
    QString words = QStringLiteral("It goes in: all %1 are free. The least room is %2, at %3.")
                        .arg(unit.text(way_.travel.back()), unit.text(least.clearance),
                             unit.text(least.travel));
    if (!least.complete)
      words += QStringLiteral(
                   " The search for it ended at its limit of work after %1: beyond, only the steps "
                   "count.")
                   .arg(unit.text(least.searched));
    return words;
  }
  const FirstContact& first = *found_->first;
  double depth = 0, force = 0;
  for (const InsertionStep& step : steps) {
    if (step.held.status == Status::penetrating) depth = std::max(depth, step.held.depth);
    force = std::max(force, step.wrench.force.norm());
  }
  const QString part = part_text(session_->fixed(), first.contact.on_fixed);
  return QStringLiteral(
             "It binds at %1 of %2, on %3. Beyond, it is held back by up to %4, with %5 N by the "
             "gains of now, without limits.")
      .arg(unit.text(first.travel), unit.text(way_.travel.back()), part, unit.text(depth),
           number(force));
}

/// The computed place that is nearest: between two of them nothing is known.
const InsertionStep& WayInControl::step_nearest(double travel) const {
  const auto& steps = found_->steps;
  const auto next = std::ranges::lower_bound(steps, travel, {}, &InsertionStep::travel);
  if (next == steps.end()) return steps.back();
  if (next == steps.begin()) return *next;
  return next->travel - travel <= travel - std::prev(next)->travel ? *next : *std::prev(next);
}

QString WayInControl::words_at(double travel) const {
  const LengthUnit unit(session_->probe().mass.radius);
  const InsertionStep& step = step_nearest(travel);
  const double room = room_of(step);
  return QStringLiteral("Step at %1: %2 %3, %4 N")
      .arg(unit.text(step.travel), unit.text(std::abs(room)),
           room < 0 ? QStringLiteral("deep") : QStringLiteral("of room"),
           number(step.wrench.force.norm()));
}

/// The hand moves along the way, and the loop follows it: what holds the probe there is what the
/// curves are about. Where it has been elsewhere meanwhile the probe begins at the beginning.
void WayInControl::go_to(double travel, double seconds) {
  if (!session_ || !found_) return;
  goal_ = std::clamp(travel, 0.0, way_.travel.back());
  pace_ = way_.travel.back() * step_ms / (1000 * seconds);
  if (!sent_ || !same(session_->device_pose(), *sent_)) {
    at_ = 0;
    emit place_wanted(pose_at(way_, session_->loaded().pair, at_));
  }
  steps_.start();
  step_on();
}

void WayInControl::seek(double travel) {
  playing_ = false;
  panel_->show_playing(false);
  if (!found_) return;
  // At a place that was computed, what is said of it is what the Readout measures there.
  const bool first = found_->first && travel == found_->first->travel;
  go_to(first ? travel : step_nearest(travel).travel, seek_seconds);
}

void WayInControl::play(bool on) {
  playing_ = on && found_;
  panel_->show_playing(playing_);
  if (!playing_) return steps_.stop();
  if (at_ >= way_.travel.back()) sent_.reset();  // once more from the beginning
  go_to(way_.travel.back(), play_seconds);
}

void WayInControl::step_on() {
  at_ += std::clamp(goal_ - at_, -pace_, pace_);
  emit follow_wanted(pose_at(way_, session_->loaded().pair, at_));
  sent_ = session_->device_pose();
  panel_->show_at(at_, words_at(at_));
  if (at_ != goal_) return;
  steps_.stop();
  playing_ = false;
  panel_->show_playing(false);
}

void WayInControl::to_first_contact() {
  if (!found_ || !found_->first) return;
  const FirstContact& first = *found_->first;
  seek(first.travel);
  PointedPlace place;
  place.at = first.contact.on_fixed;
  place.size = seen_about * session_->probe().mass.radius;
  place.text = QStringLiteral("binds at %1")
                   .arg(LengthUnit(session_->probe().mass.radius).text(first.travel));
  flight_.show(place);
}

void WayInControl::pick(WayPick what) {
  picking_ = what;
  panel_->show_picking(what);
}

bool WayInControl::click(QPointF at) {
  if (picking_ == WayPick::nothing) return false;
  const auto hit = viewport_.pick(at);
  if (!hit) return true;
  const bool face = picking_ == WayPick::axis_face || picking_ == WayPick::side_face;
  const bool side = picking_ == WayPick::side_face || picking_ == WayPick::side_edge;
  const Vec3 found = face ? Vec3(-hit->normal) : hit->edge;
  pick(WayPick::nothing);
  if (!(found.norm() > 0))
    panel_->show_reason(QStringLiteral("There is no edge next to that place."));
  else
    side ? panel_->show_side(found) : panel_->show_axis(found);
  return true;
}

}  // namespace sonde::ui
