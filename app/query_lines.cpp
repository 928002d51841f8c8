// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/query_lines.hpp"

#include <algorithm>
#include <iterator>

#include "engine/base/error.hpp"

namespace sonde::app {
namespace {

constexpr char end_mark = '#';

/// The line after the contacts of a pose.
std::string end_of(std::size_t index) { return end_mark + std::to_string(index); }

}  // namespace

QueryLines::QueryLines(const QueryFiles& files, const std::string& run)
    : json_(files.json),
      wants_contacts_(!files.contacts.empty()),
      resume_(files.resume),
      main_(files.result, run, files.resume),
      contacts_(files.result.empty() ? "" : files.contacts, run, files.resume) {
  if (resume_ && wants_contacts_ && !main_.lines().empty() && !contacts_.was_there())
    throw InputError::in(contacts_.file().string(),
                         "is missing or empty, while the part of the result is there: remove that, "
                         "or leave out --resume");
}

std::string QueryLines::written_over() const {
  return !resume_ && main_.was_there() ? main_.file().string() : std::string();
}

std::size_t QueryLines::taken_over(std::span<const std::size_t> indices) {
  std::size_t count = std::min(main_.lines().size(), indices.size());
  if (wants_contacts_) count = keep_whole_contacts(indices.first(count));
  main_.cut(count);
  return count;
}

/// Keeps the contacts of the poses from the first on that are whole. Returns how many these are.
std::size_t QueryLines::keep_whole_contacts(std::span<const std::size_t> indices) {
  std::size_t whole = 0, kept = 0;
  for (std::size_t i = 0; i < contacts_.lines().size() && whole < indices.size(); ++i)
    if (contacts_.lines()[i] == end_of(indices[whole])) ++whole, kept = i + 1;
  contacts_.cut(kept);
  return whole;
}

void QueryLines::add(std::span<const Column> columns, const Row& row,
                     std::span<const Column> contact_columns, std::span<const Row> contacts) {
  if (!json_)
    main_.add(csv_line(row));
  else if (!wants_contacts_)
    main_.add(json_line(columns, row));
  else
    main_.add(json_line(columns, row, {"contact_rows", contact_columns.subspan(1), contacts, 1}));
  if (!wants_contacts_) return;
  for (const Row& contact : contacts) contacts_.add(csv_line(contact));
  contacts_.add(end_of(static_cast<std::size_t>(std::get<std::int64_t>(row[0]))));
}

void QueryLines::flush_now_and_then() {
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ < std::chrono::seconds(1)) return;
  flushed_ = now;
  // Contacts first: a row in the part has its contacts there.
  contacts_.flush();
  main_.flush();
}

std::vector<std::string> QueryLines::contacts() const {
  std::vector<std::string> out;
  std::ranges::copy_if(contacts_.lines(), std::back_inserter(out),
                       [](const std::string& line) { return !line.starts_with(end_mark); });
  return out;
}

}  // namespace sonde::app
