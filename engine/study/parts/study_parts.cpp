// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/parts/study_parts.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <mutex>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/base/threads.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/text_file.hpp"

namespace sonde {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t most_bytes = std::size_t{64} << 20;
/// Nesting deeper than a study writes: recursion into a deeper value would exhaust the stack.
constexpr int deepest = 32;

fs::path study_file(const fs::path& folder) { return folder / "study.json"; }
fs::path part_file(const fs::path& folder, const std::string& name) {
  return folder / "parts" / (name + ".json");
}

/// The depth of nested brackets in JSON text, outside strings.
int depth_of(std::string_view json) {
  int depth = 0, most = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string && c == '\\') ++i;
    if (c == '"') in_string = !in_string;
    if (in_string) continue;
    if (c == '[' || c == '{') most = std::max(most, ++depth);
    if (c == ']' || c == '}') --depth;
  }
  return most;
}

/// Reads any text that is not nested deeper than a study writes.
std::string read_json(const fs::path& file) {
  std::string text = read_text(file, most_bytes);
  if (depth_of(text) > deepest)
    throw InputError::in(file.string(), "is nested deeper than what a study writes");
  return text;
}

std::string study_text(const Study& study) {
  Json names = Json::array();
  for (const StudyPart& part : study.parts) names.push_back(part.name);
  const Json json{{"study", study.kind}, {"about", Json::parse(study.about)}, {"parts", names}};
  return json.dump(2) + "\n";
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder / "parts", error);
  if (error) throw InputError::in(folder.string(), "cannot be made: " + error.message());
}

/// True if the folder is finished and has every part of the study.
bool has_all(const StudyFolder& folder, const Study& study) {
  return folder.complete() && std::ranges::all_of(study.parts, [&](const StudyPart& part) {
           return std::ranges::find(folder.names, part.name) != folder.names.end();
         });
}

/// The parts of the shard that have no file yet.
std::vector<const StudyPart*> missing(const fs::path& folder, const Study& study, Shard shard,
                                      std::size_t& total) {
  std::vector<const StudyPart*> parts;
  total = 0;
  for (std::size_t i = shard.index; i < study.parts.size(); i += shard.count) {
    ++total;
    if (!fs::exists(part_file(folder, study.parts[i].name))) parts.push_back(&study.parts[i]);
  }
  return parts;
}

/// Tells how far the parts are: what is finished, and what the others say of themselves.
class PartsTold {
 public:
  PartsTold(const std::vector<const StudyPart*>& parts, std::size_t total,
            const PartsProgress& progress)
      : parts_(parts),
        progress_(progress),
        ended_(parts.size()),
        total_(total),
        done_(total - parts.size()) {
    for (const StudyPart* part : parts)
      if (part->done) *part->done = 0;
  }

  void finished(std::size_t i) {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    ended_[i] = true;
    ++done_;
    tell(sum());
  }
  /// Where there is news: parts ask often whether to stop.
  void under_way() {
    if (!progress_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return;
    constexpr double news = 1e-3;  // of a part
    const double now = sum();
    if (now >= told_ + news) tell(now);
  }

 private:
  double sum() const {
    double all = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (parts_[i]->done && !ended_[i]) all += *parts_[i]->done;
    return all;
  }
  void tell(double under_way) {
    told_ = under_way;
    progress_(done_, total_, under_way);
  }

  const std::vector<const StudyPart*>& parts_;
  const PartsProgress& progress_;
  std::mutex mutex_;
  std::vector<bool> ended_;
  std::size_t total_, done_;
  double told_ = 0;
};

}  // namespace

// An empty "parts" folder alone was just created by another process; hidden files are incomplete.
void refuse_other_things(const fs::path& folder) {
  if (fs::exists(study_file(folder))) return;
  std::error_code error;
  for (const char* inside : {"", "parts"})
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / inside, error)) {
      const fs::path name = inside / entry.path().filename();
      if (name == "parts" && entry.is_directory(error)) continue;
      if (name == "study.json" || name.filename().string().starts_with('.')) continue;
      if (fs::exists(study_file(folder))) return;  // another process has just written it
      throw InputError::in(
          folder.string(),
          "holds \"" + name.string() + "\" and no study; take an empty folder or a new one");
    }
}

// Parts depend only on `about` and their name, so another list of parts (contacts of one kind, or
// of all) can take over the finished ones.
void claim_folder(const fs::path& folder, const Study& study) {
  const std::string text = study_text(study);
  const fs::path file = study_file(folder);
  bool stays = false;
  if (fs::exists(file)) {
    const StudyFolder there = read_study(folder);
    if (there.kind != study.kind || there.about != Json::parse(study.about).dump())
      throw InputError::in(file.string(),
                           "is of a study with other inputs or settings; take another folder");
    stays = has_all(there, study) || read_text(file, most_bytes) == text;
  }
  refuse_other_things(folder);
  make_folder(folder);
  if (!stays) write_whole(file, text);
}

bool StudyFolder::complete() const {
  return std::ranges::all_of(results, [](const auto& result) { return result.has_value(); });
}

StudyFolder StudyFolder::finished() const {
  StudyFolder out{kind, about, {}, {}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!results[i]) continue;
    out.names.push_back(names[i]);
    out.results.push_back(results[i]);
  }
  return out;
}

std::optional<Shard> shard_of(std::string_view text) {
  const auto number = [](std::string_view digits) -> std::optional<std::size_t> {
    std::size_t value = 0;
    const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (end.ec != std::errc{} || end.ptr != digits.data() + digits.size()) return std::nullopt;
    return value;
  };
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto which = number(text.substr(0, slash)), count = number(text.substr(slash + 1));
  if (!which || !count || *which < 1 || *which > *count) return std::nullopt;
  return Shard{*which - 1, *count};
}

void compute_parts(const fs::path& folder, const Study& study, Shard shard, unsigned threads,
                   const Stop& stop, const PartsProgress& progress) {
  claim_folder(folder, study);
  std::size_t total = 0;
  const std::vector<const StudyPart*> parts = missing(folder, study, shard, total);
  PartsTold told(parts, total, progress);
  std::atomic<bool> failed{false};
  const Stop stop_or_failed = [&] {
    told.under_way();
    return failed || stop();
  };
  run_parallel(parts.size(), std::max(1u, threads), [&](std::size_t i) {
    try {
      if (failed || stop()) throw Cancelled();
      const std::string result = parts[i]->compute(stop_or_failed);
      write_whole(part_file(folder, parts[i]->name), result);
    } catch (...) {
      failed = true;  // the other threads need not finish, since nobody will read their results
      throw;
    }
    told.finished(i);
  });
}

StudyFolder compute_at_once(const Study& study, unsigned threads, const Stop& stop) {
  StudyFolder out{study.kind, Json::parse(study.about).dump(), {}, {}};
  for (const StudyPart& part : study.parts) out.names.push_back(part.name);
  out.results.resize(study.parts.size());
  run_parallel(study.parts.size(), std::max(1u, threads),
               [&](std::size_t i) { out.results[i] = study.parts[i].compute(stop); });
  return out;
}

StudyFolder read_study(const fs::path& folder) {
  const fs::path file = study_file(folder);
  const auto bad = [&] { throw InputError::in(file.string(), "is not what a study writes"); };
  const Json json = Json::parse(read_json(file), nullptr, false);
  StudyFolder out;
  try {
    out.kind = json.at("study").get<std::string>();
    out.about = json.at("about").dump();
    out.names = json.at("parts").get<std::vector<std::string>>();
  } catch (const Json::exception&) {
    bad();
  }
  for (const std::string& name : out.names) {
    if (name.empty() || name.find('/') != std::string::npos) bad();
    const fs::path part = part_file(folder, name);
    std::error_code error;
    const bool there = fs::exists(part, error);
    if (error) throw InputError::in(part.string(), "cannot be read: " + error.message());
    out.results.push_back(there ? std::optional(read_json(part)) : std::nullopt);
  }
  return out;
}

std::string fingerprint(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  char digits[16];
  for (int i = 15; i >= 0; --i, hash >>= 4) digits[i] = "0123456789abcdef"[hash & 15];
  return {digits, sizeof digits};
}

}  // namespace sonde
