// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "engine/mesh_io/off_parts.hpp"

namespace sonde {
namespace {

class BinaryOff {
 public:
  BinaryOff(const BinaryScanner& scan, std::size_t extras) : scan_(scan), extras_(extras) {}

  PolygonSoup read() {
    const std::size_t start = scan_.position();
    scan_.need(3 * word, [] { return std::string("the numbers of vertices and faces"); });
    const OffCounts counts{scan_.take<std::uint32_t>(), scan_.take<std::uint32_t>()};
    scan_.skip(word);  // of edges
    const std::string fault = fault_of(counts, scan_.bytes_left(), (3 + extras_) * word, 5 * word);
    if (!fault.empty()) scan_.refuse_at(start, fault);
    PolygonSoup out;
    out.points.reserve(counts.vertices);
    for (std::uint64_t i = 0; i < counts.vertices; ++i) out.points.push_back(point(i, counts));
    out.polygons.reserve(counts.faces);
    for (std::uint64_t i = 0; i < counts.faces; ++i) {
      const std::size_t at = scan_.position();
      Polygon one = face(i, counts);
      if (one.size() < 3)
        thin_.add(at, one.size());
      else
        out.polygons.push_back(std::move(one));
    }
    scan_.check_end(out.remarks);
    remark(out.remarks, "byte", thin_);
    if (out.polygons.empty())
      scan_.refuse_at(thin_.tally.first, "no face has more than two corners");
    return out;
  }

 private:
  static constexpr std::uint64_t word = 4;  // bytes

  static std::string name(const char* what, std::uint64_t i, std::uint64_t of) {
    return std::string(what) + " " + std::to_string(i + 1) + " of " + std::to_string(of);
  }

  Vec3 point(std::uint64_t i, const OffCounts& counts) {
    scan_.report(i);
    scan_.need((3 + extras_) * word, [&] { return name("vertex", i, counts.vertices); });
    Vec3 x;
    for (double& c : x) {
      c = static_cast<double>(scan_.take<float>());
      if (!std::isfinite(c))
        scan_.refuse_at(scan_.position() - word,
                        "a coordinate of " + name("vertex", i, counts.vertices) + " is not finite");
    }
    scan_.skip(extras_ * word);
    return x;
  }

  Polygon face(std::uint64_t i, const OffCounts& counts) {
    scan_.report(i);
    const auto own_name = [&] { return name("face", i, counts.faces); };
    scan_.need(word, own_name);
    const std::uint64_t corners = scan_.take<std::uint32_t>();
    scan_.need((corners + 1) * word, own_name);
    Polygon out(corners);
    for (std::size_t& corner : out) {
      corner = scan_.take<std::uint32_t>();
      if (corner >= counts.vertices)
        scan_.refuse_at(scan_.position() - word, "vertex index " + std::to_string(corner) + " in " +
                                                     own_name() + " is out of range (0 to " +
                                                     std::to_string(counts.vertices - 1) + ")");
    }
    const std::uint64_t colours = scan_.take<std::uint32_t>();
    scan_.need(colours * word, own_name);
    scan_.skip(colours * word);
    return out;
  }

  BinaryScanner scan_;
  std::size_t extras_;
  ThinFaces thin_;
};

}  // namespace

PolygonSoup read_binary_off(BinaryScanner scan, std::size_t extras) {
  return BinaryOff(scan, extras).read();
}

}  // namespace sonde
