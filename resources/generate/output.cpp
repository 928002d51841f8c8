// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/output.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace sonde::generate {
namespace {

constexpr double sample_rate_hz = 1000;

/// Positions and quaternions are written in whole multiples of 1e-9. The last bits of a sine differ
/// from one C library to the next; what is written does not.
constexpr double steps_per_unit = 1e9;

/// The shortest decimal that reads back as the same double, whatever the locale.
std::string number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string on_grid(double value) {
  const double steps = std::round(value * steps_per_unit);
  return number(steps == 0 ? 0 : steps / steps_per_unit);
}

std::string list(std::initializer_list<double> values, const std::string& separator) {
  std::string out;
  for (const double value : values) out += (out.empty() ? "" : separator) + on_grid(value);
  return out;
}

std::string pose_list(const Pose& X, const std::string& separator) {
  return list({X.p.x(), X.p.y(), X.p.z(), X.q.w(), X.q.x(), X.q.y(), X.q.z()}, separator);
}

std::string vector_list(const Vec3& x) {
  std::string out = "[";
  out += list({x.x(), x.y(), x.z()}, ", ");
  return out += "]";
}

void put32(std::string& out, std::uint32_t bits) {
  for (unsigned byte = 0; byte < 4; ++byte)
    out.push_back(static_cast<char>(bits >> (8 * byte) & 0xffU));
}

void write(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw std::runtime_error("cannot write " + file.string());
}

std::string path_text(const Path& path) {
  std::string out = "t,px,py,pz,qw,qx,qy,qz\n";
  const auto samples = static_cast<int>(std::lround(path.duration() * sample_rate_hz));
  for (int i = 0; i <= samples; ++i) {
    const double t = i / sample_rate_hz;
    out += number(t) + "," + pose_list(path.at(t), ",") + "\n";
  }
  return out;
}

}  // namespace

Output::Output(std::filesystem::path root) : root_(std::move(root)) {}

void Output::mesh(const std::string& file, const Soup& soup) const {
  std::string out =
      "ply\nformat binary_little_endian 1.0\ncomment an example model of Sonde, in metres\n";
  out += "element vertex " + std::to_string(soup.vertices.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\n";
  out += "element face " + std::to_string(soup.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& x : soup.vertices)
    for (const double value : {x.x(), x.y(), x.z()})
      // Adding zero turns a negative zero, which a library might or might not give, into zero.
      put32(out, std::bit_cast<std::uint32_t>(static_cast<float>(value) + 0.0F));
  for (const Triangle& t : soup.triangles) {
    out.push_back(3);
    for (const std::uint32_t index : t) put32(out, index);
  }
  write(root_ / "models" / file, out);
}

void Output::scene(const SceneText& text, const Path& path) const {
  const std::string path_name = text.name + ".path.csv";
  std::string out = "{\n  \"unit\": \"m\",\n";
  out += "  \"probe\": {\n    \"mesh\": \"../models/" + text.probe + "\",\n";
  out += "    \"model\": \"auto\",\n    \"pose\": [" + pose_list(path.at(0), ", ") + "]\n  },\n";
  out += "  \"fixed\": {\n    \"mesh\": \"../models/" + text.fixed + "\",\n";
  out += "    \"model\": \"" + text.model + "\",\n    \"pose\": [0, 0, 0, 1, 0, 0, 0]\n  },\n";
  out += "  \"trajectory\": \"" + path_name + "\",\n";
  out += "  \"coupling\": {\n    \"mode\": \"object\",\n    \"k\": " + number(text.k) +
         ",\n    \"max_force\": 10,\n    \"max_torque\": 0.5\n  },\n";
  out += "  \"view\": {\n    \"direction\": " + vector_list(text.view) +
         ",\n    \"up\": [0, 0, 1]\n  }\n}\n";
  write(root_ / "scenes" / (text.name + ".sonde.json"), out);
  write(root_ / "scenes" / path_name, path_text(path));
}

}  // namespace sonde::generate
