// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/merge_results.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string_view>

#include "engine/base/error.hpp"
#include "engine/study/parts/study_parts.hpp"
#include "engine/text/text_file.hpp"

namespace sonde::app {
namespace {

using nlohmann::ordered_json;

struct IndexedLine {
  std::uint64_t index;
  std::string line;
};
/// One share as its file has it.
struct ShareFile {
  std::string file;
  std::string head;                  ///< all before the rows, without the share
  std::optional<std::string> share;  ///< "1/2@run", where there is a row to tell it
  std::vector<IndexedLine> lines;    ///< without the share
};

void take_share(ShareFile& share, const std::string& name) {
  if (!share.share) share.share = name;
  if (*share.share != name) throw InputError::in(share.file, "holds rows of more than one share");
}

/// What a line ends with: ",NAME".
std::string_view last_field(std::string_view line) {
  const std::size_t comma = line.rfind(',');
  return comma == std::string_view::npos ? std::string_view() : line.substr(comma + 1);
}

ShareFile csv_share(const std::string& file, std::string_view text) {
  ShareFile out{file, {}, {}, {}};
  std::size_t number = 0;
  for (std::size_t end; (end = text.find('\n')) != std::string_view::npos;
       text.remove_prefix(end + 1)) {
    const std::string_view line = text.substr(0, end), last = last_field(line);
    const std::string_view before =
        line.substr(0, line.size() - std::min(line.size(), last.size() + 1));
    if (++number == 1) {
      if (!line.starts_with("index,") || last != "shard")
        throw InputError::at_line(file, 1, "is no result of sonde query --shard");
      out.head = before;
      continue;
    }
    std::uint64_t index = 0;
    const auto read = std::from_chars(line.data(), line.data() + line.size(), index);
    if (read.ec != std::errc{} || *read.ptr != ',')
      throw InputError::at_line(file, number, "does not begin with an index");
    take_share(out, std::string(last));
    out.lines.push_back({index, std::string(before)});
  }
  if (number == 0 || !text.empty())
    throw InputError::at_line(file, number + 1, "the file ends within a line");
  return out;
}

ShareFile json_share(const std::string& file, const std::string& text) {
  ShareFile out{file, {}, {}, {}};
  try {
    ordered_json whole = ordered_json::parse(text);
    for (ordered_json& row : whole.at("results")) {
      take_share(out, row.at("shard").get<std::string>());
      row.erase("shard");
      out.lines.push_back({row.at("index").get<std::uint64_t>(), row.dump()});
    }
    whole.erase("results");
    for (const auto& [key, value] : whole.items())
      out.head += (out.head.empty() ? "{\"" : ",\n\"") + key + "\": " + value.dump();
  } catch (const ordered_json::exception& error) {
    throw InputError::in(file, std::string("is no result of sonde query --shard: ") + error.what());
  }
  return out;
}

ShareFile share_in(const std::string& file) {
  const std::string text = read_text(file, std::numeric_limits<std::size_t>::max());
  return text.starts_with('{') ? json_share(file, text) : csv_share(file, text);
}

/// That a share of a result (not of contacts, of which a pose may have any number) has a row for
/// each of its poses, as many as its name says that there are.
void check_rows(const ShareFile& share, const Shard& part, std::string_view run) {
  if (share.head.starts_with("index,x,")) return;
  std::size_t poses = 0;
  const std::string_view number = run.substr(std::min(run.rfind('-'), run.size() - 1) + 1);
  const auto read = std::from_chars(number.data(), number.data() + number.size(), poses);
  if (read.ec != std::errc{}) throw InputError::in(share.file, "names no share: " + *share.share);
  std::size_t expected = part.index;
  for (const IndexedLine& line : share.lines) {
    if (line.index != expected || expected >= poses)
      throw InputError::in(share.file, "the row " + std::to_string(expected) + " is missing");
    expected += part.count;
  }
  if (expected < poses)
    throw InputError::in(share.file, "the row " + std::to_string(expected) +
                                         " is missing: the file has been cut off");
}

/// That all shares of one run are there, each once. One without rows cannot say which it is.
void check_complete(const std::vector<ShareFile>& shares) {
  std::set<std::size_t> there;
  std::string run;
  std::size_t count = 0, silent = 0;
  for (const ShareFile& share : shares) {
    if (share.head != shares.front().head)
      throw InputError::in(share.file, "has other columns than " + shares.front().file);
    if (!share.share) {
      ++silent;
      continue;
    }
    const std::size_t at = share.share->find('@');
    const auto part = shard_of(share.share->substr(0, at));
    if (at == std::string::npos || !part)
      throw InputError::in(share.file, "names no share: " + *share.share);
    const std::string its = share.share->substr(at);
    if (count != 0 && (its != run || part->count != count))
      throw InputError::in(share.file, "is of another run than " + shares.front().file +
                                           " (other meshes, poses, options or program)");
    run = its;
    count = part->count;
    check_rows(share, *part, run);
    if (!there.insert(part->index).second)
      throw InputError::in(share.file,
                           "share " + std::to_string(part->index + 1) + " is there twice");
  }
  if (there.size() + silent == count || (count == 0 && !shares.empty())) return;
  std::string missing;
  for (std::size_t i = 0; i < count; ++i)
    if (!there.contains(i)) missing += (missing.empty() ? "" : ", ") + std::to_string(i + 1);
  throw InputError::in(shares.front().file,
                       "of " + std::to_string(count) + " shares these are missing: " + missing);
}

}  // namespace

std::string merge_results(const std::vector<std::string>& files) {
  std::vector<ShareFile> shares;
  shares.reserve(files.size());
  for (const std::string& file : files) shares.push_back(share_in(file));
  check_complete(shares);
  std::vector<IndexedLine> lines;
  for (ShareFile& share : shares)
    std::move(share.lines.begin(), share.lines.end(), std::back_inserter(lines));
  std::ranges::stable_sort(lines, {}, &IndexedLine::index);
  const std::string& head = shares.front().head;
  const bool json = head.starts_with('{');
  std::string text = head + (json ? ",\n\"results\": [" : "\n");
  const char* separator = "\n";
  for (const IndexedLine& line : lines) {
    if (json) text += separator;
    text += line.line;
    if (!json) text += '\n';
    separator = ",\n";
  }
  return json ? text + "\n]}\n" : text;
}

}  // namespace sonde::app
