// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept of time, to files: pictures, tables, ParaView's series.

#include <vtkPolyData.h>

#include <algorithm>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/base/progress.hpp"
#include "engine/text/output_file.hpp"
#include "ui/actions/animation.hpp"
#include "ui/actions/export_control.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/base/progress_dialog.hpp"
#include "ui/document/playback.hpp"
#include "ui/export/tables.hpp"
#include "ui/views/drawn_session.hpp"

namespace sonde::ui {
namespace {

constexpr std::size_t rows_at_once = 1000;

/// Every tick, in pieces: a table of ten minutes is large, and what it is made of larger.
void write_all_ticks(const std::filesystem::path& file, const TickBlocks& ticks,
                     const Progress& progress) {
  const TickLog log = ticks.log();
  check_writable(file);  // before the work
  std::string instants = instants_csv({}), contacts = contacts_csv({});
  const std::size_t head = instants.size(), contacts_head = contacts.size();
  std::vector<ExportedInstant> some;
  const auto add = [&] {
    instants += instants_csv(some).substr(head);
    contacts += contacts_csv(some).substr(contacts_head);
    some.clear();
  };
  const double all = double(log.end() - log.begin());
  for (std::uint64_t i = log.begin(); i < log.end(); ++i) {
    some.push_back(exported_instant_of(recorded_instant(log, i)));
    if (some.size() < rows_at_once) continue;
    add();
    report(progress, double(i - log.begin()) / all);
  }
  add();
  write_tables(file, instants, contacts, progress);
}

std::vector<ExportedInstant> instants_at(const TickLog& log, const std::vector<double>& times) {
  std::vector<ExportedInstant> instants;
  for (const double time : times) {
    const ExportedInstant then = exported_instant_of(recorded_instant(log, log.find(time)));
    // Of a tick that stands for two times, one: readers of series want times that rise.
    if (instants.empty() || then.time > instants.back().time) instants.push_back(then);
  }
  return instants;
}

}  // namespace

void ExportControl::export_recording_tables() {
  const auto kept = may_begin() ? history_.ticks_on_show() : std::nullopt;
  if (!kept) return;
  const QString file = ask_file(QStringLiteral("Export the numbers of the recording"),
                                QStringLiteral("recording.csv"), QStringLiteral("Tables (*.csv)"));
  if (file.isEmpty() || !may_write_contacts(file)) return;
  job_.start(
      QStringLiteral("Exporting numbers"),
      [file, kept = *kept](const Progress& progress) {
        write_all_ticks(file.toStdString(), kept, progress);
      },
      [this, file](const std::exception_ptr& error) { ended(file, error); });
}

void ExportControl::export_recording_vtk() {
  const auto kept = may_begin() ? history_.ticks_on_show() : std::nullopt;
  const auto wanted = kept ? ask_picture(ExportDialog::Of::recording_steps) : std::nullopt;
  if (!wanted) return;
  const QString folder = ask_file(QStringLiteral("Export the recording for ParaView: a new folder"),
                                  QStringLiteral("sonde-recording-vtk"), QString());
  if (folder.isEmpty() || !drawn_) return;
  job_.start(
      QStringLiteral("Exporting for ParaView"),
      [folder, what = surfaces(), kept = *kept,
       times = wanted->span.times()](const Progress& progress) {
        write_vtk(folder.toStdString(), what, instants_at(kept.log(), times), progress);
      },
      [this, folder](const std::exception_ptr& error) { ended(folder, error); });
}

void ExportControl::export_recording_pictures() {
  const auto kept = may_begin() ? history_.ticks_on_show() : std::nullopt;
  const auto wanted = kept ? ask_picture(ExportDialog::Of::recording) : std::nullopt;
  if (!wanted) return;
  const QString folder = ask_file(QStringLiteral("Export the recording: a new folder of pictures"),
                                  QStringLiteral("sonde-recording"), QString());
  if (folder.isEmpty() || !drawn_ || animation_) return;
  try {
    auto animation = std::make_unique<Animation>(folder, *wanted);
    const std::vector<double> times = wanted->span.times();
    animation->count = static_cast<int>(times.size());
    animation->picture = [log = std::make_shared<const TickLog>(kept->log()), times](int i) {
      const std::uint64_t index = log->find(times[static_cast<std::size_t>(i)]);
      return Animation::Picture{recorded_instant(*log, index), 1};
    };
    animation->film_name = QStringLiteral("recording.mp4");
    animation->film_rate = wanted->span.rate;
    animate(std::move(animation));
  } catch (const InputError& bad) {
    emit failed(QString::fromUtf8(bad.what()));
  }
}

}  // namespace sonde::ui
