// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/tuning.hpp"

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <atomic>
#include <thread>

#include "engine/study/tuning/tuning.hpp"
#include "engine/study/tuning/tuning_inputs.hpp"
#include "engine/study/tuning/tuning_report.hpp"
#include "engine/study/tuning/tuning_study.hpp"
#include "engine/text/output_file.hpp"

namespace sonde::ui {
namespace {

namespace fs = std::filesystem;

constexpr double looking = 0.1;  // of the time, for contacts

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
  if (opened.servo.budget.steps > 0) request.budget.steps = opened.servo.budget.steps;
  request.device = order.device;
  request.inputs = inputs_of(opened);
  return request;
}

void keep_kind(Study& study, const std::string& kind) {
  if (kind.empty()) return;
  std::erase_if(study.parts,
                [&](const StudyPart& part) { return !part.name.starts_with(kind + '.'); });
  if (study.parts.empty()) throw InputError("no contact of the kind \"" + kind + "\" was found");
}

}  // namespace

Tuning load_tuning(const fs::path& folder_or_file, const LoadedScene& opened) {
  std::error_code none;
  const fs::path folder =
      fs::is_regular_file(folder_or_file, none) ? folder_or_file.parent_path() : folder_or_file;
  Tuning tuning{.folder = folder, .results = {}, .doubt = {}};
  tuning.results = read_tuning(folder.string(), read_study(folder));
  tuning.doubt = doubt_of(tuning.results, opened);
  return tuning;
}

std::vector<std::string> situation_kinds() {
  std::vector<std::string> out;
  for (const ContactKind kind : {ContactKind::flat, ContactKind::edge, ContactKind::conforming,
                                 ContactKind::corner, ContactKind::jammed})
    out.emplace_back(name_of(kind));
  return out;
}

Tuning compute_tuning(const TuningOrder& order, const LoadedScene& opened,
                      const Progress& progress) {
  std::atomic<double> fraction = 0;
  const Stop stop = [&] { return progress && !progress(fraction); };
  Study study =
      plan_tuning(request_of(order, opened), stop, [&](double done) { fraction = looking * done; });
  keep_kind(study, order.kind);
  const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  compute_parts(order.folder, study, {}, threads, stop, [&](std::size_t done, std::size_t total) {
    fraction = looking + (1 - looking) * double(done) / double(total);
  });
  for (const StudyFile& file : tuning_files(order.folder.string(), read_study(order.folder)))
    write_whole(order.folder / file.name, file.text);
  return load_tuning(order.folder, opened);
}

}  // namespace sonde::ui
