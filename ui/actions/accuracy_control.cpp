// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/accuracy_control.hpp"

#include <QMainWindow>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "engine/base/error.hpp"
#include "engine/calibration/calibration_file.hpp"
#include "engine/proximity/sketch/sketch.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/base/resources.hpp"

namespace sonde::ui {
namespace {

constexpr qint64 figures_ms = 250;
constexpr double usual_share = 0.01;
/// Of a calibration beside a scene, which is read while the window waits; one scene takes 20 kB.
constexpr std::uintmax_t most_bytes_beside = 1 << 20;

/// In that folder of what came with Sonde.
bool lies_in(const std::filesystem::path& file, const char* folder) {
  const std::filesystem::path bundled = resource(QLatin1String(folder)).toStdString();
  std::error_code none;
  return !bundled.empty() && !file.empty() &&
         std::filesystem::equivalent(file.parent_path(), bundled, none);
}

}  // namespace

AccuracyControl::AccuracyControl(DocumentControl& documents, QMainWindow& window,
                                 QDockWidget& beside)
    : QObject(&window), documents_(documents), panel_(new AccuracyPanel(&window)) {
  window.addDockWidget(window.dockWidgetArea(&beside), panel_);
  connect(panel_, &AccuracyPanel::kind_chosen, this, &AccuracyControl::choose);
  connect(panel_, &AccuracyPanel::time_changed, this,
          [this](double time_us) { change(time_us, 0); });
  connect(panel_, &AccuracyPanel::accuracy_changed, this,
          [this](double share) { change(0, share); });
  connect(panel_, &AccuracyPanel::sure_changed, this, &AccuracyControl::be_sure);
  // What changed while nobody saw it.
  connect(panel_, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    reached_.clear();
    if (session_) session_->set_time_phases(visible);
    if (visible) show_knob();
  });
}

void AccuracyControl::attach(Session* session) {
  session_ = session;
  has_sketches_ = session && session->loaded().pair.sketches();
  curve_.reset();
  search_curve_.reset();
  here_.reset();
  reached_.clear();
  if (session_) {
    session_->set_time_phases(panel_->isVisible());
    session_->set_sure(sure_);
  }
  panel_->show_reached({});
  panel_->show_search({}, 0);
  panel_->show_claim({}, sure_);
  show_knob();
}

void AccuracyControl::show_knob() {
  panel_->widget()->setEnabled(session_ != nullptr);
  if (!session_ || documents_.document().empty() || !panel_->isVisible()) return;
  const ServoSettings& servo = documents_.document().content().scene.servo;
  panel_->show_knob(servo, expected(servo));
}

const AccuracyCurve& AccuracyControl::curve() const {
  if (!curve_)
    curve_ = AccuracyCurve(default_calibration(), Answers::tick, Method::pdg, has_sketches_);
  return *curve_;
}

/// As the calibration names pairs: of a scene that came with Sonde, with its own bodies, the file
/// without its endings. Empty for every other, whatever its name.
std::string AccuracyControl::bundled_scene() const {
  const Document& document = documents_.document();
  const Scene& scene = document.content().scene;
  const bool bundled = lies_in(document.file(), "scenes") && lies_in(scene.probe.mesh, "models") &&
                       lies_in(scene.fixed.mesh, "models");
  return bundled ? document.file().stem().stem().string() : std::string();
}

/// By a file beside the scene, or by the calibration that ships.
const AccuracyControl::Measured& AccuracyControl::measured_here() const {
  const std::filesystem::path& scene = documents_.document().file();
  if (here_ && here_->scene == scene) return *here_;
  here_ = Measured{scene, of_pair(default_calibration(), bundled_scene()), {}};
  if (scene.empty()) return *here_;
  const std::string name = name_of_scene(scene);
  const auto file = scene.parent_path() / (name + ".calibration.json");
  std::error_code none;
  if (!std::filesystem::exists(file, none)) return *here_;
  try {
    if (std::filesystem::file_size(file) > most_bytes_beside)
      throw InputError::in(file.string(), "over 1 MiB: it is not of this scene alone");
    here_->calibration = of_pair(read_calibration(file), name);
    if (here_->calibration.series.empty())
      throw InputError::in(file.string(), "nothing of the scene " + name);
  } catch (const std::exception& bad) {
    here_->calibration = {};
    here_->wrong = QString::fromUtf8(bad.what());
  }
  return *here_;
}

Expected AccuracyControl::expected(const ServoSettings& servo) const {
  const double time_us =
      servo.accuracy > 0 ? curve().time_for(servo.accuracy) : servo.budget.microseconds;
  const Measured& measured = measured_here();
  const AccuracyCurve here(measured.calibration, Answers::tick, Method::pdg, has_sketches_);
  return {time_us, curve().within(time_us),
          here.known() ? std::optional(here.within(time_us)) : std::nullopt, measured.wrong};
}

/// The value of the kind that was chosen is what the present one is worth.
void AccuracyControl::choose(AccuracyPanel::Knob kind) {
  if (!session_) return;
  const Expected now = expected(documents_.document().content().scene.servo);
  const double time_us = now.time_us > 0 ? now.time_us : ServoSettings{}.budget.microseconds;
  const double share = std::isfinite(now.within) ? now.within : usual_share;
  if (kind == AccuracyPanel::Knob::time) change(time_us, 0);
  if (kind == AccuracyPanel::Knob::accuracy) change(0, std::clamp(share, least_share, most_share));
  if (kind == AccuracyPanel::Knob::none) change(0, 0);
}

/// A wanted accuracy takes the place of a time, which then is the usual one: a scene names one.
void AccuracyControl::change(double time_us, double accuracy) {
  if (!session_) return;
  ServoSettings wanted = documents_.document().content().scene.servo;
  wanted.budget.microseconds = accuracy > 0 ? ServoSettings{}.budget.microseconds : time_us;
  wanted.accuracy = accuracy;
  reached_.clear();
  documents_.set_knob(wanted);
}

void AccuracyControl::be_sure(double share) {
  sure_ = share;
  search_curve_.reset();
  if (!session_) return;
  session_->set_sure(share);
  panel_->show_claim({}, share);
}

bool AccuracyControl::is_on_show() const { return panel_->isVisible(); }

void AccuracyControl::show_search() {
  const auto searched = session_ ? session_->searched() : std::nullopt;
  panel_->show_search(searched ? searched->phases : PhaseTimes(), searched ? searched->time_us : 0);
  if (!searched || !searched->nearest) return panel_->show_claim({}, sure_);
  if (!search_curve_)
    search_curve_ =
        AccuracyCurve(default_calibration(), Answers::search, Method::pdg, has_sketches_, sure_);
  Separation answer;
  answer.depth = searched->nearest->depth;
  answer.status = answer.depth > 0 ? Status::penetrating : Status::separated;
  answer.lower_bound = searched->lower_bound;
  answer.far_out = searched->far_out;
  panel_->show_claim(claim_of(answer, searched->budget_us, *search_curve_), sure_);
}

void AccuracyControl::frame(const Snapshot& tick, qint64 now) {
  if (!panel_->isVisible()) return;
  reached_.add(tick);
  if (now < due_) return;
  due_ = now + figures_ms;
  panel_->show_reached(reached_.reached());
  show_search();
}

}  // namespace sonde::ui
