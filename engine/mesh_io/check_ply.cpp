// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "engine/mesh_io/mesh_checks.hpp"
#include "engine/mesh_io/mesh_scan.hpp"
#include "engine/mesh_io/ply_header.hpp"

namespace sonde {
namespace {

/// What a property is to the mesh. CGAL goes by names: the ones of no use to it are renamed, for it
/// takes some of them (colours, half-edges) on trust.
const char* name_for_cgal(const PlyElement& element, const PlyProperty& property) {
  switch (property.role) {
    case PlyRole::x:
      return "x";
    case PlyRole::y:
      return "y";
    case PlyRole::z:
      return "z";
    case PlyRole::corners:
      return "vertex_indices";
    case PlyRole::other:
      break;
  }
  return element.role == PlyElementRole::other ? "ignored" : "unused";
}

/// The header as CGAL is to see it. In text every number is read in the widest type, so that the
/// coordinates keep all their digits.
std::string header_for_cgal(const PlyHeader& header) {
  const bool is_text = header.format == PlyFormat::text;
  std::string out = "ply\nformat " + header.format_name + " 1.0\n";
  for (const PlyElement& e : header.elements) {
    const char* name = e.role == PlyElementRole::vertices ? "vertex"
                       : e.role == PlyElementRole::faces  ? "face"
                                                          : "ignored";
    out += std::string("element ") + name + " " + std::to_string(e.count) + "\n";
    for (const PlyProperty& p : e.properties) {
      const std::string wide = p.role == PlyRole::corners ? "int" : "double";
      out += "property ";
      if (p.is_list) out += "list " + (is_text ? "uint" : p.count_type->name) + " ";
      out += (is_text ? wide : p.type->name) + " " + name_for_cgal(e, p) + "\n";
    }
  }
  return out + "end_header\n";
}

std::string place(const PlyElement& element, std::uint64_t item) {
  return element.name + " " + std::to_string(item + 1) + " of " + std::to_string(element.count);
}

// ------------------------------------------------------------------------------------------ text

void check_text_list(MeshScanner& scan, const PlyProperty& property, std::uint64_t vertices,
                     std::string& out) {
  const std::uint64_t count = scan.count("a number of list entries");
  out += std::to_string(count);
  if (property.role != PlyRole::corners) {
    for (std::uint64_t k = 0; k < count; ++k) {
      scan.check_number();
      out += " 0";
    }
    return;
  }
  if (count < 3) scan.refuse("a face with fewer than three corners");
  for (std::uint64_t k = 0; k < count; ++k) {
    out += ' ';
    out += std::to_string(scan.index(vertices));
  }
}

void check_text_item(MeshScanner& scan, const PlyElement& element, std::uint64_t vertices,
                     std::string& out) {
  for (const PlyProperty& p : element.properties) {
    if (p.is_list) {
      check_text_list(scan, p, vertices, out);
    } else if (p.role == PlyRole::other) {
      scan.check_number();
      out += '0';
    } else {
      scan.copy_coordinate(out);
    }
    out += ' ';
  }
  out += '\n';
  if (scan.skip_words() > 0)
    scan.refuse("the line has more numbers than the header declares for a " + element.name);
}

void check_text_body(MeshScanner& scan, const PlyHeader& header, std::string& out) {
  for (const PlyElement& element : header.elements)
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!scan.next_line()) scan.refuse("the file ends before " + place(element, i));
      check_text_item(scan, element, header.vertices, out);
    }
  if (scan.next_line()) scan.refuse("data after the last declared element");
}

// ---------------------------------------------------------------------------------------- binary

class BinaryWalk {
 public:
  BinaryWalk(const std::string& file, std::string_view bytes, std::size_t start,
             const PlyHeader& header, const Progress& progress)
      : file_(file),
        bytes_(bytes),
        at_(start),
        swap_((header.format == PlyFormat::big_endian) ==
              (std::endian::native == std::endian::little)),
        vertices_(header.vertices),
        progress_(progress) {}

  void check(const PlyHeader& header) {
    for (const PlyElement& element : header.elements)
      for (std::uint64_t i = 0; i < element.count; ++i) {
        if ((i & 0xffff) == 0) report();
        for (const PlyProperty& property : element.properties) check_property(element, i, property);
      }
    if (at_ != bytes_.size())
      refuse(at_, std::to_string(bytes_.size() - at_) + " bytes more than the header declares");
  }

 private:
  [[noreturn]] void refuse(std::size_t at, const std::string& reason) const {
    throw InputError::at_byte(file_, at, reason);
  }

  void report() const {
    if (progress_ && !progress_(static_cast<double>(at_) / static_cast<double>(bytes_.size())))
      throw Cancelled();
  }

  void need(std::uint64_t n, const PlyElement& element, std::uint64_t item) const {
    if (bytes_.size() - at_ < n)
      refuse(bytes_.size(), "the file ends inside " + place(element, item));
  }

  template <class T>
  double read_as(std::size_t at) const {
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + at, sizeof(T));
    if (swap_) std::reverse(raw, raw + sizeof(T));
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return static_cast<double>(value);
  }

  double read(const PlyType& type, std::size_t at) const {
    switch (type.kind) {
      case PlyKind::int8:
        return read_as<std::int8_t>(at);
      case PlyKind::uint8:
        return read_as<std::uint8_t>(at);
      case PlyKind::int16:
        return read_as<std::int16_t>(at);
      case PlyKind::uint16:
        return read_as<std::uint16_t>(at);
      case PlyKind::int32:
        return read_as<std::int32_t>(at);
      case PlyKind::uint32:
        return read_as<std::uint32_t>(at);
      case PlyKind::float32:
        return read_as<float>(at);
      case PlyKind::float64:
        return read_as<double>(at);
    }
    return 0;
  }

  void check_property(const PlyElement& element, std::uint64_t item, const PlyProperty& property) {
    if (property.is_list) {
      check_list(element, item, property);
      return;
    }
    need(property.type->size, element, item);
    if (property.role != PlyRole::other && !std::isfinite(read(*property.type, at_)))
      refuse(at_, "a coordinate of " + place(element, item) + " is not finite");
    at_ += property.type->size;
  }

  void check_list(const PlyElement& element, std::uint64_t item, const PlyProperty& property) {
    need(property.count_type->size, element, item);
    const double count = read(*property.count_type, at_);
    if (count < 0) refuse(at_, "a list of a negative length in " + place(element, item));
    if (property.role == PlyRole::corners && count < 3)
      refuse(at_, place(element, item) + " has fewer than three corners");
    at_ += property.count_type->size;
    const auto entries = static_cast<std::uint64_t>(count);
    need(entries * property.type->size, element, item);
    if (property.role == PlyRole::corners)
      for (std::uint64_t k = 0; k < entries; ++k) check_index(element, item, property, k);
    at_ += entries * property.type->size;
  }

  void check_index(const PlyElement& element, std::uint64_t item, const PlyProperty& property,
                   std::uint64_t entry) const {
    const std::size_t at = at_ + entry * property.type->size;
    const double index = read(*property.type, at);
    if (!(index >= 0 && index < static_cast<double>(vertices_)))
      refuse(at, "vertex index " + std::to_string(static_cast<std::int64_t>(index)) + " in " +
                     place(element, item) + " is out of range (0 to " +
                     std::to_string(vertices_ - 1) + ")");
  }

  const std::string& file_;
  std::string_view bytes_;
  std::size_t at_;
  bool swap_;
  std::uint64_t vertices_;
  const Progress& progress_;
};

}  // namespace

CheckedMesh check_ply(const std::string& file, std::string_view text, const Progress& progress) {
  MeshScanner scan(file, text, '\0', false, progress);
  const PlyHeader header = read_ply_header(scan);
  CheckedMesh out;
  out.points = header.vertices;
  out.polygons = header.faces;
  out.text.reserve(text.size() + 1024);
  out.text = header_for_cgal(header);
  if (header.format == PlyFormat::text) {
    check_text_body(scan, header, out.text);
  } else {
    BinaryWalk(file, text, scan.position(), header, progress).check(header);
    out.text += text.substr(scan.position());
  }
  return out;
}

}  // namespace sonde
