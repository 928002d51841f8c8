// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/part_file.hpp"

#include <limits>
#include <string_view>
#include <system_error>

#include "engine/base/error.hpp"
#include "engine/platform/writable_file.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/text_file.hpp"

namespace sonde::app {

PartFile::PartFile(const std::string& result, const std::string& run, bool resume) : run_(run) {
  if (result.empty()) return;
  file_ = result + ".part";
  if (!resume || !std::filesystem::exists(file_)) return;
  was_there_ = true;
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
  std::string text;
  for (std::size_t i = ours_ ? flushed_ : 0; i < lines_.size(); ++i)
    text.append(lines_[i]).append("\n");
  if (!ours_) {
    write_whole(file_, run_ + "\n" + text);
  } else {
    WritableFile file(file_, WritableFile::Opening::append);
    if (!file.is_open() || !file.write(text))
      throw InputError::in(file_.string(),
                           "cannot be written: " + std::generic_category().message(file.error()));
  }
  ours_ = true;
  flushed_ = lines_.size();
}

void PartFile::done() {
  if (file_.empty()) return;
  std::error_code gone;  // a part that is left does no harm
  std::filesystem::remove(file_, gone);
}

}  // namespace sonde::app
