// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <optional>

#include "engine/mesh_io/binary_scan.hpp"
#include "engine/mesh_io/mesh_readers.hpp"
#include "engine/mesh_io/mesh_scan.hpp"
#include "engine/mesh_io/plain_text.hpp"
#include "engine/mesh_io/ply_corners.hpp"
#include "engine/mesh_io/ply_header.hpp"

namespace sonde {
namespace {

std::string place(const PlyElement& element, std::uint64_t item) {
  return element.name + " " + std::to_string(item + 1) + " of " + std::to_string(element.count);
}

/// Which coordinate a property is; none where it is something else.
std::optional<Eigen::Index> axis(const PlyProperty& property) {
  switch (property.role) {
    case PlyRole::x:
      return 0;
    case PlyRole::y:
      return 1;
    case PlyRole::z:
      return 2;
    case PlyRole::corners:
    case PlyRole::other:
      break;
  }
  return {};
}

/// The index that ends a strip: -1, and in types without a sign the largest, where it is no vertex.
std::int64_t ends_strip(const PlyType& type, std::uint64_t vertices) {
  if (type.kind != PlyKind::uint8 && type.kind != PlyKind::uint16 && type.kind != PlyKind::uint32)
    return -1;
  const std::int64_t largest = (std::int64_t{1} << (8 * type.size)) - 1;
  return static_cast<std::uint64_t>(largest) < vertices ? -1 : largest;
}

PolygonSoup with_room_for(const PlyHeader& header) {
  PolygonSoup out;
  out.points.reserve(header.vertices);
  out.polygons.reserve(header.faces);
  out.remarks = header.remarks;
  return out;
}

// ------------------------------------------------------------------------------------------ text

class TextBody {
 public:
  TextBody(MeshScanner& scan, const PlyHeader& header)
      : scan_(scan), header_(header), out_(with_room_for(header)) {}

  PolygonSoup read() {
    scan_.drop_end_marks();
    for (const PlyElement& element : header_.elements)
      for (std::uint64_t i = 0; i < element.count; ++i) {
        if (!scan_.next_line()) scan_.refuse("the file ends before " + place(element, i));
        read_item(element);
      }
    if (scan_.next_line()) scan_.refuse("data after the last declared element");
    need_polygons();
    corners_.remark_to(out_.remarks, "line");
    scan_.remark_to(out_.remarks);
    return std::move(out_);
  }

 private:
  void read_item(const PlyElement& element) {
    if (element.role == PlyElementRole::vertices) out_.points.emplace_back(Vec3::Zero());
    for (const PlyProperty& p : element.properties) {
      if (p.is_list)
        read_list(element, p);
      else if (const auto k = axis(p))
        out_.points.back()[*k] = scan_.coordinate();
      else
        scan_.check_number();
    }
    if (scan_.skip_words() > 0)
      scan_.refuse("the line has more numbers than the header declares for a " + element.name);
  }

  void read_list(const PlyElement& element, const PlyProperty& property) {
    const std::uint64_t count = scan_.count("a number of list entries");
    if (property.role != PlyRole::corners) {
      for (std::uint64_t k = 0; k < count; ++k) scan_.check_number();
      return;
    }
    if (element.role == PlyElementRole::strips) return read_strips(count, property);
    Polygon face;
    face.reserve(std::min<std::uint64_t>(count, scan_.bytes_in_line()));
    for (std::uint64_t k = 0; k < count; ++k) face.push_back(scan_.index(header_.vertices));
    corners_.face(std::move(face), scan_.line());
  }

  void read_strips(std::uint64_t count, const PlyProperty& property) {
    const std::string end = std::to_string(ends_strip(*property.type, header_.vertices));
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::string_view word = scan_.word();
      if (word == "-1" || word == end)
        corners_.end_strip();
      else
        corners_.strip_corner(scan_.index(word, header_.vertices), scan_.line());
    }
    corners_.end_strip();
  }

  void need_polygons() {
    if (out_.polygons.empty()) scan_.refuse("no face or strip has more than two corners");
  }

  MeshScanner& scan_;
  const PlyHeader& header_;
  PolygonSoup out_;
  PlyCorners corners_{out_.polygons};
};

// ---------------------------------------------------------------------------------------- binary

class BinaryBody {
 public:
  BinaryBody(BinaryScanner scan, const PlyHeader& header)
      : scan_(scan), header_(header), out_(with_room_for(header)) {}

  PolygonSoup read() {
    for (const PlyElement& element : header_.elements)
      for (std::uint64_t i = 0; i < element.count; ++i) {
        scan_.report(i);
        if (element.role == PlyElementRole::vertices) out_.points.emplace_back(Vec3::Zero());
        for (const PlyProperty& p : element.properties)
          p.is_list ? read_list(element, i, p) : read_number(element, i, p);
      }
    scan_.check_end(out_.remarks);
    if (out_.polygons.empty())
      scan_.refuse_at(scan_.position(), "no face or strip has more than two corners");
    corners_.remark_to(out_.remarks, "byte");
    return std::move(out_);
  }

 private:
  void need(std::uint64_t n, const PlyElement& element, std::uint64_t item) const {
    scan_.need(n, [&] { return place(element, item); });
  }

  double take(const PlyType& type) {
    switch (type.kind) {
      case PlyKind::int8:
        return scan_.take<std::int8_t>();
      case PlyKind::uint8:
        return scan_.take<std::uint8_t>();
      case PlyKind::int16:
        return scan_.take<std::int16_t>();
      case PlyKind::uint16:
        return scan_.take<std::uint16_t>();
      case PlyKind::int32:
        return scan_.take<std::int32_t>();
      case PlyKind::uint32:
        return scan_.take<std::uint32_t>();
      case PlyKind::int64:
        return static_cast<double>(scan_.take<std::int64_t>());
      case PlyKind::uint64:
        return static_cast<double>(scan_.take<std::uint64_t>());
      case PlyKind::float32:
        return static_cast<double>(scan_.take<float>());
      case PlyKind::float64:
        return scan_.take<double>();
    }
    return 0;
  }

  void read_number(const PlyElement& element, std::uint64_t item, const PlyProperty& property) {
    need(property.type->size, element, item);
    const auto k = axis(property);
    if (!k) return scan_.skip(property.type->size);
    const double x = take(*property.type);
    if (!std::isfinite(x))
      scan_.refuse_at(scan_.position() - property.type->size,
                      "a coordinate of " + place(element, item) + " is not finite");
    out_.points.back()[*k] = x;
  }

  void read_list(const PlyElement& element, std::uint64_t item, const PlyProperty& property) {
    need(property.count_type->size, element, item);
    const std::size_t start = scan_.position();
    const double count = take(*property.count_type);
    if (count < 0) scan_.refuse_at(start, "a list of a negative length in " + place(element, item));
    if (count > most_entries) need(scan_.bytes_left() + 1, element, item);
    if (!property.count_type->is_integer() && count != std::floor(count))
      scan_.refuse_at(start, "a list whose length is no whole number in " + place(element, item));
    const auto entries = static_cast<std::uint64_t>(count);
    need(entries * property.type->size, element, item);
    if (property.role != PlyRole::corners) return scan_.skip(entries * property.type->size);
    if (element.role == PlyElementRole::strips)
      return read_strips(element, item, property, entries);
    Polygon face(entries);
    for (std::size_t& corner : face)
      corner = checked(take(*property.type), element, item, property);
    corners_.face(std::move(face), start);
  }

  void read_strips(const PlyElement& element, std::uint64_t item, const PlyProperty& property,
                   std::uint64_t entries) {
    const auto end = static_cast<double>(ends_strip(*property.type, header_.vertices));
    for (std::uint64_t k = 0; k < entries; ++k) {
      if ((k & 0xffff) == 0) scan_.report(k);
      const double index = take(*property.type);
      if (index == end)
        corners_.end_strip();
      else
        corners_.strip_corner(checked(index, element, item, property),
                              scan_.position() - property.type->size);
    }
    corners_.end_strip();
  }

  std::size_t checked(double index, const PlyElement& element, std::uint64_t item,
                      const PlyProperty& property) const {
    const bool in_range = index >= 0 && index < static_cast<double>(header_.vertices);
    if (!in_range || (!property.type->is_integer() && index != std::floor(index)))
      refuse_index(index, in_range, element, item, property);
    return static_cast<std::size_t>(index);
  }

  [[noreturn]] void refuse_index(double index, bool in_range, const PlyElement& element,
                                 std::uint64_t item, const PlyProperty& property) const {
    const std::size_t at = scan_.position() - property.type->size;
    if (in_range || !(std::abs(index) < most_entries))
      scan_.refuse_at(at, "a vertex index in " + place(element, item) + " is no whole number");
    scan_.refuse_at(at, "vertex index " + std::to_string(static_cast<std::int64_t>(index)) +
                            " in " + place(element, item) + " is out of range (0 to " +
                            std::to_string(header_.vertices - 1) + ")");
  }

  /// More than any file has; all whole numbers below are doubles.
  static constexpr double most_entries = 9007199254740992;  // 2^53

  BinaryScanner scan_;
  const PlyHeader& header_;
  PolygonSoup out_;
  PlyCorners corners_{out_.polygons};
};

}  // namespace

PolygonSoup read_ply(const std::string& file, std::string_view bytes, const Progress& progress) {
  bytes = plain_text(file, bytes);
  MeshScanner scan(file, bytes, '\0', false, progress);
  const PlyHeader header = read_ply_header(scan);
  if (header.format == PlyFormat::text) return TextBody(scan, header).read();
  const std::endian order =
      header.format == PlyFormat::big_endian ? std::endian::big : std::endian::little;
  return BinaryBody({file, bytes, scan.position(), order, progress}, header).read();
}

}  // namespace sonde
