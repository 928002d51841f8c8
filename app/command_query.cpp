// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/accuracy.hpp"
#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/phases.hpp"
#include "app/query_lines.hpp"
#include "app/query_motions.hpp"
#include "app/query_rows.hpp"
#include "app/static_searches.hpp"
#include "app/study_run.hpp"
#include "app/timed.hpp"
#include "engine/base/threads.hpp"
#include "engine/platform/read_stream.hpp"
#include "engine/scene/poses.hpp"
#include "engine/sonde.hpp"
#include "engine/study/parts/study_parts.hpp"
#include "engine/text/output_file.hpp"

namespace sonde::app {
namespace {

struct QueryOptions {
  BodyOptions bodies;
  SolverOptions solver;
  AccuracyOptions accuracy;
  PhaseOptions phases;
  OutputOptions output;
  QueryQuestion question;
  QueryMotions motions;
  std::string poses;
  std::string shard;  ///< "2/8"; empty: all poses
  bool resume = false;
};

void check_motions(const QueryOptions& options) {
  check(options.motions);
  if (!options.motions.any()) return;
  if (options.question.touch || options.solver.coherent() || options.accuracy.turned() ||
      options.accuracy.claim || options.accuracy.sure || options.phases.timed() ||
      options.solver.chosen_method() == Method::pdt)
    throw UsageError(
        "--along, --about and --in-plane are searches of their own: leave out --method, --touch, "
        "--mode coherent, --time, --accuracy, --sure, --claim and --phases");
  const Budget& budget = options.solver.budget;
  if (budget.steps > 0 || (options.motions.exact() &&
                           (budget.microseconds > 0 || options.solver.bound.value_or(false) ||
                            options.question.seeds > 1)))
    throw UsageError(
        "--along and --about are exact and have no bound: leave out --budget-us, --bound and "
        "--seeds; --budget-steps is of none of these motions");
  if (options.solver.bound.value_or(false))
    throw UsageError(
        "--in-plane has the bound of all motions that a search makes: leave out --bound");
}

void check(const QueryOptions& options) {
  check_motions(options);
  const bool coherent = options.solver.coherent();
  const QueryQuestion& question = options.question;
  const SolverOptions& solver = options.solver;
  if (question.sweep && (question.touch || question.clearance || options.motions.any() ||
                         solver.bound || solver.budget.steps > 0 ||
                         solver.budget.microseconds > 0 || solver.chosen_method() == Method::pdt))
    throw UsageError(
        "--sweep is a question of its own: leave out --touch, --clearance, --along, --about, "
        "--in-plane, --method, --bound, --no-bound, --budget-us and --budget-steps");
  if ((question.touch || question.sweep) &&
      (coherent || options.accuracy.turned() || options.accuracy.claim || options.phases.timed() ||
       !question.contacts.empty() || question.seeds > 1 || question.signed_distance))
    throw UsageError(
        std::string(question.sweep ? "--sweep" : "--touch") +
        " does no search: leave out what is for one (--mode coherent, --time, --accuracy, --claim, "
        "--phases, --contacts, --seeds, --signed-distance)");
  if (coherent && (!options.shard.empty() || options.resume || options.question.seeds > 1))
    throw UsageError(
        "--mode coherent follows the poses one after the other: leave out --shard, "
        "--resume and --seeds");
  if (coherent && solver.bound.value_or(false))
    throw UsageError("--mode coherent makes no lower bound: leave out --bound");
  if (options.resume && !options.output.to_file())
    throw UsageError("--resume goes on from the part beside a result: it needs --out");
  if (options.resume && options.phases.timed())
    throw UsageError(
        "--resume knows no phases of the poses that are done: leave out --phases and "
        "--phases-picture");
}

/// What a part or a share must have in common with others of the same run.
std::string run_of(const QueryOptions& options, const Scene& scene, const Pair& pair,
                   const SolverOptions& solver, const std::vector<Pose>& poses,
                   const std::vector<Column>& columns) {
  std::string numbers;
  for (const Pose& X : poses)
    for (const double x : {X.p.x(), X.p.y(), X.p.z(), X.q.w(), X.q.x(), X.q.y(), X.q.z()})
      numbers.append(reinterpret_cast<const char*>(&x), sizeof x);
  nlohmann::ordered_json about{{"inputs", study_inputs(scene, pair)},
                               {"poses", fingerprint(numbers)},
                               {"method", solver.method},
                               {"steps", solver.budget.steps},
                               {"us", solver.budget.microseconds},
                               {"seed", solver.seed},
                               {"seeds", options.question.seeds},
                               {"sure", solver.sure},
                               {"contacts", !options.question.contacts.empty()},
                               {"part_format", 4},
                               {"json", options.output.json}};
  about["bound"] = solver.bound ? (*solver.bound ? "whole" : "none") : "some";
  if (options.motions.any()) about["motions"] = options.motions.numbers();
  for (const Column& column : columns) about["columns"].push_back(column.name);
  return fingerprint(about.dump());
}

/// Answers the poses one by one, by the library's own face (engine/sonde.hpp). What else this
/// command takes from the engine is not in it, since it answers nothing about two bodies: files of
/// poses and scenes, threads, parts of long runs. A search for each pose, or following them in
/// their order.
class QueryAnswers {
 public:
  QueryAnswers(const Pair& pair, const QueryOptions& options, const SolverOptions& solver,
               SearchThreads threads)
      : pair_(pair),
        question_(options.question),
        motions_(options.motions),
        solver_(solver),
        threads_(threads) {
    if (!solver.coherent()) return;
    follower_.emplace(pair, solver.chosen_method());
    follower_->time_phases(solver.time_phases);
  }

  /// The next pose is that to which a motion goes, where that is asked.
  QueryAnswer answer(const Pose& pose, const Pose& next) {
    QueryAnswer out;
    out.of_all_motions = !question_.touch && !motions_.any();
    Separation& found = out.separation;
    out.time_us = timed_us([&] {
      if (question_.sweep) return swept(pose, next, out);
      found = question_.touch ? touched(pose) : follower_ ? followed(pose) : searched(pose);
      if ((question_.clearance || question_.signed_distance) && found.status == Status::separated &&
          !found.clearance)
        found.clearance = distance(pair_, pose);
    });
    return out;
  }

 private:
  static constexpr const char* too_far =
      "not finite, or too far from the origin for the size of the probe";
  Separation touched(const Pose& pose) const {
    Separation out;
    try {
      out.status = touch(pair_, pose) ? Status::penetrating : Status::separated;
    } catch (const InputError&) {
      out.reason = too_far;
    }
    return out;
  }
  void swept(const Pose& from, const Pose& to, QueryAnswer& out) const {
    try {
      out.path = sweep(pair_, from, to);
      out.separation.status = out.path.overlapping ? Status::penetrating : Status::separated;
    } catch (const InputError&) {
      out.separation.reason = too_far;
    }
  }
  Separation followed(const Pose& pose) {
    // A search that failed leaves nothing to follow: search again.
    Separation found = started_ ? follower_->follow(pose, solver_.budget)
                                : follower_->start(pose, solver_.static_options());
    started_ = started_ || found.status != Status::failed;
    return found;
  }
  Separation searched(const Pose& pose) const {
    StaticOptions own = solver_.static_options();
    own.two_threads = threads_.two_for_each;
    Separation best;
    for (std::size_t k = 0; k < question_.seeds; ++k) {
      own.seed = seed_of_pose(solver_.seed + k, pose);
      const Separation found =
          motions_.any() ? separate_within(pair_, pose, motions_, own) : separate(pair_, pose, own);
      best = k == 0 ? found : better(best, found);
      if (found.status == Status::separated) break;
    }
    return best;
  }
  /// The nearer way out, with the work and the bounds of both.
  static Separation better(const Separation& a, const Separation& b) {
    const bool second =
        a.status == Status::failed || (b.status == Status::penetrating && b.depth < a.depth);
    Separation out = second ? b : a;
    out.iterations = a.iterations + b.iterations;
    out.limited = a.limited + b.limited;
    out.lower_bound =
        std::max(a.lower_bound, b.lower_bound);  // the one that is there, or the larger
    return out;
  }

  const Pair& pair_;
  const QueryQuestion& question_;
  const QueryMotions& motions_;
  const SolverOptions& solver_;
  SearchThreads threads_;
  std::optional<Follower> follower_;
  bool started_ = false;
};

/// The poses of a share, and which of them are still to be answered.
struct Share {
  std::vector<std::size_t> indices;
  std::size_t done = 0;  ///< of them, the first
};
Share share_of(const std::string& shard, std::size_t poses) {
  const Shard part = shard.empty() ? Shard{} : shard_of(shard).value();
  Share out;
  for (std::size_t i = part.index; i < poses; i += part.count) out.indices.push_back(i);
  return out;
}

QueryFiles files_of(const QueryOptions& options) {
  const bool parts = options.output.to_file() && !options.solver.coherent();
  return {.result = parts ? options.output.out : "",
          .contacts = options.question.contacts,
          .json = options.output.json,
          .resume = options.resume};
}

void check_files(const QueryOptions& options, const Scene& scene) {
  std::vector<std::filesystem::path> inputs = inputs_of(scene);
  inputs.emplace_back(options.poses);
  check_output(options.output, inputs);
  check_picture(options.phases, options.output, inputs);
  check_beside(options.output, "--contacts", options.question.contacts, inputs);
}

void run(const QueryOptions& options) {
  check(options);
  const Scene scene = scene_of(options.bodies);
  Accuracy accuracy(options.accuracy, options.solver);
  check_files(options, scene);
  const std::vector<Pose> poses =
      read_poses_or_path(options.poses == "-" ? standard_input_name : options.poses);

  ProgressLine progress(options.output.quiet);
  const Pair pair = load_bodies(scene, options.output.quiet, progress);
  SolverOptions solver = accuracy.applied(options.solver, pair);
  solver.time_phases = options.phases.timed();
  const QueryRows unshared(options.question, accuracy, options.phases, nullptr);
  // A motion goes from each pose but the last.
  const std::size_t asked = poses.size() - std::size_t{options.question.sweep && !poses.empty()};
  // With the number of all rows: what is joined is then known to be whole.
  const std::string shard = options.shard + "@" +
                            run_of(options, scene, pair, solver, poses, unshared.columns()) + "-" +
                            std::to_string(asked);
  const char* shown_shard = options.shard.empty() ? nullptr : shard.c_str();
  QueryRows rows(options.question, accuracy, options.phases, shown_shard);

  Share share = share_of(options.shard, asked);
  QueryLines lines(files_of(options), "sonde query " + shard);
  if (const std::string lost = lines.written_over(); !lost.empty() && !options.output.quiet)
    std::cerr << "sonde: " << lost
              << " of an interrupted run is written over: --resume would go on "
              << "from it\n";
  share.done = lines.taken_over(share.indices);
  const std::size_t left = share.indices.size() - share.done;
  // A search for the least of some motions is on one thread.
  const SearchThreads threads = threads_for(left, solver, !options.motions.any());
  QueryAnswers answers(pair, options, solver, threads);
  PhasePicture picture;
  std::set<std::string, std::less<>> names;
  const auto name_of_part = [&](const Vec3& x) {
    return names.emplace(part_at(pair.fixed(), x)).first->c_str();
  };
  run_in_order(
      left, solver.coherent() ? 1 : threads.at_once,
      [&](std::size_t k) {
        const std::size_t index = share.indices[share.done + k];
        return answers.answer(poses[index], poses[std::min(index + 1, poses.size() - 1)]);
      },
      [&](std::size_t k, const QueryAnswer& answer) {
        const std::size_t index = share.indices[share.done + k];
        report_failure(answer.separation, index);
        const std::vector<Row> contacts =
            options.question.contacts.empty()
                ? std::vector<Row>()
                : contact_rows(index, answer.separation, name_of_part, shown_shard);
        lines.add(rows.columns(), rows.row(index, answer, name_of_part), contact_columns(nullptr),
                  contacts);
        if (options.phases.timed()) picture.add(answer.separation, answer.time_us);
        lines.flush_now_and_then();
        progress.show(solver.coherent() ? "following" : "searching", share.done + k + 1,
                      share.indices.size());
      });
  progress.clear();
  if (!options.output.quiet) {
    accuracy.note_unreached();
    rows.note();
  }
  const ResultHead head{rows.columns(), pair.probe().offset.by, remarks_on(pair)};
  const std::string text =
      options.output.json ? json_of(head, lines.lines()) : csv_of(head, lines.lines());
  std::optional<PendingFile> contacts;
  if (!options.question.contacts.empty())
    contacts.emplace(options.question.contacts,
                     csv_of({contact_columns(shown_shard)}, lines.contacts()));
  picture.write_with(options.phases, "searches", options.output, text);
  if (contacts) contacts->commit();
  lines.done();
}

}  // namespace

Command add_query_command(CLI::App& program) {
  const auto options = std::make_shared<QueryOptions>();
  CLI::App* parser = program.add_subcommand(
      "query", "Computes penetration depth and separated pose for each pose of a file");
  add_scene_or_meshes(*parser, options->bodies);
  parser
      ->add_option(
          "--poses", options->poses,
          "CSV px,py,pz,qw,qx,qy,qz: the probe's mesh frame in the fixed body's, metres; a "
          "path, with t before them, is taken too; -: standard input")
      ->required();
  add_flags(*parser, options->question);
  add_flags(*parser, options->motions);
  add_flags(*parser, options->solver, "static");
  add_flags(*parser, options->accuracy);
  add_flags(*parser, options->phases);
  parser
      ->add_option("--shard", options->shard,
                   "I/N: only the I-th of N shares of the poses, each with its index in the whole "
                   "file; sonde merge joins the results")
      ->check(check_shard);
  parser->add_flag("--resume", options->resume,
                   "go on from OUT.part, which a run that was interrupted has left");
  add_flags(*parser, options->output);
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
