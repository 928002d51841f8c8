// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <optional>

#include "engine/mesh_io/binary_scan.hpp"
#include "engine/mesh_io/mesh_readers.hpp"
#include "engine/mesh_io/mesh_scan.hpp"
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

PolygonSoup with_room_for(const PlyHeader& header) {
  PolygonSoup out;
  out.points.reserve(header.vertices);
  out.polygons.reserve(header.faces);
  return out;
}

// ------------------------------------------------------------------------------------------ text

class TextBody {
 public:
  TextBody(MeshScanner& scan, const PlyHeader& header)
      : scan_(scan), header_(header), out_(with_room_for(header)) {}

  PolygonSoup read() {
    for (const PlyElement& element : header_.elements)
      for (std::uint64_t i = 0; i < element.count; ++i) {
        if (!scan_.next_line()) scan_.refuse("the file ends before " + place(element, i));
        read_item(element);
      }
    if (scan_.next_line()) scan_.refuse("data after the last declared element");
    return std::move(out_);
  }

 private:
  void read_item(const PlyElement& element) {
    if (element.role == PlyElementRole::vertices) out_.points.emplace_back(Vec3::Zero());
    for (const PlyProperty& p : element.properties) {
      if (p.is_list)
        read_list(p);
      else if (const auto k = axis(p))
        out_.points.back()[*k] = scan_.coordinate();
      else
        scan_.check_number();
    }
    if (scan_.skip_words() > 0)
      scan_.refuse("the line has more numbers than the header declares for a " + element.name);
  }

  void read_list(const PlyProperty& property) {
    const std::uint64_t count = scan_.count("a number of list entries");
    if (property.role != PlyRole::corners) {
      for (std::uint64_t k = 0; k < count; ++k) scan_.check_number();
      return;
    }
    if (count < 3) scan_.refuse("a face with fewer than three corners");
    Polygon face;
    face.reserve(std::min<std::uint64_t>(count, scan_.bytes_in_line()));
    for (std::uint64_t k = 0; k < count; ++k) face.push_back(scan_.index(header_.vertices));
    out_.polygons.push_back(std::move(face));
  }

  MeshScanner& scan_;
  const PlyHeader& header_;
  PolygonSoup out_;
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
    if (scan_.bytes_left() > 0)
      scan_.refuse_at(scan_.position(),
                      std::to_string(scan_.bytes_left()) + " bytes more than the header declares");
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
    if (property.role == PlyRole::corners && count < 3)
      scan_.refuse_at(start, place(element, item) + " has fewer than three corners");
    const auto entries = static_cast<std::uint64_t>(count);
    need(entries * property.type->size, element, item);
    if (property.role != PlyRole::corners) return scan_.skip(entries * property.type->size);
    Polygon face(entries);
    for (std::size_t& corner : face) corner = index(element, item, property);
    out_.polygons.push_back(std::move(face));
  }

  std::size_t index(const PlyElement& element, std::uint64_t item, const PlyProperty& property) {
    const std::size_t at = scan_.position();
    const double index = take(*property.type);
    if (!(index >= 0 && index < static_cast<double>(header_.vertices)))
      scan_.refuse_at(at, "vertex index " + std::to_string(static_cast<std::int64_t>(index)) +
                              " in " + place(element, item) + " is out of range (0 to " +
                              std::to_string(header_.vertices - 1) + ")");
    return static_cast<std::size_t>(index);
  }

  BinaryScanner scan_;
  const PlyHeader& header_;
  PolygonSoup out_;
};

}  // namespace

PolygonSoup read_ply(const std::string& file, std::string_view bytes, const Progress& progress) {
  MeshScanner scan(file, bytes, '\0', false, progress);
  const PlyHeader header = read_ply_header(scan);
  if (header.format == PlyFormat::text) return TextBody(scan, header).read();
  const std::endian order =
      header.format == PlyFormat::big_endian ? std::endian::big : std::endian::little;
  return BinaryBody({file, bytes, scan.position(), order, progress}, header).read();
}

}  // namespace sonde
