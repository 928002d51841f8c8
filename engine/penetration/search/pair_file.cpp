// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/pair_file.hpp"

#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "engine/base/round_to_nearest.hpp"
#include "engine/body/body.hpp"
#include "engine/body/fingerprint.hpp"
#include "engine/proximity/sketch/sketch.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/text_file.hpp"

namespace sonde {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are kept as they are");

/// With the version of Sonde: the file holds what this version of the sketches makes.
constexpr std::string_view mark = "sonde pair " SONDE_VERSION "\n";
/// Bytes: many times the size of two sketches.
constexpr std::size_t most = std::size_t{1} << 28;

class Writer {
 public:
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(const std::vector<PointGroup>& groups) {
    put(std::uint64_t{groups.size()});
    for (const PointGroup& group : groups) {
      put(group.center);
      put(group.radius);
      put_all(group.points);
    }
  }
  void put(const Sketch& sketch) {
    put(sketch.few);
    put(sketch.more);
    const DistanceField::Parts parts = sketch.field.parts();
    put(parts.low);
    put(parts.high);
    put(parts.count);
    put(parts.spacing);
    put(parts.per_spacing);
    put_all(parts.nodes);
  }
  void put_all(const std::vector<Quad>& all) {
    put(std::uint64_t{all.size()});
    for (const Quad& x : all) put(x);
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::uint32_t checksum(std::string_view text) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size()));
}

class Reader {
 public:
  Reader(std::string file, std::string_view text) : file_(std::move(file)), left_(text) {}

  [[noreturn]] void refuse(const std::string& reason) const { throw InputError::in(file_, reason); }
  template <class T>
  T get() {
    static_assert(std::is_trivially_copyable_v<T>);
    T out;
    if (left_.size() < sizeof out) refuse("is damaged: it ends too early");
    std::memcpy(&out, left_.data(), sizeof out);
    left_.remove_prefix(sizeof out);
    return out;
  }
  /// Reads the count of items that take at least this many bytes each.
  std::size_t count(std::size_t bytes_each) {
    const auto out = get<std::uint64_t>();
    if (out > left_.size() / bytes_each) refuse("is damaged: it ends too early");
    return static_cast<std::size_t>(out);
  }
  std::vector<Quad> quads() {
    std::vector<Quad> out(count(sizeof(Quad)));
    for (Quad& x : out) x = get<Quad>();
    return out;
  }
  std::vector<PointGroup> groups() {
    std::vector<PointGroup> out(count(sizeof(Quad) + sizeof(double)));
    for (PointGroup& group : out) {
      group.center = get<Quad>();
      group.radius = get<double>();
      group.points = quads();
    }
    return out;
  }
  Sketch sketch() {
    Sketch out;
    out.few = groups();
    out.more = groups();
    DistanceField::Parts parts;
    parts.low = get<Quad>();
    parts.high = get<Quad>();
    parts.count = get<IntX4>();
    parts.spacing = get<float>();
    parts.per_spacing = get<float>();
    parts.nodes = quads();
    if (!parts.nodes.empty()) {
      std::uint64_t product = 1;
      for (int i = 0; i < 3; ++i) {
        if (parts.count[i] < 2 || parts.count[i] > 1 << 16) refuse("is damaged");
        product *= static_cast<std::uint64_t>(parts.count[i]);
      }
      if (product != parts.nodes.size()) refuse("is damaged");
    }
    out.field = DistanceField(parts);
    return out;
  }
  bool at_end() const { return left_.empty(); }

 private:
  std::string file_;
  std::string_view left_;
};

}  // namespace

void write_pair(const std::filesystem::path& file, const Pair& pair) {
  const RoundToNearest round_to_nearest;
  Writer out;
  out.put(fingerprint(pair.probe()));
  out.put(fingerprint(pair.fixed()));
  const Sketches& sketches = pair.sketches();
  out.put(static_cast<std::uint8_t>(bool(sketches)));
  if (sketches) {
    out.put(*sketches.probe);
    out.put(*sketches.fixed);
  }
  const std::string content = out.take();
  Writer sum;
  sum.put(checksum(content));
  write_whole(file, std::string(mark) + sum.take() + content);
}

Pair read_pair(const std::filesystem::path& file, std::shared_ptr<const Body> probe,
               std::shared_ptr<const Body> fixed) {
  const RoundToNearest round_to_nearest;
  if (!probe || !fixed) throw InputError("a pair needs two bodies");
  const std::string text = read_text(file, most);
  Reader whole(file.string(), text);
  const std::string_view kind = mark.substr(0, mark.rfind(' ') + 1);
  if (!text.starts_with(kind)) whole.refuse("is not a file of a pair");
  if (!text.starts_with(mark)) whole.refuse("was written by another version of Sonde");
  Reader sum(file.string(), std::string_view(text).substr(mark.size()));
  const auto kept = sum.get<std::uint32_t>();
  const std::string_view content = std::string_view(text).substr(mark.size() + sizeof kept);
  if (checksum(content) != kept) whole.refuse("is damaged: its checksum does not fit");
  Reader in(file.string(), content);
  for (const auto& [body, role] : {std::pair{probe.get(), "probe"}, {fixed.get(), "fixed body"}})
    if (in.get<std::uint64_t>() != fingerprint(*body))
      in.refuse("was written for another " + std::string(role) + " than " + body->name);
  Sketches sketches;
  if (in.get<std::uint8_t>() != 0) {
    sketches.probe = std::make_shared<const Sketch>(in.sketch());
    sketches.fixed = std::make_shared<const Sketch>(in.sketch());
  }
  if (!in.at_end()) in.refuse("is damaged: it goes on where it should end");
  return {std::move(probe), std::move(fixed),
          std::make_shared<const Sketches>(std::move(sketches))};
}

}  // namespace sonde
