// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <zlib.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/engine/mesh_io/mesh_files.hpp"

namespace sonde::test {

// The formats as their specifications have them, written without any of the code under test.

/// A glTF file of one mesh: its tree, whose nodes a test sets, and its data.
struct GltfFile {
  nlohmann::json tree;
  std::string data;
};

inline GltfFile gltf_of(const PolygonSoup& triangles, const nlohmann::json& nodes,
                        const nlohmann::json& roots) {
  GltfFile out;
  for (const Vec3& x : triangles.points)
    for (const double c : x) out.data += raw(static_cast<float>(c));
  const std::size_t points = out.data.size();
  for (const Polygon& polygon : triangles.polygons)
    for (const std::size_t i : polygon) out.data += raw(static_cast<std::uint16_t>(i));
  const std::size_t corners = (out.data.size() - points) / 2;
  out.data.resize((out.data.size() + 3) / 4 * 4);
  out.tree = {
      {"asset", {{"version", "2.0"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", roots}}}},
      {"nodes", nodes},
      {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
      {"accessors",
       {{{"bufferView", 0},
         {"componentType", 5126},
         {"count", triangles.points.size()},
         {"type", "VEC3"}},
        {{"bufferView", 1}, {"componentType", 5123}, {"count", corners}, {"type", "SCALAR"}}}},
      {"bufferViews",
       {{{"buffer", 0}, {"byteLength", points}},
        {{"buffer", 0}, {"byteOffset", points}, {"byteLength", 2 * corners}}}},
      {"buffers", {{{"byteLength", out.data.size()}}}}};
  return out;
}

inline std::string as_glb(const GltfFile& file) {
  std::string text = file.tree.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto whole = [](std::size_t n) { return raw(static_cast<std::uint32_t>(n)); };
  return "glTF" + whole(2) + whole(28 + text.size() + file.data.size()) + whole(text.size()) +
         "JSON" + text + whole(file.data.size()) + std::string("BIN\0", 4) + file.data;
}

inline std::string base64(const std::string& bytes) {
  static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += at + k > bytes.size() ? '=' : letters[three >> (18 - 6 * k) & 63];
  }
  return out;
}

/// Text, with the data inside.
inline std::string as_gltf(GltfFile file) {
  file.tree["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(file.data);
  return file.tree.dump();
}

/// A ZIP file of these parts, name and text.
inline std::string as_zip(const std::vector<std::pair<std::string, std::string>>& parts,
                          bool deflated = true) {
  std::string out, directory;
  const auto two = [](std::size_t n) { return raw(static_cast<std::uint16_t>(n)); };
  const auto four = [](std::size_t n) { return raw(static_cast<std::uint32_t>(n)); };
  for (const auto& [name, text] : parts) {
    std::string packed = text;
    if (deflated) {
      packed.resize(compressBound(static_cast<uLong>(text.size())) + 64);
      z_stream stream{};
      deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
      stream.avail_in = static_cast<uInt>(text.size());
      stream.next_out = reinterpret_cast<Bytef*>(packed.data());
      stream.avail_out = static_cast<uInt>(packed.size());
      deflate(&stream, Z_FINISH);
      packed.resize(stream.total_out);
      deflateEnd(&stream);
    }
    const uLong sum =
        crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
    const std::string head = two(10) + two(0) + two(deflated ? 8 : 0) + four(0) + four(sum) +
                             four(packed.size()) + four(text.size()) + two(name.size()) + two(0);
    directory +=
        "PK\1\2" + two(10) + head + two(0) + two(0) + two(0) + four(0) + four(out.size()) + name;
    out += "PK\3\4" + head + name + packed;
  }
  const std::size_t at = out.size();
  return out + directory + "PK\5\6" + four(0) + two(parts.size()) + two(parts.size()) +
         four(directory.size()) + four(at) + two(0);
}

/// A 3MF package whose model is this text.
inline std::string as_3mf(const std::string& model, bool deflated = true) {
  return as_zip(
      {{"[Content_Types].xml",
        "<?xml version=\"1.0\"?><Types "
        "xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"/>"},
       {"_rels/.rels",
        "<?xml version=\"1.0\"?><Relationships "
        "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
        "Target=\"/3D/part.model\" Id=\"r\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
       {"3D/part.model", model}},
      deflated);
}

inline std::string xml_3mf(const std::string& attributes, const std::string& resources,
                           const std::string& build) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model " + attributes +
         " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n<resources>" +
         resources + "</resources>\n<build>" + build + "</build>\n</model>\n";
}

inline std::string object_3mf(const PolygonSoup& triangles, const std::string& id) {
  auto out = exact_stream();
  out << "<object id=\"" << id << "\" type=\"model\"><mesh><vertices>";
  for (const Vec3& x : triangles.points)
    out << "<vertex x=\"" << x.x() << "\" y=\"" << x.y() << "\" z=\"" << x.z() << "\"/>";
  out << "</vertices><triangles>";
  for (const Polygon& t : triangles.polygons)
    out << "<triangle v1=\"" << t[0] << "\" v2=\"" << t[1] << "\" v3=\"" << t[2] << "\"/>";
  out << "</triangles></mesh></object>";
  return out.str();
}

/// A COLLADA file of one geometry, "g", and these nodes.
inline std::string as_dae(const PolygonSoup& soup, const std::string& unit, const std::string& up,
                          const std::string& nodes) {
  auto out = exact_stream();
  out << "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\""
         " version=\"1.4.1\">\n<asset>"
      << unit << "<up_axis>" << up << "</up_axis></asset>\n<library_geometries><geometry id=\"g\">"
      << "<mesh><source id=\"p\"><float_array id=\"a\" count=\"" << 3 * soup.points.size() << "\">";
  for (const Vec3& x : soup.points) out << x.x() << ' ' << x.y() << ' ' << x.z() << ' ';
  out << "</float_array><technique_common><accessor source=\"#a\" count=\"" << soup.points.size()
      << "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
         "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>"
         "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
         "<polylist count=\""
      << soup.polygons.size()
      << "\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><vcount>";
  for (const Polygon& polygon : soup.polygons) out << polygon.size() << ' ';
  out << "</vcount><p>";
  for (const Polygon& polygon : soup.polygons)
    for (const std::size_t i : polygon) out << i << ' ';
  out << "</p></polylist></mesh></geometry></library_geometries>\n<library_visual_scenes>"
         "<visual_scene id=\"s\">"
      << nodes
      << "</visual_scene></library_visual_scenes>\n<scene><instance_visual_scene "
         "url=\"#s\"/></scene></COLLADA>\n";
  return out.str();
}

}  // namespace sonde::test
