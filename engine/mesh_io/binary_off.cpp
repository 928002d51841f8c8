// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/binary_off.hpp"

#include <bit>
#include <cmath>

#include "engine/base/progress.hpp"

namespace sonde {
namespace {

/// What stands before "OFF", and how many floats a vertex has more for each.
struct Header {
  std::size_t numbers = 3;  ///< of a vertex
  std::size_t size = 0;     ///< of the first line with its end, bytes
};

bool drop_prefix(std::string_view& text, std::string_view prefix) {
  const bool has = text.starts_with(prefix);
  if (has) text.remove_prefix(prefix.size());
  return has;
}

/// No size where it is not binary OFF.
Header header_of(std::string_view bytes) {
  const std::size_t end = bytes.substr(0, 80).find('\n');
  if (end == bytes.npos) return {};
  std::string_view line = bytes.substr(0, end);
  if (line.ends_with('\r')) line.remove_suffix(1);
  Header out;
  if (drop_prefix(line, "ST")) out.numbers += 2;
  if (drop_prefix(line, "C")) out.numbers += 4;
  if (drop_prefix(line, "N")) out.numbers += 3;
  if (!drop_prefix(line, "OFF") || !drop_prefix(line, " ")) return {};
  while (drop_prefix(line, " ")) continue;
  if (line == "BINARY") out.size = end + 1;
  return out;
}

class Reader {
 public:
  Reader(const std::string& file, std::string_view bytes, std::size_t at)
      : file_(file), bytes_(bytes), at_(at) {}

  std::size_t at() const { return at_; }
  std::size_t left() const { return bytes_.size() - at_; }
  [[noreturn]] void refuse(std::size_t at, const std::string& reason) const {
    throw InputError::at_byte(file_, at, reason);
  }
  std::uint32_t bits(const std::string& inside) {
    if (left() < 4) refuse(bytes_.size(), "the file ends inside " + inside);
    std::uint32_t out = 0;
    for (int k = 0; k < 4; ++k) out = out << 8 | static_cast<unsigned char>(bytes_[at_++]);
    return out;
  }
  std::uint64_t count(const std::string& what) {
    const auto value = std::bit_cast<std::int32_t>(bits(what));
    if (value < 0) refuse(at_ - 4, what + " is " + std::to_string(value));
    return static_cast<std::uint64_t>(value);
  }
  /// Passes over so many numbers.
  void skip(std::uint64_t numbers, const std::string& inside) {
    if (left() / 4 < numbers) refuse(bytes_.size(), "the file ends inside " + inside);
    at_ += 4 * numbers;
  }

 private:
  const std::string& file_;
  std::string_view bytes_;
  std::size_t at_;
};

std::string place(const char* what, std::uint64_t i, std::uint64_t of) {
  return std::string(what) + " " + std::to_string(i + 1) + " of " + std::to_string(of);
}

struct Counts {
  std::uint64_t vertices, faces;
};

Counts read_counts(Reader& reader, const Header& header) {
  const std::size_t start = reader.at();
  const std::uint64_t vertices = reader.count("the number of vertices");
  const std::uint64_t faces = reader.count("the number of faces");
  reader.skip(1, "the number of edges");
  constexpr std::uint64_t least_face = 5;  // the number of corners, three of them, no colour
  if (vertices == 0) reader.refuse(start, "the mesh has no vertices");
  if (faces == 0) reader.refuse(start, "the mesh has no faces");
  if (vertices * header.numbers + faces * least_face > reader.left() / 4)
    reader.refuse(start, "the header declares " + std::to_string(vertices) + " vertices and " +
                             std::to_string(faces) + " faces, but only " +
                             std::to_string(reader.left()) + " bytes follow");
  return {vertices, faces};
}

Vec3 read_vertex(Reader& reader, const Header& header, const std::string& name) {
  Vec3 out;
  for (int k = 0; k < 3; ++k) {
    out[k] = std::bit_cast<float>(reader.bits(name));
    if (!std::isfinite(out[k]))
      reader.refuse(reader.at() - 4, "a coordinate of " + name + " is not finite");
  }
  reader.skip(header.numbers - 3, name);
  return out;
}

std::vector<std::size_t> read_face(Reader& reader, std::uint64_t vertices,
                                   const std::string& name) {
  const std::uint64_t corners = reader.count("the number of corners of " + name);
  if (corners < 3) reader.refuse(reader.at() - 4, name + " has fewer than three corners");
  if (corners > reader.left() / 4)
    reader.refuse(reader.at() - 4, name + " has " + std::to_string(corners) +
                                       " corners, but only " + std::to_string(reader.left()) +
                                       " bytes follow");
  std::vector<std::size_t> out(corners);
  for (std::size_t& corner : out) {
    const auto index = std::bit_cast<std::int32_t>(reader.bits(name));
    if (index < 0 || static_cast<std::uint64_t>(index) >= vertices)
      reader.refuse(reader.at() - 4, "vertex index " + std::to_string(index) + " in " + name +
                                         " is out of range (0 to " + std::to_string(vertices - 1) +
                                         ")");
    corner = static_cast<std::size_t>(index);
  }
  reader.skip(reader.count("the number of colours of " + name), name);
  return out;
}

}  // namespace

bool is_binary_off(std::string_view bytes) { return header_of(bytes).size > 0; }

PolygonSoup read_binary_off(const std::string& file, std::string_view bytes,
                            const Progress& progress) {
  const Header header = header_of(bytes);
  Reader reader(file, bytes, header.size);
  const Counts counts = read_counts(reader, header);
  PolygonSoup out;
  out.points.reserve(counts.vertices);
  out.polygons.reserve(counts.faces);
  for_each_index(counts.vertices, part_of(progress, 0, 0.5), [&](std::size_t i) {
    out.points.push_back(read_vertex(reader, header, place("vertex", i, counts.vertices)));
  });
  for_each_index(counts.faces, part_of(progress, 0.5, 1), [&](std::size_t i) {
    out.polygons.push_back(read_face(reader, counts.vertices, place("face", i, counts.faces)));
  });
  if (reader.left() > 0)
    reader.refuse(reader.at(),
                  std::to_string(reader.left()) + " bytes more than the header declares");
  return out;
}

}  // namespace sonde
