// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/session.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "engine/text/number_text.hpp"

namespace sonde::bench {
namespace {

constexpr std::size_t most_repetitions = 200;
constexpr std::size_t least_repetitions = 3;
constexpr std::size_t least_poses = 3;
constexpr std::size_t most_named = 5;  // wrong answers of one row

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// At least three, so that the median of a pose means something, unless that takes far too long.
std::size_t repetitions(double pass_s, double budget_s) {
  const double fit = budget_s / std::max(pass_s, 1e-9);
  const std::size_t least = fit * 10 < least_repetitions ? 1 : least_repetitions;
  return std::clamp(static_cast<std::size_t>(std::min(fit, 1e6)), least, most_repetitions);
}

/// The thread's own time leaves out what the system takes away, but reading it costs some tenths of
/// a microsecond: short calls are timed by the wall clock.
clockid_t clock_for(const Contender& contender, double call_s) {
  return call_s > 20e-6 && !contender.threads ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC;
}

double now_us(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

/// Pose after pose and then again, so that no call has just been made with the same data.
Calls time_calls(const Contender& contender, std::size_t poses, std::size_t times,
                 clockid_t clock) {
  Calls calls(poses);
  for (std::size_t repetition = 0; repetition < times; ++repetition)
    for (std::size_t pose = 0; pose < poses; ++pose) {
      const double start = now_us(clock);
      const Answer answer = contender.ask(pose);
      calls[pose].push_back(now_us(clock) - start);
    }
  return calls;
}

std::string to_text(const Pose& X) {
  std::string out = "position";
  for (const double v : {X.p.x(), X.p.y(), X.p.z()}) out.append(" ").append(number_text(v, 17));
  out += " m, quaternion w x y z";
  for (const double v : {X.q.w(), X.q.x(), X.q.y(), X.q.z()})
    out.append(" ").append(number_text(v, 17));
  return out;
}

std::string trial_name(const Query& query, Place place) {
  std::string name = query.name;
  return name.append(", ").append(bench::name_of(place));
}

/// The median over the poses; no value where the answers have no amount.
std::optional<double> typical_amount(const std::vector<Answer>& answers) {
  std::vector<double> amounts;
  for (const Answer& answer : answers)
    if (answer.amount) amounts.push_back(*answer.amount);
  if (amounts.empty()) return {};
  return median(amounts);
}

LibraryResult& entry(Result& result, const std::string& library) {
  for (LibraryResult& r : result.libraries)
    if (r.library == library) return r;
  result.libraries.push_back({library, {}, 0, 0, 0, {}});
  return result.libraries.back();
}

}  // namespace

std::vector<Job> Session::jobs(const PairSpec& pair) const {
  const std::vector<PeerLibrary> installed = installed_peers();
  const auto present = [&](const std::string& library) {
    return library.rfind(ours, 0) == 0 ||
           std::any_of(installed.begin(), installed.end(),
                       [&](const PeerLibrary& l) { return library.rfind(l.name, 0) == 0; });
  };
  std::vector<Job> out;
  for (std::size_t q = 0; q < queries_.size(); ++q)
    for (const Place place : queries_[q].places) {
      if (count_of(pair, place) == 0) continue;
      out.push_back({pair, q, place, ours});
      for (const std::string& other : queries_[q].others)
        if (present(other)) out.push_back({pair, q, place, other});
    }
  return out;
}

std::string Session::name_of(const Job& job) const {
  std::string name = queries_[job.query].name + "/" + bench::name_of(job.place) + "/" +
                     job.pair.name + "/" + job.library;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

const LibraryResult* Session::run(const Job& job) {
  try {
    prepare(job);
  } catch (const std::exception& error) {
    trial_ = {};
    failures_.push_back(name_of(job) + ": " + error.what());
    return nullptr;
  }
  if (trial_.wrong > 0) return nullptr;
  for (std::size_t i = 0; i < trial_.contenders.size(); ++i) {
    const Contender& contender = trial_.contenders[i];
    if (contender.library != job.library || !contender.timed) continue;
    LibraryResult& out = entry(results_[trial_.result], job.library);
    const std::size_t poses = trial_.answers[i].size();
    const double pass_s = trial_.pass_s[i];
    out.calls = time_calls(contender, poses, repetitions(pass_s, options_.budget_s),
                           clock_for(contender, pass_s / static_cast<double>(poses)));
    return &out;
  }
  return nullptr;
}

void Session::prepare(const Job& job) {
  if (!stage_ || stage_->spec.name != job.pair.name) {
    trial_ = {};
    stage_.reset();  // before the next is loaded: they can be large
    stage_ = set_stage(job.pair, options_.seed);
  }
  if (trial_.name != trial_name(queries_[job.query], job.place)) begin_trial(job);
}

void Session::begin_trial(const Job& job) {
  const Query& query = queries_[job.query];
  trial_ = {};
  trial_.name = trial_name(query, job.place);
  trial_.place = job.place;
  trial_.contenders = query.contenders(*stage_, job.place);
  for (const Contender& contender : trial_.contenders)
    examine(contender, static_cast<std::size_t>(count_of(job.pair, job.place)));
  trial_.result = results_.size();
  const std::size_t a = stage_->a->soup.triangles.size(), b = stage_->b->soup.triangles.size();
  results_.push_back({query.name,
                      job.pair.name,
                      bench::name_of(job.place),
                      a,
                      b,
                      job.pair.scale,
                      query.amount_name,
                      {}});
  for (std::size_t i = 0; i < trial_.contenders.size(); ++i) compare(query, i);
  if (trial_.wrong > 0) results_.pop_back();
}

void Session::examine(const Contender& contender, std::size_t poses) {
  const auto& ask = contender.examine ? contender.examine : contender.ask;
  std::vector<Answer> answers;
  const Clock::time_point start = Clock::now();
  for (std::size_t pose = 0; pose < poses; ++pose) {
    answers.push_back(ask(pose));
    if (answers.size() >= least_poses && seconds_since(start) > options_.patience_s) break;
  }
  trial_.pass_s.push_back(seconds_since(start));
  trial_.answers.push_back(std::move(answers));
}

void Session::compare(const Query& query, std::size_t contender) {
  const Contender& who = trial_.contenders[contender];
  const std::vector<Answer>& answers = trial_.answers[contender];
  const std::vector<Answer>& our_answers = trial_.answers.front();
  const Judge judge_one = query.judge ? query.judge : judge_answers;
  LibraryResult tally;
  for (std::size_t pose = 0; pose < std::min(answers.size(), our_answers.size()); ++pose) {
    const Verdict verdict =
        judge_one(*stage_, trial_.place, pose, our_answers[pose], who, answers[pose]);
    ++tally.compared;
    tally.excused += verdict == Verdict::excused;
    tally.missed += verdict == Verdict::missed;
    if (verdict == Verdict::wrong) fail(who, pose, our_answers[pose], answers[pose]);
  }
  if (!who.timed) return;
  LibraryResult& out = entry(results_[trial_.result], who.library);
  out.compared = tally.compared;
  out.excused = tally.excused;
  out.missed = tally.missed;
  out.amount = typical_amount(answers);
}

void Session::fail(const Contender& contender, std::size_t pose, const Answer& our_answer,
                   const Answer& theirs) {
  if (++trial_.wrong > most_named) return;
  const Pose& X = trial_.place == Place::trip   ? stage_->poses.trips[pose].from
                  : trial_.place == Place::none ? stage_->poses.lead_in
                                                : stage_->pose(trial_.place, pose);
  failures_.push_back(trial_.name + ", pair " + stage_->spec.name + ", pose " +
                      std::to_string(pose) + " (" + to_text(X) + "): " + ours + " " +
                      bench::to_text(our_answer) + "; " + contender.library + " " +
                      bench::to_text(theirs));
}

}  // namespace sonde::bench
