// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/ply_header.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/base/progress.hpp"

namespace sonde {
namespace {

const std::string header_file = "made-up.ply";
const Progress untold;
/// Enough for what the headers here declare.
const std::string data_after(1000, '0');

PlyHeader ply_header_of(const std::string& text, std::size_t* data = nullptr) {
  MeshScanner scan(header_file, text, '\0', false, untold);
  PlyHeader out = read_ply_header(scan);
  if (data) *data = scan.position();
  return out;
}
std::string ply_refusal_of(const std::string& text) {
  try {
    ply_header_of(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}
std::string with_vertices(const std::string& rest, const std::string& format = "ascii") {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty double z\n" + rest +
         "end_header\n" + data_after;
}
const std::string two_faces = "element face 2\nproperty list uchar int vertex_indices\n";

TEST(PlyHeader, says_what_is_where) {
  const std::string text =
      "ply\ncomment first\nformat binary_big_endian 1.0\nobj_info more\n"
      "element vertex 4\nproperty float64 z\nproperty uchar red\nproperty short x\n"
      "property float y\nelement face 2\nproperty list uint8 uint16 vertex_index\n"
      "element edge 3\nproperty int vertex1\nend_header\n";
  std::size_t data = 0;
  const PlyHeader header = ply_header_of(text + data_after, &data);
  EXPECT_EQ(data, text.size());
  EXPECT_EQ(header.format, PlyFormat::big_endian);
  EXPECT_EQ(header.format_name, "binary_big_endian");
  EXPECT_EQ(header.vertices, 4u);
  EXPECT_EQ(header.faces, 2u);
  EXPECT_TRUE(header.remarks.empty());
  ASSERT_EQ(header.elements.size(), 3u);
  const PlyElement& vertices = header.elements[0];
  EXPECT_EQ(vertices.role, PlyElementRole::vertices);
  EXPECT_EQ(vertices.line, 5u);
  ASSERT_EQ(vertices.properties.size(), 4u);
  const PlyRole roles[] = {PlyRole::z, PlyRole::other, PlyRole::x, PlyRole::y};
  const PlyKind kinds[] = {PlyKind::float64, PlyKind::uint8, PlyKind::int16, PlyKind::float32};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(vertices.properties[i].role, roles[i]) << i;
    EXPECT_EQ(vertices.properties[i].type->kind, kinds[i]) << i;
    EXPECT_FALSE(vertices.properties[i].is_list);
  }
  const PlyElement& faces = header.elements[1];
  EXPECT_EQ(faces.role, PlyElementRole::faces);
  ASSERT_EQ(faces.properties.size(), 1u);
  EXPECT_TRUE(faces.properties[0].is_list);
  EXPECT_EQ(faces.properties[0].role, PlyRole::corners);
  EXPECT_EQ(faces.properties[0].count_type->kind, PlyKind::uint8);
  EXPECT_EQ(faces.properties[0].type->kind, PlyKind::uint16);
  EXPECT_EQ(header.elements[2].role, PlyElementRole::other);
  EXPECT_EQ(header.elements[2].name, "edge");
}

// Reference: Turk, The PLY Polygon File Format, and the names with sizes that others write.
TEST(PlyHeader, types_have_two_names_and_their_sizes) {
  const struct {
    const char *name, *other;
    std::size_t size;
    bool whole;
  } types[] = {{"char", "int8", 1, true},      {"uchar", "uint8", 1, true},
               {"short", "int16", 2, true},    {"ushort", "uint16", 2, true},
               {"int", "int32", 4, true},      {"uint", "uint32", 4, true},
               {"float", "float32", 4, false}, {"double", "float64", 8, false}};
  for (const auto& type : types) {
    const auto read = [&](const char* name) {
      return ply_header_of(with_vertices("property " + std::string(name) + " more\n" + two_faces))
          .elements[0]
          .properties[3]
          .type;
    };
    EXPECT_EQ(read(type.name), read(type.other));
    EXPECT_EQ(read(type.name)->size, type.size) << type.name;
    EXPECT_EQ(read(type.name)->is_integer(), type.whole) << type.name;
  }
}

TEST(PlyHeader, of_two_properties_of_one_name_the_first_counts) {
  const PlyHeader header = ply_header_of(
      with_vertices("property float x\n" + two_faces + "property list uchar int vertex_index\n"));
  EXPECT_EQ(header.elements[0].properties[0].role, PlyRole::x);
  EXPECT_EQ(header.elements[0].properties[3].role, PlyRole::other);
  EXPECT_EQ(header.elements[1].properties[1].role, PlyRole::other);
}

TEST(PlyHeader, the_only_list_of_whole_numbers_is_that_of_corners) {
  const PlyHeader header = ply_header_of(with_vertices(
      "element faces 2\nproperty list uchar float uv\nproperty list uchar int mine\n"));
  EXPECT_EQ(header.elements[1].properties[0].role, PlyRole::other);
  EXPECT_EQ(header.elements[1].properties[1].role, PlyRole::corners);
  EXPECT_EQ(header.remarks,
            (Remarks{"line 7: the only list of \"faces\" is read as vertex_indices"}));
  EXPECT_THAT(ply_refusal_of(with_vertices(
                  "element face 2\nproperty list uchar int a\nproperty list uchar int b\n")),
              testing::HasSubstr(":7: the faces lack vertex_indices"));
  EXPECT_THAT(ply_refusal_of(with_vertices("element tristrips 1\nproperty list uchar float a\n")),
              testing::HasSubstr("the strips lack vertex_indices"));
}

TEST(PlyHeader, strips_are_a_mesh_as_well) {
  const PlyHeader header =
      ply_header_of(with_vertices("element tristrips 1\nproperty list int int vertex_indices\n"));
  EXPECT_EQ(header.elements[1].role, PlyElementRole::strips);
  EXPECT_EQ(header.faces, 0u);
}

TEST(PlyHeader, what_is_no_header_of_a_mesh_is_refused_by_its_line) {
  const std::string vertices = "element vertex 4\nproperty float x\nproperty float y\n";
  const struct {
    std::string text, reason;
  } faults[] = {
      {"plyx\n", ":1: not a PLY file"},
      {"", ":1: not a PLY file"},
      {"ply\nelement vertex 4\n", ":2: \"format\" is expected"},
      {"ply\ncomment a\n", "\"format\" is expected"},
      {"ply\nformat binary 1.0\n", "unknown format \"binary\""},
      {"ply\nformat ascii 1.0\nproperty float x\n", "a property before the first element"},
      {"ply\nformat ascii 1.0\nelement vertex -4\n", "is not a number of elements"},
      {"ply\nformat ascii 1.0\nelement vertex 4\nproperty real x\n", "\"real\" is not a type"},
      {"ply\nformat ascii 1.0\nelement vertex 4\nproperty float\n", ":4: the property has no"},
      {"ply\nformat ascii 1.0\nelement vertex 4\n", "the file ends inside the header"},
      {"ply\nformat ascii 1.0\nvertex 4\n", "unknown header line \"vertex\""},
      {"ply\nformat ascii 1.0\n" + two_faces + "end_header\n", "the mesh has no vertices"},
      {"ply\nformat ascii 1.0\n" + vertices + two_faces + "end_header\n" + data_after,
       ":3: the vertices lack x, y or z"},
      {with_vertices(""), "the mesh has no faces"},
      {with_vertices("element face 0\nproperty list uchar int vertex_indices\n"),
       "the mesh has no faces"},
      {with_vertices(two_faces + two_faces), ":9: a second list of faces"},
      {with_vertices(two_faces + "element edge 1\n"), ":9: element \"edge\" has no properties"},
  };
  for (const auto& fault : faults)
    EXPECT_THAT(ply_refusal_of(fault.text), testing::HasSubstr(fault.reason)) << fault.text;
}

// Reference: by hand. Four vertices of 4 + 4 + 8 bytes and faces of at least one byte; as text, two
// characters for each number at least.
TEST(PlyHeader, declares_no_more_than_the_file_can_hold) {
  const auto faces = [](int count) {
    return "element face " + std::to_string(count) + "\nproperty list uchar int vertex_indices\n";
  };
  const auto refused = [&](int count, const char* format) {
    return ply_refusal_of(with_vertices(faces(count), format));
  };
  constexpr int room = 1000 + 1;  // the end of the last line may be missing
  EXPECT_EQ(refused(room - 4 * 16, "binary_little_endian"), "accepted");
  EXPECT_THAT(refused(room - 4 * 16 + 1, "binary_little_endian"),
              testing::HasSubstr(":7: the header declares 938 of \"face\", more than the file"));
  EXPECT_EQ(refused((room - 4 * 6) / 2, "ascii"), "accepted");
  EXPECT_THAT(refused((room - 4 * 6) / 2 + 1, "ascii"), testing::HasSubstr("more than the file"));
}

}  // namespace
}  // namespace sonde
