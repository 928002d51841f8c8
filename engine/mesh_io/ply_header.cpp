// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/ply_header.hpp"

#include <algorithm>
#include <array>

namespace sonde {
namespace {

const PlyType* find_type(MeshScanner& scan) {
  static const std::array<PlyType, 10> types = {{{"char", "int8", PlyKind::int8, 1},
                                                 {"uchar", "uint8", PlyKind::uint8, 1},
                                                 {"short", "int16", PlyKind::int16, 2},
                                                 {"ushort", "uint16", PlyKind::uint16, 2},
                                                 {"int", "int32", PlyKind::int32, 4},
                                                 {"uint", "uint32", PlyKind::uint32, 4},
                                                 {"int64", "int64", PlyKind::int64, 8},
                                                 {"uint64", "uint64", PlyKind::uint64, 8},
                                                 {"float", "float32", PlyKind::float32, 4},
                                                 {"double", "float64", PlyKind::float64, 8}}};
  const std::string_view word = scan.word();
  for (const PlyType& type : types)
    if (word == type.name || word == type.other_name) return &type;
  scan.refuse(shown(word) + " is not a type");
}

bool is_remark(std::string_view keyword) { return keyword == "comment" || keyword == "obj_info"; }

void read_format(MeshScanner& scan, PlyHeader& header) {
  std::string_view keyword;
  do {
    if (!scan.next_line()) scan.refuse("\"format\" is expected");
    keyword = scan.word();
  } while (is_remark(keyword));
  if (keyword != "format") scan.refuse("\"format\" is expected");
  header.format_name = std::string(scan.word());
  if (header.format_name == "ascii")
    header.format = PlyFormat::text;
  else if (header.format_name == "binary_little_endian")
    header.format = PlyFormat::little_endian;
  else if (header.format_name == "binary_big_endian")
    header.format = PlyFormat::big_endian;
  else
    scan.refuse("unknown format " + shown(header.format_name));
}

PlyElement read_element(MeshScanner& scan) {
  PlyElement element;
  element.name = std::string(scan.word());
  element.count = scan.count("a number of elements");
  element.line = scan.line();
  if (element.name == "vertex" || element.name == "vertices")
    element.role = PlyElementRole::vertices;
  else if (element.name == "face" || element.name == "faces")
    element.role = PlyElementRole::faces;
  else if (element.name == "tristrips" || element.name == "tristrip")
    element.role = PlyElementRole::strips;
  return element;
}

bool has_role(const PlyElement& element, PlyRole role) {
  return std::ranges::any_of(element.properties,
                             [role](const PlyProperty& p) { return p.role == role; });
}

PlyRole role_of(const PlyElement& element, bool is_list, std::string_view name) {
  PlyRole role = PlyRole::other;
  if (element.role == PlyElementRole::vertices && !is_list)
    role = name == "x"   ? PlyRole::x
           : name == "y" ? PlyRole::y
           : name == "z" ? PlyRole::z
                         : PlyRole::other;
  if ((element.role == PlyElementRole::faces || element.role == PlyElementRole::strips) &&
      is_list && (name == "vertex_indices" || name == "vertex_index"))
    role = PlyRole::corners;
  return has_role(element, role) ? PlyRole::other : role;  // the first counts
}

void read_property(MeshScanner& scan, PlyHeader& header) {
  if (header.elements.empty()) scan.refuse("a property before the first element");
  PlyElement& element = header.elements.back();
  PlyProperty property;
  // The word after "property" is "list" or the type: look without taking it.
  MeshScanner ahead = scan;
  property.is_list = ahead.word() == "list";
  if (property.is_list) {
    scan.word();
    property.count_type = find_type(scan);
  }
  property.type = find_type(scan);
  const std::string_view name = scan.word();
  if (name.empty()) scan.refuse("the property has no name");
  property.role = role_of(element, property.is_list, name);
  element.properties.push_back(property);
}

/// The fewest bytes that one item can take.
std::uint64_t least_size(const PlyElement& element, PlyFormat format) {
  std::uint64_t size = 0;
  for (const PlyProperty& p : element.properties)
    size += format == PlyFormat::text ? 2 : p.is_list ? p.count_type->size : p.type->size;
  return size;
}

void check_room(MeshScanner& scan, const PlyHeader& header) {
  std::uint64_t room = scan.bytes_left() + 1;  // the last line may lack its end
  for (const PlyElement& e : header.elements) {
    if (e.count == 0) continue;
    const std::uint64_t least = least_size(e, header.format);
    if (least == 0) scan.refuse_at(e.line, "element " + shown(e.name) + " has no properties");
    if (e.count > room / least)
      scan.refuse_at(e.line, "the header declares " + std::to_string(e.count) + " of " +
                                 shown(e.name) + ", more than the file can hold");
    room -= e.count * least;
  }
}

PlyElement* find_element(MeshScanner& scan, PlyHeader& header, PlyElementRole role,
                         const char* what) {
  PlyElement* found = nullptr;
  for (PlyElement& e : header.elements) {
    if (e.role != role) continue;
    if (found) scan.refuse_at(e.line, std::string("a second list of ") + what);
    found = &e;
  }
  return found && found->count > 0 ? found : nullptr;
}

std::string plural(const PlyElement& element) {
  return element.role == PlyElementRole::faces ? "faces" : "strips";
}

/// Where no list has the usual name but there is just one of whole numbers, that is taken.
void need_corners(MeshScanner& scan, PlyHeader& header, PlyElement& element) {
  if (has_role(element, PlyRole::corners)) return;
  PlyProperty* only = nullptr;
  std::size_t lists = 0;
  for (PlyProperty& p : element.properties) {
    if (!p.is_list || !p.type->is_integer()) continue;
    only = &p;
    ++lists;
  }
  if (lists != 1) scan.refuse_at(element.line, "the " + plural(element) + " lack vertex_indices");
  only->role = PlyRole::corners;
  header.remarks.push_back("line " + std::to_string(element.line) + ": the only list of " +
                           shown(element.name) + " is read as vertex_indices");
}

void check_mesh(MeshScanner& scan, PlyHeader& header) {
  const PlyElement* vertices = find_element(scan, header, PlyElementRole::vertices, "vertices");
  PlyElement* faces = find_element(scan, header, PlyElementRole::faces, "faces");
  PlyElement* strips = find_element(scan, header, PlyElementRole::strips, "strips");
  if (!vertices) scan.refuse("the mesh has no vertices");
  if (!faces && !strips) scan.refuse("the mesh has no faces");
  for (const PlyRole role : {PlyRole::x, PlyRole::y, PlyRole::z})
    if (!has_role(*vertices, role)) scan.refuse_at(vertices->line, "the vertices lack x, y or z");
  header.vertices = vertices->count;
  if (faces) need_corners(scan, header, *faces);
  if (strips) need_corners(scan, header, *strips);
  header.faces = faces ? faces->count : 0;
}

}  // namespace

PlyHeader read_ply_header(MeshScanner& scan) {
  PlyHeader header;
  if (!scan.next_line() || scan.word() != "ply")
    scan.refuse("not a PLY file: it must start with \"ply\"");
  read_format(scan, header);
  for (;;) {
    if (!scan.next_line()) scan.refuse("the file ends inside the header");
    const std::string_view keyword = scan.word();
    if (keyword == "end_header") break;
    if (keyword == "element")
      header.elements.push_back(read_element(scan));
    else if (keyword == "property")
      read_property(scan, header);
    else if (!is_remark(keyword))
      scan.refuse("unknown header line " + shown(keyword));
  }
  check_mesh(scan, header);
  check_room(scan, header);
  return header;
}

}  // namespace sonde
