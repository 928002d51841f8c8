// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recorder.hpp"

#include <algorithm>

#include "ui/document/instant.hpp"

namespace sonde::ui {
namespace {

/// Curves take 76 bytes a tick, so there are no more of them than for ten minutes at 1 kHz.
constexpr double most_ticks = 600'000;
constexpr std::size_t bytes_of_curves = 46'000'000;

}  // namespace

void Recorder::begin(double probe_radius, double rate_hz) {
  stop();
  const auto most = static_cast<std::uint64_t>(std::min(most_ticks, seconds * rate_hz));
  ticks_ = std::make_unique<TickLog>(
      probe_radius, rate_hz, TickLog::Limits{.ticks = most, .bytes = most_bytes - bytes_of_curves});
  curves_ = Curves(most, longest_line(*ticks_));
  searched_.reset();
  clearance_.reset();
}

void Recorder::add(const Snapshot& tick) {
  if (!ticks_ || !ticks_->add(tick)) return;
  curves_.add(tick, ticks_->last_time(), searched_ ? &*searched_ : nullptr,
              clearance_ ? &*clearance_ : nullptr);
}

void Recorder::add(const BackgroundResult& search) {
  // The same one may be told of again and again.
  const bool known = searched_ && same_pose(searched_->device, search.device) &&
                     searched_->time_us == search.time_us;
  if (known) return;
  searched_ = search;
  if (ticks_) ticks_->add(search);
}

void Recorder::record(const std::filesystem::path& file, const Scene& scene,
                      const MeshMarks& meshes) {
  stop();
  if (!ticks_) return;
  ticks_->seal();
  writer_ =
      std::make_unique<RecordingWriter>(file, header_of(scene, meshes, ticks_->probe_radius()));
  for (BlockBytes& block : ticks_->all()) writer_->add(std::move(block));
  ticks_->sealed = [this](const std::shared_ptr<const std::string>& bytes) {
    writer_->add([bytes] { return *bytes; });
  };
}

void Recorder::stop() {
  if (!writer_) return;
  ticks_->seal();
  ticks_->sealed = nullptr;
  writer_->close();
  closing_.push_back(std::move(writer_));
}

std::optional<Recorder::Ended> Recorder::ended() {
  const auto done = std::find_if(closing_.begin(), closing_.end(),
                                 [](const auto& writer) { return writer->closed(); });
  if (done == closing_.end()) return {};
  const Ended ended{(*done)->file(), QString::fromStdString((*done)->failure().value_or(""))};
  closing_.erase(done);
  return ended;
}

QString Recorder::failure() const {
  return writer_ ? QString::fromStdString(writer_->failure().value_or("")) : QString();
}

}  // namespace sonde::ui
