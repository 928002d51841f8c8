// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/packed_soup.hpp"

#include <cstdint>
#include <cstring>

namespace sonde {
namespace {

constexpr char is_soup = 'S', is_error = 'E';

template <class T>
void put(std::string& out, const T& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}
void put(std::string& out, const std::string& text) {
  put(out, std::uint64_t{text.size()});
  out.append(text);
}

class Unpacker {
 public:
  Unpacker(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes) {}

  template <class T>
  T take() {
    T value;
    std::memcpy(&value, take_bytes(sizeof value).data(), sizeof value);
    return value;
  }
  /// How many follow, of so many bytes at least.
  std::uint64_t take_count(std::size_t each) {
    const auto count = take<std::uint64_t>();
    if (count > bytes_.size() / each) refuse();
    return count;
  }
  std::string_view take_bytes(std::size_t size) {
    if (size > bytes_.size()) refuse();
    const std::string_view out = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return out;
  }
  [[noreturn]] void refuse() const {
    throw InputError::in(file_, "cannot be read: its reader went wrong in it");
  }

 private:
  const std::string& file_;
  std::string_view bytes_;
};

}  // namespace

std::string packed(const PolygonSoup& soup) {
  std::string out(1, is_soup);
  put(out, std::uint64_t{soup.points.size()});
  for (const Vec3& x : soup.points)
    for (const double c : x) put(out, c);
  put(out, std::uint64_t{soup.polygons.size()});
  for (const Polygon& polygon : soup.polygons) {
    put(out, std::uint64_t{polygon.size()});
    for (const std::size_t i : polygon) put(out, std::uint64_t{i});
  }
  put(out, std::uint64_t{soup.remarks.size()});
  for (const std::string& remark : soup.remarks) put(out, remark);
  return out;
}

std::string packed(const InputError& error) {
  std::string out(1, is_error);
  put(out, std::string(error.what()));
  return out;
}

PolygonSoup unpacked(const std::string& file, std::string_view bytes) {
  Unpacker from(file, bytes);
  const char kind = from.take<char>();
  if (kind == is_error) throw InputError(std::string(from.take_bytes(from.take_count(1))));
  if (kind != is_soup) from.refuse();
  PolygonSoup out;
  out.points.resize(from.take_count(3 * sizeof(double)));
  for (Vec3& x : out.points) {
    for (double& c : x) c = from.take<double>();
    if (!x.allFinite()) from.refuse();
  }
  out.polygons.resize(from.take_count(sizeof(std::uint64_t)));
  for (Polygon& polygon : out.polygons) {
    polygon.resize(from.take_count(sizeof(std::uint64_t)));
    for (std::size_t& i : polygon) {
      i = from.take<std::uint64_t>();
      if (i >= out.points.size()) from.refuse();
    }
  }
  out.remarks.resize(from.take_count(sizeof(std::uint64_t)));
  for (std::string& remark : out.remarks) remark = from.take_bytes(from.take_count(1));
  return out;
}

}  // namespace sonde
