// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/clash_control.hpp"

#include <QMainWindow>
#include <algorithm>
#include <thread>

#include "ui/base/format.hpp"
#include "ui/document/session.hpp"
#include "ui/panels/clash_panel.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr double seen_about = 0.1;  // of the smaller part: what is seen around a clash, at least

}  // namespace

std::vector<AssemblyPart> assembly_of(const Session& session, const Pose& X_FM) {
  const LoadedScene& loaded = session.loaded();
  // The pair keeps its bodies: whoever has a share of it has them.
  const auto pair = std::make_shared<const Pair>(loaded.pair);
  std::vector<AssemblyPart> parts;
  parts.push_back({"probe", {pair, &pair->probe()}, X_FM});
  for (const BodyPart& part : loaded.parts) {
    const bool taken = part.name == "probe";
    parts.push_back({taken ? "probe (fixed)" : part.name, part.body, part.X_BP});
  }
  if (loaded.parts.empty())
    parts.push_back({short_name(pair->fixed()).toStdString(), {pair, &pair->fixed()}, Pose()});
  return parts;
}

ClashControl::ClashControl(Viewport& viewport, QMainWindow& window, QDockWidget& beside)
    : QObject(&window),
      viewport_(viewport),
      panel_(new ClashPanel(&window)),
      job_(&window),
      flight_(viewport, this) {
  window.addDockWidget(window.dockWidgetArea(&beside), panel_);
  connect(panel_, &ClashPanel::find_wanted, this, &ClashControl::find);
  connect(panel_, &ClashPanel::stop_wanted, &job_, &Job::cancel);
  connect(panel_, &ClashPanel::chosen, this, &ClashControl::show);
  job_.stay_back();
  connect(&job_, &Job::progressed, panel_, &ClashPanel::show_progress);
}

void ClashControl::attach(Session* session, bool same_document) {
  session_ = session;
  job_.abandon();
  flight_.stop();
  found_.clear();
  parts_.clear();
  if (session && !same_document) panel_->take(session->fixed().mass.radius);
  panel_->show_progress({});
  panel_->show_clashes({}, {});
  panel_->show_reason(
      QStringLiteral("Each two of the fixed body's parts, and each with the probe where it is."));
}

void ClashControl::find() {
  if (!session_) return;
  ClashOptions options;
  options.within = panel_->within();
  options.allowance = panel_->allowance();
  options.threads = std::max(1u, std::thread::hardware_concurrency() - 1);  // the servo has one
  parts_ = assembly_of(*session_, session_->device_pose());
  found_.clear();
  panel_->show_progress(0);
  const auto out = std::make_shared<std::vector<Clash>>();
  job_.start(
      QStringLiteral("Finding clashes"),
      [parts = parts_, options, out](const Progress& progress) {
        *out = clashes(parts, options, progress);
      },
      [this, out](const std::exception_ptr& error) {
        panel_->show_progress({});
        if (error) {
          const QString reason = reason_of(error);
          return panel_->show_reason(reason.isEmpty() ? QStringLiteral("Stopped.") : reason);
        }
        found_ = *out;
        panel_->show_clashes(parts_, found_);
      });
}

void ClashControl::show(std::size_t index) {
  if (!session_ || index >= found_.size() || !found_[index].place) return;
  const Clash& clash = found_[index];
  const AssemblyPart &a = parts_[clash.parts[0]], &b = parts_[clash.parts[1]];
  const LengthUnit unit(session_->fixed().mass.radius);
  const double length = clash.depth.value_or(clash.clearance.value_or(0));
  PointedPlace place;
  place.at = *clash.place;
  place.size = std::max(length, seen_about * std::min(a.body->mass.radius, b.body->mass.radius));
  place.text =
      QStringLiteral("%1 – %2: %3 %4")
          .arg(QString::fromStdString(a.name), QString::fromStdString(b.name), unit.text(length),
               clash.kind == Clash::Kind::clear ? QStringLiteral("clear")
               : clash.fit                      ? QStringLiteral("to the way out of the fit")
                                                : QStringLiteral("deep"));
  flight_.show(place);
}

}  // namespace sonde::ui
