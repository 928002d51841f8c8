// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/part_file.hpp"

#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/text_file.hpp"

namespace sonde::app {

PartFile::PartFile(const std::string& result, const std::string& run, bool resume) : run_(run) {
  if (result.empty()) return;
  file_ = result + ".part";
  was_there_ = std::filesystem::exists(file_) && !std::filesystem::is_empty(file_);
  if (std::filesystem::exists(file_)) hold(WritableFile::Opening::existing);
  if (resume && was_there_) take_over();
}

/// What was held until now is let go once the other is held.
void PartFile::hold(WritableFile::Opening opening) {
  WritableFile next(file_, opening);
  if (!next.is_open() && next.error() != static_cast<int>(std::errc::file_exists))
    fail_to_write(next.error());
  if (!next.is_open() || !next.hold())
    throw InputError::in(file_.string(), "another run writes it now: wait, or name another --out");
  part_ = std::move(next);
}

void PartFile::take_over() {
  const std::string text = read_text(file_, std::numeric_limits<std::size_t>::max());
  std::string_view rest = text;
  bool first = true;
  // The last line may have been cut off: what has no end does not count.
  for (std::size_t end; (end = rest.find('\n')) != std::string_view::npos;
       rest.remove_prefix(end + 1)) {
    if (!first) lines_.emplace_back(rest.substr(0, end));
    if (first && rest.substr(0, end) != run_)
      throw InputError::in(file_.string(),
                           "is of another run (other meshes, poses, options or program): remove "
                           "it, or leave out --resume");
    first = false;
  }
  if (first)
    throw InputError::in(file_.string(),
                         "is no part of a result: remove it, or leave out "
                         "--resume");
}

void PartFile::flush() {
  if (file_.empty() || (ours_ && flushed_ == lines_.size())) return;
  if (!part_.is_open()) hold(WritableFile::Opening::anew);
  std::string text;
  for (std::size_t i = ours_ ? flushed_ : 0; i < lines_.size(); ++i)
    text.append(lines_[i]).append("\n");
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
