// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/part_file.hpp"

#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/study/parts/study_parts.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/text_file.hpp"

namespace sonde::app {
namespace {

std::string sum_after(const std::string& sum, std::string_view line) {
  return fingerprint(sum + std::string(line));
}

}  // namespace

PartFile::PartFile(const std::string& result, const std::string& run, bool resume) : run_(run) {
  if (result.empty()) return;
  file_ = result + ".part";
  std::error_code none;  // a name that cannot be is one of no file
  const bool exists = std::filesystem::exists(file_, none);
  was_there_ = exists && !std::filesystem::is_empty(file_, none);
  if (exists) hold(WritableFile::Opening::existing);
  if (resume && was_there_) take_over();
}

/// What was held until now is let go once the other is held.
void PartFile::hold(WritableFile::Opening opening) {
  WritableFile next(file_, opening);
  if (!next.is_open() && next.error() != static_cast<int>(std::errc::file_exists))
    fail_to_write(next.error());
  if (!next.is_open() || !next.lock())
    throw InputError::in(file_.string(), "another run writes it now: wait, or name another --out");
  part_ = std::move(next);
}

void PartFile::take_over() {
  const std::string text = read_text(file_, std::numeric_limits<std::size_t>::max());
  std::string_view rest = text;
  const auto next_line = [&rest]() -> std::optional<std::string_view> {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end + 1);
    return line;
  };
  const auto run = next_line();
  if (!run)
    throw InputError::in(file_.string(),
                         "is no part of a result: remove it, or leave out --resume");
  if (*run != run_)
    throw InputError::in(file_.string(),
                         "is of another run (other meshes, poses, options or program): remove "
                         "it, or leave out --resume");
  std::string sum = run_;
  while (const auto line = next_line()) {
    const std::size_t tab = line->rfind('\t');
    if (tab == std::string_view::npos) return;
    const std::string_view result = line->substr(0, tab);
    sum = sum_after(sum, result);
    if (line->substr(tab + 1) != sum) return;
    lines_.emplace_back(result);
  }
}

void PartFile::flush() {
  if (file_.empty() || (ours_ && flushed_ == lines_.size())) return;
  if (!part_.is_open()) hold(WritableFile::Opening::anew);
  if (!ours_) sum_ = run_;
  std::string text;
  for (std::size_t i = ours_ ? flushed_ : 0; i < lines_.size(); ++i) {
    sum_ = sum_after(sum_, lines_[i]);
    text.append(lines_[i]).append("\t").append(sum_).append("\n");
  }
  if (!ours_) {
    write_whole(file_, run_ + "\n" + text);
    hold(WritableFile::Opening::append);
  } else if (!part_.write(text)) {
    fail_to_write(part_.error());
  }
  ours_ = true;
  flushed_ = lines_.size();
}

void PartFile::fail_to_write(int error) const {
  throw InputError::in(file_.string(),
                       "cannot be written: " + std::generic_category().message(error));
}

void PartFile::done() {
  if (file_.empty()) return;
  std::error_code gone;  // a part that is left does no harm
  std::filesystem::remove(file_, gone);
  part_.close();
}

}  // namespace sonde::app
