// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/background_search.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "engine/base/phase_timer.hpp"
#include "engine/body/body.hpp"
#include "engine/haptics/loop/loop_tuning.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/intersect.hpp"

namespace sonde {
namespace {

/// Limits of the searches, and whether they record where their time went.
struct Extent {
  double microseconds = 0;  ///< of each search; 0: no limit
  int starts_pdt = StaticOptions{}.starts;
  double sure = StaticOptions{}.sure;
  bool time_phases = false;
};

struct Searched {
  FoundSeparation way;
  bool far_out = false;
};

/// Adds the times of phases to `times`; null: they are not recorded.
std::optional<Searched> search(const Pair& pair, const Pose& X_FM, Method method,
                               const Extent& extent, PhaseTimes* times) {
  StaticOptions options;
  options.method = method;
  if (method == Method::pdt) options.starts = extent.starts_pdt;
  options.budget.microseconds = extent.microseconds;
  options.sure = extent.sure;
  options.want_lower_bound = false;
  options.time_phases = times != nullptr;
  const Separation separation = separate_static(pair, X_FM, options);
  if (times) *times += separation.phases;
  if (separation.status == Status::failed) return {};
  return Searched{{separation.depth, separation.separated}, separation.far_out};
}

/// Shares by which a translation is lengthened, tried in turn, since without its turn a contact may
/// overlap a little: at most the gap that an answer may keep.
constexpr double lengthened[] = {0, 1e-6, 1e-4};

/// The translation to that separated pose, if the bodies are apart there without its turn as well.
std::optional<FoundSeparation> without_turn(const Pair& pair, const Pose& X_FM,
                                            const Pose& separated) {
  const Vec3& com = pair.probe().mass.com;
  const Vec3 way = separated * com - X_FM * com;
  for (const double share : lengthened) {
    const Vec3 moved = (1 + share) * way;
    const Pose X_FQ{X_FM.q, X_FM.p + moved};
    if (!overlap(pair.probe(), pair.fixed(), Transform(X_FQ), Doubt::exact))
      return FoundSeparation{moved.norm(), X_FQ};
  }
  return {};
}

void shorten(std::optional<FoundSeparation>& way, const std::optional<FoundSeparation>& other) {
  if (other && (!way || other->depth < way->depth)) way = other;
}

BackgroundResult compute(const Pair& pair, const Pose& X_FM, const std::optional<Pose>& known,
                         const Extent& extent) {
  const auto begin = std::chrono::steady_clock::now();
  BackgroundResult out;
  out.device = X_FM;
  out.budget_us = extent.microseconds;
  out.sure = extent.sure;
  PhaseTimes* const times = extent.time_phases ? &out.phases : nullptr;
  if (const auto straight = search(pair, X_FM, Method::pdt, extent, times)) {
    out.pdt = out.nearest = straight->way;
    out.far_out = straight->far_out;
  }
  if (out.pdt && out.pdt->depth > 0) {
    // This search has other starts and less time, so it may miss PD_t.
    const auto turned = search(pair, X_FM, Method::pdg, extent, times);
    if (turned && turned->way.depth < out.pdt->depth) {
      out.nearest = turned->way;
      out.far_out = turned->far_out;
    }
    // A short search may miss a separating translation that another one has found.
    if (turned) shorten(out.pdt, without_turn(pair, X_FM, turned->way.separated));
    if (known) shorten(out.pdt, without_turn(pair, X_FM, *known));
    shorten(out.nearest, out.pdt);
  }
  if (out.pdt) {
    const PhaseTimer timer(times, Phase::bound);
    if (const auto bound = witnessed_lower_bound(pair.probe(), pair.fixed(), X_FM, {},
                                                 {.known = out.nearest->depth})) {
      out.lower_bound = bound->depth;
      out.witness = bound->witness;
    }
  }
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
  out.time_us = time.count();
  return out;
}

BackgroundResult answer(const Pair& pair, const Pose& X_FM, const std::optional<Pose>& known,
                        double sure, bool time_phases) {
  try {
    return compute(pair, X_FM, known,
                   {.microseconds = loop_tuning.background_us,
                    .starts_pdt = loop_tuning.background_starts_pdt,
                    .sure = sure,
                    .time_phases = time_phases});
  } catch (const std::exception&) {  // out of memory: there is no answer for this pose
    BackgroundResult none;
    none.device = X_FM;
    none.sure = sure;
    return none;
  }
}

bool of_one_pose(const BackgroundResult& search, const Separation& followed) {
  return search.device.p == followed.device.p &&
         search.device.q.coeffs() == followed.device.q.coeffs();
}

}  // namespace

BackgroundResult searched_fully(const Pair& pair, const Pose& X_FM) {
  return compute(pair, X_FM, {}, {});
}

BackgroundResult with_followed(BackgroundResult search, const Separation& followed) {
  const bool known = followed.status == Status::penetrating && of_one_pose(search, followed);
  if (known && (!search.nearest || followed.depth < search.nearest->depth))
    search.nearest = FoundSeparation{followed.depth, followed.separated};
  return search;
}

WayOut way_out(const Separation& followed, const BackgroundResult& search) {
  if (!of_one_pose(search, followed) || !search.nearest || followed.status == Status::failed)
    return WayOut::unknown;
  if (followed.status == Status::separated ||
      search.nearest->depth >= loop_tuning.clearly_nearer * followed.depth)
    return WayOut::nearest;
  return search.nearest->depth > 0 ? WayOut::nearer_blocked : WayOut::free_blocked;
}

const char* words(WayOut way) {
  switch (way) {
    case WayOut::unknown:
    case WayOut::nearest:
      return "";
    case WayOut::nearer_blocked:
      return "There is a nearer way out, but it is blocked from where the probe came.";
    case WayOut::free_blocked:
      return "The probe would be free where the hand is, but the way there is blocked.";
  }
  return "";
}

struct BackgroundSearch::State {
  explicit State(const Pair& bodies) : pair(bodies) {}

  Pair pair;
  std::mutex mutex;  ///< guards the six below
  bool time_phases = false;
  double sure = StaticOptions{}.sure;
  struct Request {
    Pose device;
    std::optional<Pose> known;
  };
  std::optional<Request> wanted;
  std::optional<Request> newest;  ///< requested
  std::optional<BackgroundResult> result;
  bool stopping = false;
  std::condition_variable changed;
  std::thread thread;

  void run();
};

void BackgroundSearch::State::run() {
  std::unique_lock lock(mutex);
  for (;;) {
    changed.wait(lock, [this] { return stopping || wanted; });
    if (stopping) return;
    const Request request = *std::exchange(wanted, std::nullopt);
    const bool timed = time_phases;
    const double share = sure;
    lock.unlock();
    const BackgroundResult found = answer(pair, request.device, request.known, share, timed);
    lock.lock();
    if (found.sure == sure) result = found;
  }
}

BackgroundSearch::BackgroundSearch(const Pair& pair) : state_(std::make_unique<State>(pair)) {
  State& s = *state_;
  s.thread = std::thread([&s] { s.run(); });
}

BackgroundSearch::~BackgroundSearch() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stopping = true;
  }
  state_->changed.notify_one();
  state_->thread.join();
}

void BackgroundSearch::request(const Pose& X_FM, const std::optional<Pose>& known) {
  {
    const std::lock_guard lock(state_->mutex);
    state_->wanted = state_->newest = State::Request{X_FM, known};
  }
  state_->changed.notify_one();
}

void BackgroundSearch::set_time_phases(bool on) {
  const std::lock_guard lock(state_->mutex);
  state_->time_phases = on;
}

void BackgroundSearch::set_sure(double share) {
  {
    const std::lock_guard lock(state_->mutex);
    if (share == state_->sure) return;
    state_->sure = share;
    state_->result.reset();
    state_->wanted = state_->newest;
  }
  state_->changed.notify_one();
}

std::optional<BackgroundResult> BackgroundSearch::latest() {
  const std::lock_guard lock(state_->mutex);
  return state_->result;
}

}  // namespace sonde
