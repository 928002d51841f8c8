// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/recorded_tick.hpp"

#include <algorithm>
#include <array>
#include <mutex>
#include <set>
#include <stdexcept>

#include "engine/penetration/contact/contact_clusters.hpp"

namespace sonde {
namespace {

struct ClusterId {
  std::uint64_t id = 0;
};
const std::array cluster_ids{Column<ClusterId>{
    "id", "", Stored::u64, [](const ClusterId& r) { return static_cast<double>(r.id); },
    [](ClusterId& r, double x) { r.id = field_of<std::uint64_t>(x); }}};

/// The reasons of failures: a byte per tick, 0 if there is none, and the texts that the bytes
/// index.
void append_reasons(std::string& out, std::span<const Snapshot> ticks) {
  constexpr std::size_t most = 255;
  std::vector<std::string_view> texts;
  std::vector<std::uint64_t> places;
  for (const Snapshot& tick : ticks) {
    const std::string_view reason = tick.separation.reason;
    auto at = std::ranges::find(texts, reason);
    if (at == texts.end() && !reason.empty() && texts.size() < most) at = texts.insert(at, reason);
    places.push_back(at == texts.end() ? 0 : static_cast<std::uint64_t>(at - texts.begin() + 1));
  }
  append_planes(out, places, 1);
  append_count(out, static_cast<std::uint32_t>(texts.size()));
  for (const std::string_view text : texts) {
    append_count(out, static_cast<std::uint32_t>(text.size()));
    out += text;
  }
}

/// The reason of a failure is static text; a text from a file becomes static here.
const char* lasting(std::string_view text) {
  static std::mutex mutex;
  static std::set<std::string, std::less<>> texts;
  const std::scoped_lock lock(mutex);
  return texts.emplace(text).first->c_str();
}

void take_reasons(std::string_view& in, std::span<Snapshot> ticks) {
  const std::vector<std::uint64_t> places = take_planes(in, ticks.size(), 1);
  std::vector<const char*> texts{""};
  for (std::uint32_t left = take_count(in); left > 0; --left) {
    const std::size_t size = take_count(in);
    if (size > in.size()) throw std::invalid_argument("a text ends beyond it");
    texts.push_back(lasting(in.substr(0, size)));
    in.remove_prefix(size);
  }
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    if (places[i] >= texts.size()) throw std::invalid_argument("a text is missing");
    ticks[i].separation.reason = texts[places[i]];
  }
}

/// Restores what follows from the stored data.
void complete(Snapshot& tick, double radius, std::span<const ClusterId> ids) {
  Separation& s = tick.separation;
  const Pose motion = s.separated;
  s.separated = s.status == Status::separated
                    ? s.device
                    : Pose{(s.device.q * motion.q).normalized(), s.device.p + motion.p};
  s.sigma = s.depth * s.depth;
  tick.hand.rows.separated = s.separated;
  tick.hand.asked = tick.wrench;
  s.clusters = contact_clusters(s.contacts, radius);
  if (static_cast<std::size_t>(s.clusters.size) == ids.size())
    for (std::size_t i = 0; i < ids.size(); ++i) s.clusters.items[i].id = ids[i].id;
}

}  // namespace

std::string tick_content(std::span<const Snapshot> ticks) {
  std::vector<Contact> all;
  std::vector<ClusterId> ids;
  for (const Snapshot& tick : ticks) {
    all.insert(all.end(), tick.separation.contacts.begin(), tick.separation.contacts.end());
    for (const ContactCluster& cluster : tick.separation.clusters) ids.push_back({cluster.id});
  }
  std::string out;
  append_table(out, ticks, tick_columns());
  append_table<Contact>(out, all, contact_columns());
  append_table<ClusterId>(out, ids, cluster_ids);
  append_reasons(out, ticks);
  return out;
}

std::vector<Snapshot> ticks_in(std::string_view content, double radius) {
  std::vector<Snapshot> ticks = take_table(content, tick_columns());
  const std::vector<Contact> all = take_table(content, contact_columns());
  const std::vector<ClusterId> ids = take_table<ClusterId>(content, cluster_ids);
  take_reasons(content, ticks);
  std::size_t contact = 0, cluster = 0;
  for (Snapshot& tick : ticks) {
    ContactSet& set = tick.separation.contacts;
    const std::size_t count = static_cast<std::size_t>(set.size);
    const std::size_t clusters = static_cast<std::size_t>(tick.separation.clusters.size);
    if (count > set.items.size() || contact + count > all.size() || cluster + clusters > ids.size())
      throw std::invalid_argument("contacts are missing");
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(contact), count, set.items.begin());
    complete(tick, radius, std::span(ids).subspan(cluster, clusters));
    contact += count;
    cluster += clusters;
  }
  return ticks;
}

std::string search_content(std::span<const RecordedSearch> all) {
  std::string out;
  append_table(out, all, search_columns());
  return out;
}

std::vector<RecordedSearch> searches_in(std::string_view content) {
  return take_table(content, search_columns());
}

}  // namespace sonde
