// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/tuning.hpp"

#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <algorithm>
#include <atomic>
#include <functional>
#include <optional>
#include <thread>

#include "engine/settings/profile_match.hpp"
#include "engine/study/tuning/tuning.hpp"
#include "engine/study/tuning/tuning_inputs.hpp"
#include "engine/study/tuning/tuning_report.hpp"
#include "engine/study/tuning/tuning_study.hpp"
#include "engine/text/output_file.hpp"

namespace sonde::ui {
namespace {

namespace fs = std::filesystem;

constexpr double looking = 0.1;  // of the time, for contacts
/// Of some MB each at most. Of older ones the finished rows are lost, which takes minutes to
/// repeat.
constexpr std::size_t studies_kept = 12;

std::string inputs_of(const LoadedScene& opened) {
  return tuning_inputs(SONDE_VERSION, {opened.probe_file, opened.fixed_file, {}},
                       opened.pair.probe(), opened.pair.fixed());
}

QJsonObject json_of(const std::string& text) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
}

QString doubt_of(const TuningResults& results, const LoadedScene& opened) {
  const QJsonObject inputs = json_of(results.about).value(QStringLiteral("inputs")).toObject();
  const QJsonObject ours = json_of(inputs_of(opened));
  for (const char* role : {"probe", "fixed"}) {
    const QJsonObject theirs = inputs.value(QLatin1String(role)).toObject();
    const QJsonObject own = ours.value(QLatin1String(role)).toObject();
    const auto key = [](const char* name) { return QLatin1String(name); };
    if (theirs.value(key("fingerprint")) == own.value(key("fingerprint"))) continue;
    const QString name = theirs.value(key("file")).toString();
    return QStringLiteral("This map is of another scene: its %1 is %2, not %3.")
        .arg(role == std::string_view("fixed") ? QStringLiteral("fixed body")
                                               : QStringLiteral("probe"),
             name.isEmpty() ? QStringLiteral("not named") : name,
             name == own.value(key("file")).toString() ? QStringLiteral("this file of that name")
                                                       : own.value(key("file")).toString());
  }
  return {};
}

TuningRequest request_of(const TuningOrder& order, const LoadedScene& opened) {
  TuningRequest request{.pair = opened.pair};
  request.X_FM = opened.start;
  request.coupling = opened.coupling;
  request.coupling.mode = order.mode;
  request.sample_time = 1 / opened.servo.rate_hz;
  request.budget = counted_budget(opened.servo);
  request.device = order.device;
  request.kind = order.kind;
  request.inputs = inputs_of(opened);
  return request;
}

/// Of a study that may not be finished; no value before its first row.
std::optional<Tuning> tuning_in(const fs::path& folder, const LoadedScene& opened) {
  const StudyFolder all = read_study(folder);
  const StudyFolder finished = all.finished();
  if (finished.names.empty()) return {};
  Tuning tuning{.folder = folder, .results = read_tuning(folder.string(), finished)};
  if (tuning.results.lines.empty()) return {};
  tuning.doubt = doubt_of(tuning.results, opened);
  tuning.rows = finished.names.size();
  tuning.of_rows = all.names.size();
  return tuning;
}

void write_reports(const fs::path& folder) {
  for (const StudyFile& file : tuning_files(folder.string(), read_study(folder)))
    write_whole(folder / file.name, file.text);
}

/// Removes the oldest studies, by their last row. Another program may be at one of the newest.
void keep_newest(const fs::path& within) {
  const auto age = [](const fs::path& study) {
    std::error_code none;
    return fs::last_write_time(study / "parts", none);
  };
  std::error_code none;
  std::vector<fs::path> studies;
  for (const fs::directory_entry& entry : fs::directory_iterator(within, none))
    studies.push_back(entry.path());
  if (studies.size() <= studies_kept) return;
  std::ranges::sort(studies, std::greater{}, age);
  for (std::size_t i = studies_kept; i < studies.size(); ++i) fs::remove_all(studies[i], none);
}

}  // namespace

bool is_named_in(const TuningResults& results, const QString& connected,
                 std::span<const std::string> known) {
  return is_model_of(results.device_id, connected.toStdString(), known);
}

Tuning load_tuning(const fs::path& folder_or_file, const LoadedScene& opened) {
  std::error_code none;
  const fs::path folder =
      fs::is_regular_file(folder_or_file, none) ? folder_or_file.parent_path() : folder_or_file;
  const StudyFolder study = read_study(folder);
  Tuning tuning{.folder = folder, .results = read_tuning(folder.string(), study)};
  tuning.doubt = doubt_of(tuning.results, opened);
  tuning.rows = tuning.of_rows = study.names.size();
  return tuning;
}

std::vector<std::string> situation_kinds() {
  std::vector<std::string> out;
  for (const ContactKind kind : {ContactKind::flat, ContactKind::edge, ContactKind::conforming,
                                 ContactKind::corner, ContactKind::jammed})
    out.emplace_back(name_of(kind));
  return out;
}

fs::path computed_studies_folder() {
  const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return fs::path(data.toStdString()) / "studies";
}

Tuning compute_tuning(const TuningOrder& order, const LoadedScene& opened, const Progress& progress,
                      const std::function<void(const Tuning&)>& found) {
  std::atomic<double> fraction = 0;
  const Stop stop = [&] { return progress && !progress(fraction); };
  const unsigned threads = std::max(2u, std::thread::hardware_concurrency()) - 1;
  const Study study = plan_tuning(request_of(order, opened), threads, stop,
                                  [&](double done) { fraction = looking * done; });
  const fs::path folder = order.within / fingerprint(study.about);
  std::size_t told = 0;
  const auto tell = [&](std::size_t done, std::size_t total, double) {
    fraction = looking + (1 - looking) * double(done) / double(total);
    if (!found || done <= told || done == total) return;
    told = done;
    if (auto so_far = tuning_in(folder, opened)) found(*so_far);
  };
  compute_parts(folder, study, {}, threads, stop, tell);
  write_reports(folder);
  keep_newest(order.within);
  Tuning tuning = load_tuning(folder, opened);
  tuning.computed = true;
  return tuning;
}

void save_tuning(const Tuning& tuning, const fs::path& folder) {
  const StudyFolder from = read_study(tuning.folder);
  Study study{from.kind, from.about, {}};
  auto result = from.results.begin();
  for (const std::string& name : from.names)
    study.parts.push_back({name, [&text = (result++)->value()](const Stop&) { return text; }});
  compute_parts(folder, study, {}, 1, [] { return false; });
  write_reports(folder);
}

}  // namespace sonde::ui
