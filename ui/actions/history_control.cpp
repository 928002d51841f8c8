// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/history_control.hpp"

#include <vtkPolyData.h>

#include <QFileInfo>
#include <QTime>
#include <utility>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/base/progress.hpp"
#include "engine/recording/loop_run.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/meshes_dialog.hpp"
#include "ui/actions/opener.hpp"
#include "ui/base/absolute_path.hpp"
#include "ui/document/paths_asked_for.hpp"

namespace sonde::ui {
namespace {

constexpr qint64 state_ms = 60;  // faster than that nobody reads
constexpr int ending_ms = 15;    // a recording is closed within that, but on a slow disk

/// What a run with other gains is made of.
struct Order {
  Pair pair;
  TickBlocks ticks;
  Budget budget;
  Method method = Method::pdg;
  std::optional<Coupling> gains;
};

void run(const Order& order, KeptTicks& into, const Progress& progress) {
  constexpr double reading = 0.05;
  const double radius = order.pair.probe().mass.radius;
  std::vector<LoopStep> steps = steps_of(order.ticks.log(), part_of(progress, 0, reading));
  if (order.gains)
    for (LoopStep& step : steps) step.coupling = *order.gains;
  into.ticks = std::make_unique<TickLog>(radius, order.ticks.rate_hz);
  into.ticks->along_path = order.ticks.along_path;
  into.curves = Curves(0, longest_line(*into.ticks));
  LoopRun loop{.budget = order.budget, .search = {}, .rate_hz = order.ticks.rate_hz};
  loop.search.method = order.method;
  std::size_t done = 0;
  run_loop(order.pair, steps, loop, [&](const Snapshot& tick) {
    into.ticks->add(tick);
    into.curves.add(tick, tick.time, nullptr);
    if (++done % TickLog::block_ticks == 0)
      report(progress, reading + (1 - reading) * double(done) / double(steps.size()));
  });
  into.ticks->seal();
}

}  // namespace

HistoryControl::HistoryControl(Opener& opener, Prompts& prompts, DocumentControl& documents,
                               QWidget& window)
    : QObject(&window),
      opener_(opener),
      prompts_(prompts),
      documents_(documents),
      timeline_(new TimelinePanel(&window)),
      plots_(new PlotsPanel(&window)),
      job_(&window) {
  connect(timeline_, &TimelinePanel::sought, this, &HistoryControl::look_at);
  connect(timeline_, &TimelinePanel::stepped, this, &HistoryControl::step);
  connect(timeline_, &TimelinePanel::played, this, &HistoryControl::play);
  connect(timeline_, &TimelinePanel::looped, this, [this](bool on) { playback_.set_loop(on); });
  connect(timeline_, &TimelinePanel::recorded, this, &HistoryControl::set_recording);
  connect(timeline_, &TimelinePanel::replay_shown, this, &HistoryControl::show_replay);
  connect(timeline_, &TimelinePanel::speed_changed, this,
          [this](double speed) { playback_.set_speed(speed); });
  connect(timeline_, &TimelinePanel::live_wanted, this, &HistoryControl::go_live);
  connect(plots_, &PlotsPanel::sought, this, &HistoryControl::look_at);
  connect(&ending_timer_, &QTimer::timeout, this, &HistoryControl::report_ended);
}

HistoryControl::~HistoryControl() = default;

void HistoryControl::attach(Session* session) {
  session_ = session;
  stop_recording();
  if (job_.running()) emit say(QStringLiteral("Running it again: given up, for what was opened"));
  job_.abandon();
  leave();
  plots_->forget();
  opened_.reset();
  replay_.reset();
  second_.reset();
  shows_replay_ = false;
  if (session) {
    const double radius = session->probe().mass.radius;
    recorder_.begin(radius, session->loaded().servo.rate_hz);
    plots_->take(LengthUnit(radius));
  }
  show_state();
}

const TickLog* HistoryControl::kept() const {
  return opened_ ? &opened_->log() : recorder_.ticks();
}

/// Null where there is nothing to plot.
const Curves* HistoryControl::curves() const {
  const Curves& all = opened_ ? opened_->curves : recorder_.curves();
  return all.size() > 0 ? &all : nullptr;
}

PlotState HistoryControl::course() const {
  if (!looking_back()) return {.kept = &recorder_.curves(), .time = recorder_.curves().last_time()};
  return {.kept = shows_replay_ && replay_ ? &replay_->curves : curves(), .time = playback_.time()};
}

void HistoryControl::frame(qint64 now) {
  const double seconds = 1e-3 * static_cast<double>(now - std::exchange(last_frame_, now));
  try_to([&] { playback_.advance(seconds); });
  if (!recorder_.failure().isEmpty()) stop_recording();
  if (kept())
    plots_->show_state({.kept = curves(),
                        .replay = replay_ ? &replay_->curves : nullptr,
                        .second = second_ ? &second_->curves : nullptr,
                        .time = looking_back() ? playback_.time() : kept()->last_time()},
                       now);
  if (now < state_due_) return;
  state_due_ = now + state_ms;
  show_state();
}

std::optional<Instant> HistoryControl::instant() {
  std::optional<Instant> now;
  if (looking_back()) try_to([&] { now = playback_.instant(); });
  return now;
}

/// A recording is read as it is looked at, and may have been changed since it was opened.
void HistoryControl::try_to(const std::function<void()>& look) {
  try {
    look();
  } catch (const InputError& bad) {
    go_live();
    prompts_.report_error(QString::fromUtf8(bad.what()));
  }
}

void HistoryControl::begin_looking() {
  if (looking_back() || !kept() || !session_) return;
  paused_before_ = session_->paused();
  emit pause_wanted(true);
  playback_.look_at(shows_replay_ && replay_ ? &replay_->log() : kept());
}

void HistoryControl::look_at(double time) {
  try_to([&] {
    begin_looking();
    playback_.seek(time);
  });
  show_state();
}

void HistoryControl::step(int ticks) {
  try_to([&] {
    begin_looking();
    playback_.step(ticks);
  });
  show_state();
}

void HistoryControl::play(bool on) {
  try_to([&] {
    begin_looking();
    playback_.play(on);
  });
  show_state();
}

void HistoryControl::show_replay(bool on) {
  shows_replay_ = on && replay_;
  try_to([&] {
    begin_looking();
    const double time = playback_.time();
    playback_.look_at(shows_replay_ ? &replay_->log() : kept());
    playback_.seek(time);
  });
  show_state();
}

void HistoryControl::go_live() {
  if (!looking_back()) return;
  leave();
  emit pause_wanted(paused_before_);
  show_state();
}

void HistoryControl::set_recording(bool on) {
  if (!on) return stop_recording();
  const QString file = session_ ? prompts_.ask_record() : QString();
  if (!file.isEmpty()) record(file);
  show_state();
}

/// Throws InputError where the file is looked at or shown now.
void HistoryControl::check_not_in_use(const std::filesystem::path& file) const {
  const Scene scene = documents_.document().content().scene;
  std::vector<std::filesystem::path> used{scene.file, scene.probe.mesh, scene.fixed.mesh};
  if (opened_ && opened_->recording) used.push_back(opened_->recording->file);
  for (const std::filesystem::path& each : used) {
    std::error_code none;
    if (std::filesystem::equivalent(file, each, none))
      throw InputError(file.string() + ": the window shows this file; record to another one");
  }
}

void HistoryControl::record(const QString& file) {
  if (!session_) return;
  try {
    check_not_in_use(absolute_path(file));
    remember_folder_of(file);
    recorder_.record(absolute_path(file), documents_.document().content().scene,
                     session_->loaded().marks);
    const TickLog& kept = *recorder_.ticks();
    recording_since_ = QStringLiteral("%1, with the %2 s before")
                           .arg(QTime::currentTime().toString(QStringLiteral("hh:mm:ss")))
                           .arg(kept.last_time() - kept.first_time(), 0, 'f', 1);
    agree_to_paths_of(documents_.document().content().scene,
                      absolute_path(file));  // the user's own
    emit say(QStringLiteral("Recording to %1").arg(file));
  } catch (const InputError& bad) {
    prompts_.report_error(QString::fromUtf8(bad.what()));
  }
  show_state();
}

void HistoryControl::stop_recording() {
  if (!recorder_.recording()) return;
  recorder_.stop();
  ending_timer_.start(ending_ms);
  show_state();
}

void HistoryControl::report_ended() {
  while (const std::optional<Recorder::Ended> ended = recorder_.ended())
    if (ended->failure.isEmpty())
      emit say(QStringLiteral("Recorded %1").arg(QString::fromStdString(ended->file.string())));
    else
      prompts_.report_error(ended->failure);
  if (!recorder_.ending()) ending_timer_.stop();
}

void HistoryControl::ask_recording() {
  const QString file = prompts_.ask_recording();
  if (file.isEmpty()) return;
  remember_folder_of(file);
  open_recording(file);
}

void HistoryControl::open_recording(const QString& file) {
  if (!documents_.may_leave()) return;
  const auto kept = std::make_shared<KeptTicks>();
  kept->name = QFileInfo(file).fileName();
  opener_.make_asking(
      QStringLiteral("Opening %1").arg(kept->name), file,
      [path = absolute_path(file)](const Progress&) { return recorded_paths_to_ask_for(path); },
      [kept, path = absolute_path(file)](const Progress& progress) {
        kept->recording = read_recording(path, part_of(progress, 0, 0.2));
        check_meshes(kept->recording->header, path);
        kept->curves = curves_of(kept->recording->ticks, part_of(progress, 0.2, 0.5));
        return open_scene(kept->recording->header.scene, part_of(progress, 0.5, 1));
      },
      [this, kept](DrawnSession drawn) { opened(std::move(drawn), kept); });
}

void HistoryControl::opened(DrawnSession drawn, const std::shared_ptr<KeptTicks>& recording) {
  emit show_wanted(drawn);
  plots_->forget();
  opened_ = recording;
  if (opened_->log().empty())
    prompts_.report_error(QStringLiteral("%1 holds no tick.").arg(opened_->name));
  look_at(opened_->log().first_time());
  if (const std::string& cut = opened_->recording->cut; !cut.empty())
    emit say(QStringLiteral("%1: %2. What is before it is shown.")
                 .arg(opened_->name, QString::fromStdString(cut)));
}

void HistoryControl::show_kept(std::shared_ptr<KeptTicks> ticks, double time) {
  leave();
  plots_->forget();
  opened_ = std::move(ticks);
  look_at(time);
}

std::optional<TickBlocks> HistoryControl::ticks_on_show() {
  recorder_.seal();
  const TickLog* log = looking_back() ? playback_.ticks() : kept();
  if (!log || log->empty()) return {};
  return TickBlocks::of(*log);
}

/// False, and says why, while another run is going on.
bool HistoryControl::may_run_again() const {
  if (!session_ || !kept() || kept()->empty()) return false;
  if (job_.running())
    prompts_.report_error(
        QStringLiteral("It is being run again already: wait until that has ended, or cancel it."));
  return !job_.running();
}

void HistoryControl::run_again(Method method, const std::optional<Coupling>& gains) {
  if (may_run_again()) start_runs(method, {gains});
}

void HistoryControl::run_both(const Coupling& a, const Coupling& b) {
  if (may_run_again()) start_runs(Method::pdg, {a, b});
}

void HistoryControl::start_runs(Method method, const std::vector<std::optional<Coupling>>& gains) {
  recorder_.seal();
  const auto into = std::make_shared<std::vector<std::shared_ptr<KeptTicks>>>();
  const auto order = std::make_shared<Order>(Order{.pair = session_->loaded().pair,
                                                   .ticks = TickBlocks::of(*kept()),
                                                   .budget = {},
                                                   .method = method,
                                                   .gains = {}});
  job_.start(
      QStringLiteral("Running it again"),
      [into, order, gains](const Progress& progress) {
        const auto all = double(gains.size());
        for (std::size_t i = 0; i < gains.size(); ++i) {
          order->gains = gains[i];
          into->push_back(std::make_shared<KeptTicks>());
          run(*order, *into->back(), part_of(progress, double(i) / all, double(i + 1) / all));
        }
      },
      [this, into](const std::exception_ptr& error) {
        if (!error) return show_runs(into->at(0), into->size() > 1 ? into->at(1) : nullptr);
        const QString reason = reason_of(error);
        if (!reason.isEmpty()) prompts_.report_error(reason);
      });
}

void HistoryControl::show_runs(std::shared_ptr<KeptTicks> first,
                               std::shared_ptr<KeptTicks> second) {
  plots_->forget();
  second_ = std::move(second);
  // The one before may be on show until this one is.
  const std::shared_ptr<KeptTicks> before = std::exchange(replay_, std::move(first));
  show_replay(true);
  emit replayed();
}

/// That of the tick on show, as the view says it: while it plays slowly, the place on the way to
/// the next one is another. A file that no longer holds the tick is told of elsewhere.
double HistoryControl::shown_time(const TickLog& log) const {
  try {
    return log.at(playback_.index()).time;
  } catch (const InputError&) {
    return playback_.time();
  }
}

void HistoryControl::show_state() {
  TimelineState state;
  const TickLog* log = kept();
  state.recording = recorder_.recording();
  state.since = recording_since_;
  state.replayed = replay_ != nullptr;
  state.shows_replay = shows_replay_;
  state.looking = looking_back();
  state.playing = playback_.playing();
  if (opened_) state.of = opened_->name;
  if (looking_back()) log = playback_.ticks();
  if (log && !log->empty()) {
    state.any = true;
    state.from = log->first_time();
    state.to = log->last_time();
    state.time = state.looking ? shown_time(*log) : state.to;
    state.tick = state.looking ? playback_.index() - log->begin() : 0;
  }
  timeline_->show_state(state);
}

}  // namespace sonde::ui
