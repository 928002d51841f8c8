// SPDX-License-Identifier: GPL-3.0-or-later
// Dialects of PLY. Reference: the same mesh written plainly.
#include <cmath>
#include <functional>
#include <limits>

#include "tests/engine/mesh_io/mesh_checks.hpp"

namespace sonde {
namespace {

using test::dialect_meshes;
using test::expect_read;
using test::refusal_of;

constexpr const char* formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};

/// Writes numbers of a type named as PLY does, as text or binary.
class Numbers {
 public:
  explicit Numbers(std::string format) : format_(std::move(format)) {}

  void put(const std::string& type, double value) {
    if (format_ == "ascii")
      text_ << value << ' ';
    else if (type == "char" || type == "int8")
      put_raw(static_cast<std::int8_t>(value));
    else if (type == "uchar" || type == "uint8")
      put_raw(static_cast<std::uint8_t>(value));
    else if (type == "short" || type == "int16")
      put_raw(static_cast<std::int16_t>(value));
    else if (type == "ushort" || type == "uint16")
      put_raw(static_cast<std::uint16_t>(value));
    else if (type == "int" || type == "int32")
      put_raw(static_cast<std::int32_t>(value));
    else if (type == "uint" || type == "uint32")
      put_raw(static_cast<std::uint32_t>(value));
    else if (type == "int64")
      put_raw(static_cast<std::int64_t>(value));
    else if (type == "uint64")
      put_raw(static_cast<std::uint64_t>(value));
    else if (type == "float" || type == "float32")
      put_raw(static_cast<float>(value));
    else
      put_raw(value);
  }
  void end_line() {
    if (format_ == "ascii") text_ << '\n';
  }
  std::string take() const { return format_ == "ascii" ? text_.str() : bytes_; }

 private:
  template <class T>
  void put_raw(T value) {
    bytes_ += test::raw(value, format_ == "binary_big_endian");
  }
  std::string format_;
  std::ostringstream text_ = test::exact_stream();
  std::string bytes_;
};

struct Kinds {
  std::string coordinate = "float", count = "uchar", index = "int", name = "vertex_indices";
  bool extras = false;  ///< before and after what is read
};

std::string vertices_of(const PolygonSoup& mesh, const Kinds& kinds) {
  std::string out = "element vertex " + std::to_string(mesh.points.size()) + "\n";
  if (kinds.extras) out += "property uchar flags\n";
  for (const char* axis : {"x", "y", "z"})
    out += "property " + kinds.coordinate + " " + axis + "\n";
  if (kinds.extras) out += "property list uchar float weights\nproperty double quality\n";
  return out;
}

void put_vertices(Numbers& out, const PolygonSoup& mesh, const Kinds& kinds) {
  for (const Vec3& x : mesh.points) {
    if (kinds.extras) out.put("uchar", 7);
    for (const double c : x) out.put(kinds.coordinate, c);
    if (kinds.extras)
      for (const auto& [type, value] :
           {std::pair{"uchar", 2.0}, {"float", 0.5}, {"float", 1.5}, {"double", -1.0}})
        out.put(type, value);
    out.end_line();
  }
}

std::string as_ply(const PolygonSoup& mesh, const std::string& format, const Kinds& kinds) {
  std::string header = "ply\nformat " + format + " 1.0\ncomment TextureFile a.png\nobj_info x\n";
  if (kinds.extras) header += "element camera 2\nproperty double fov\nproperty list short int of\n";
  header +=
      vertices_of(mesh, kinds) + "element face " + std::to_string(mesh.polygons.size()) + "\n";
  if (kinds.extras) header += "property ushort material\n";
  header += "property list " + kinds.count + " " + kinds.index + " " + kinds.name + "\n";
  if (kinds.extras)
    header += "property list uchar float texcoord\nelement edge 1\nproperty int a\n";
  Numbers out(format);
  if (kinds.extras)
    for (int i = 0; i < 2; ++i) {
      for (const auto& [type, value] : {std::pair{"double", 1.5}, {"short", 1.0}, {"int", -5.0}})
        out.put(type, value);
      out.end_line();
    }
  put_vertices(out, mesh, kinds);
  for (const Polygon& polygon : mesh.polygons) {
    if (kinds.extras) out.put("ushort", 9);
    out.put(kinds.count, static_cast<double>(polygon.size()));
    for (const std::size_t i : polygon) out.put(kinds.index, static_cast<double>(i));
    if (kinds.extras)
      for (const auto& [type, value] : {std::pair{"uchar", 2.0}, {"float", 0.0}, {"float", 1.0}})
        out.put(type, value);
    out.end_line();
  }
  if (kinds.extras) out.put("int", 4);
  return header + "end_header\n" + out.take();
}

TEST(PlyDialects, any_types_in_any_format) {
  const char* const integers[] = {"char",  "uchar",  "short", "ushort", "int",
                                  "uint",  "int8",   "uint8", "int16",  "uint16",
                                  "int32", "uint32", "int64", "uint64"};
  for (const PolygonSoup& mesh : dialect_meshes())
    for (const std::string format : formats) {
      for (const char* type : integers) {
        expect_read("a.ply", as_ply(mesh, format, {"float", type, "int"}), mesh);
        expect_read("a.ply", as_ply(mesh, format, {"double", "uchar", type, "vertex_index"}), mesh);
      }
      for (const char* type : {"float", "double", "float32", "float64"}) {
        expect_read("a.ply", as_ply(mesh, format, {type, type, "int"}), mesh);
        expect_read("a.ply", as_ply(mesh, format, {"double", "uchar", type}), mesh);
      }
      expect_read("a.ply",
                  as_ply(mesh, format, {"float", "ushort", "uint", "vertex_indices", true}), mesh);
    }
}

TEST(PlyDialects, whole_coordinates_of_any_type) {
  PolygonSoup mesh = test::box({2, 4, 6});
  for (Vec3& x : mesh.points) x = x.array().round();
  for (const std::string format : formats)
    for (const char* type : {"char", "short", "int", "int64", "float", "double"})
      expect_read("a.ply", as_ply(mesh, format, {type, "uchar", "int"}), mesh);
}

TEST(PlyDialects, the_only_list_of_faces_may_have_another_name) {
  for (const PolygonSoup& mesh : dialect_meshes())
    for (const std::string format : formats)
      expect_read("a.ply", as_ply(mesh, format, {"float", "uchar", "int", "vertex_list", true}),
                  mesh, {"line 15: the only list of \"face\" is read as vertex_indices"});
}

TEST(PlyDialects, indices_that_are_not_whole_are_refused) {
  const PolygonSoup mesh = test::tetrahedron(1);
  const std::string good = as_ply(mesh, "binary_little_endian", {"float", "uchar", "float"});
  const std::size_t start = good.find("end_header\n") + 11 + 48, second = start + 1 + 4;
  const auto with = [&](float x) { return std::string(good).replace(second, 4, test::raw(x)); };
  const auto at = [&](std::size_t byte, const std::string& reason) {
    return ": byte " + std::to_string(byte) + ": " + reason;
  };
  EXPECT_EQ(refusal_of("a.ply", with(0.5F)),
            at(second, "a vertex index in face 1 of 4 is no whole number"));
  EXPECT_EQ(refusal_of("a.ply", with(std::numeric_limits<float>::quiet_NaN())),
            at(second, "a vertex index in face 1 of 4 is no whole number"));
  EXPECT_EQ(refusal_of("a.ply", with(1e30F)),
            at(second, "a vertex index in face 1 of 4 is no whole number"));
  EXPECT_EQ(refusal_of("a.ply", with(4)),
            at(second, "vertex index 4 in face 1 of 4 is out of range (0 to 3)"));
  EXPECT_EQ(refusal_of("a.ply", with(-1)),
            at(second, "vertex index -1 in face 1 of 4 is out of range (0 to 3)"));
  std::string count = as_ply(mesh, "binary_little_endian", {"float", "float", "int"});
  const std::size_t first = count.find("end_header\n") + 11 + 48;
  for (const float bad : {2.5F, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_EQ(refusal_of("a.ply", count.replace(first, 4, test::raw(bad))),
              at(first, "a list whose length is no whole number in face 1 of 4"));
  for (const float bad : {1e30F, std::numeric_limits<float>::infinity()})
    EXPECT_EQ(refusal_of("a.ply", count.replace(first, 4, test::raw(bad))),
              at(count.size(), "the file ends inside face 1 of 4"));
}

// ------------------------------------------------------------------------------------------ strips

/// A file whose triangles are in strips: each list is one of the element's.
std::string as_strips(const PolygonSoup& mesh, const std::vector<std::vector<double>>& lists,
                      const std::string& format, const std::string& index = "int") {
  const Kinds kinds;
  Numbers out(format);
  put_vertices(out, mesh, kinds);
  for (const auto& list : lists) {
    out.put("int", static_cast<double>(list.size()));
    for (const double i : list) out.put(index, i);
    out.end_line();
  }
  return "ply\nformat " + format + " 1.0\n" + vertices_of(mesh, kinds) + "element tristrips " +
         std::to_string(lists.size()) + "\nproperty list int " + index +
         " vertex_indices\nend_header\n" + out.take();
}

// Reference: each triangle of the plain mesh as a strip of its own.
TEST(PlyDialects, strips_of_one_triangle_each) {
  for (const PolygonSoup& mesh : dialect_meshes()) {
    std::vector<std::vector<double>> together(1), apart;
    for (const Polygon& t : mesh.polygons) {
      apart.emplace_back(t.begin(), t.end());
      together[0].insert(together[0].end(), t.begin(), t.end());
      together[0].push_back(-1);
    }
    for (const std::string format : formats)
      for (const char* type : {"int", "char", "short", "float", "double", "int64"})
        for (const auto& lists : {together, apart})
          expect_read("a.ply", as_strips(mesh, lists, format, type), mesh);
  }
}

// Reference: the triangles of a band around a prism of n sides, all turned outwards.
TEST(PlyDialects, long_strips_turn_every_second_triangle) {
  for (const std::size_t n : {3u, 5u, 8u}) {
    PolygonSoup band;
    std::vector<double> strip;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 6.25 * static_cast<double>(i) / static_cast<double>(n);
      for (const double z : {0.0, 1.0})
        band.points.emplace_back(std::round(512 * std::cos(angle)) / 512,
                                 std::round(512 * std::sin(angle)) / 512, z);
    }
    const std::size_t all = 2 * n;
    for (std::size_t i = 0; i < all + 2; ++i) strip.push_back(static_cast<double>(i % all));
    for (std::size_t i = 0; i < all; ++i) {
      const std::size_t a = i, b = (i + 1) % all, c = (i + 2) % all;
      band.polygons.push_back(i % 2 == 0 ? Polygon{a, b, c} : Polygon{b, a, c});
    }
    for (const std::string format : formats) {
      expect_read("a.ply", as_strips(band, {strip}, format), band);
      // Corners that come twice lead on to another strip: here to the same again.
      std::vector<double> linked = strip;
      linked.push_back(strip.back());
      linked.push_back(strip.front());
      if (linked.size() % 2 != 0) linked.push_back(strip.front());
      linked.insert(linked.end(), strip.begin(), strip.end());
      PolygonSoup twice = band;
      twice.polygons.insert(twice.polygons.end(), band.polygons.begin(), band.polygons.end());
      expect_read("a.ply", as_strips(band, {linked}, format), twice);
      // In types without a sign the largest number ends a strip.
      std::vector<double> parted = strip;
      parted.push_back(65535);
      parted.insert(parted.end(), strip.begin(), strip.end());
      expect_read("a.ply", as_strips(band, {parted}, format, "ushort"), twice);
    }
  }
}

TEST(PlyDialects, strips_that_hold_no_triangle) {
  const PolygonSoup mesh = test::tetrahedron(1);
  expect_read("a.ply", as_strips(mesh, {{-1, 0, 1, -1, -1, 2, -1, 0, 1, 2}, {}, {3}}, "ascii"),
              {mesh.points, {{0, 1, 2}}},
              {"line 14: 3 strips of fewer than three corners set aside"});
  EXPECT_EQ(refusal_of("a.ply", as_strips(mesh, {{0, 1, -1, 2}}, "ascii")),
            ":14: no face or strip has more than two corners");
  EXPECT_EQ(refusal_of("a.ply", as_strips(mesh, {{0, 1, -2, 2}}, "ascii")),
            ":14: vertex index -2 is out of range (0 to 3)");
  const std::string bytes = as_strips(mesh, {{0, 1, 2, 4}}, "binary_big_endian");
  EXPECT_EQ(refusal_of("a.ply", bytes),
            ": byte " + std::to_string(bytes.size() - 4) +
                ": vertex index 4 in tristrips 1 of 1 is out of range (0 to 3)");
  EXPECT_EQ(
      refusal_of("a.ply", bytes.substr(0, bytes.size() - 1)),
      ": byte " + std::to_string(bytes.size() - 1) + ": the file ends inside tristrips 1 of 1");
}

// ------------------------------------------------------------------------------------------ others

TEST(PlyDialects, faces_of_fewer_than_three_corners_are_set_aside) {
  for (const PolygonSoup& mesh : dialect_meshes())
    for (const std::string format : formats) {
      PolygonSoup more = mesh;
      more.polygons.insert(more.polygons.begin(), {0, 1});
      const std::string bytes = as_ply(more, format, {});
      const std::size_t start = bytes.find("end_header\n") + 11;
      const std::string first = format == std::string("ascii")
                                    ? "line " + std::to_string(12 + mesh.points.size())
                                    : "byte " + std::to_string(start + 12 * mesh.points.size());
      expect_read("a.ply", bytes, mesh, {first + ": 1 face of two corners set aside"});
      more.polygons.push_back({});
      expect_read("a.ply", as_ply(more, format, {}), mesh,
                  {first + ": 2 faces of fewer than three corners set aside"});
    }
}

TEST(PlyDialects, headers_with_any_line_end_and_numbers_that_look_like_one) {
  // 10, '\n', is the first byte of the data, and 13, '\r', the second.
  PolygonSoup mesh = test::tetrahedron(1);
  mesh.points[0] = {0x0a + 0x0d * 256, 1, 2};
  for (const std::string format : {"binary_little_endian", "binary_big_endian"})
    for (const char* type : {"short", "int"})
      for (const char* end : {"\r", "\r\n", "\n"}) {
        const std::string bytes = as_ply(mesh, format, {type, "uchar", "int"});
        const std::size_t start = bytes.find("end_header\n") + 11;
        const std::string other =
            test::replaced(bytes.substr(0, start), "\n", end) + bytes.substr(start);
        const PolygonSoup want = test::read_bytes_as("a.ply", bytes);
        EXPECT_EQ(want.points[0], mesh.points[0]);
        expect_read("a.ply", other, want, want.remarks);
      }
}

TEST(PlyDialects, comments_before_the_format_and_bytes_after_the_end) {
  for (const PolygonSoup& mesh : dialect_meshes())
    for (const std::string format : formats) {
      const std::string bytes = as_ply(mesh, format, {});
      expect_read("a.ply", "ply\ncomment first\n" + bytes.substr(4), mesh);
      if (format == std::string("ascii")) continue;
      expect_read("a.ply", bytes + "\r\n", mesh,
                  {"2 bytes after the mesh, zeros or blanks, are not read"});
      EXPECT_EQ(refusal_of("a.ply", bytes + "more"), ": byte " + std::to_string(bytes.size()) +
                                                         ": 4 bytes more than the header declares");
    }
}

}  // namespace
}  // namespace sonde
