// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/written_pair.hpp"

#include <string>

#include "engine/text/number_text.hpp"
#include "engine/text/output_file.hpp"

namespace sonde::reference {
namespace {

std::string off_text(const Soup& soup) {
  std::string out = "OFF\n" + std::to_string(soup.vertices.size()) + " " +
                    std::to_string(soup.triangles.size()) + " 0\n";
  for (const Vec3& v : soup.vertices)
    out += number_text(v.x()) + " " + number_text(v.y()) + " " + number_text(v.z()) + "\n";
  for (const Triangle& t : soup.triangles)
    out += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
           "\n";
  return out;
}

std::string poses_text(std::span<const Row> rows) {
  std::string out = "px,py,pz,qw,qx,qy,qz\n";
  for (const Row& row : rows) {
    const Vec3& p = row.pose.p;
    const Quat& q = row.pose.q;
    for (const double x : {p.x(), p.y(), p.z(), q.w(), q.x(), q.y()}) out += number_text(x) + ",";
    out += number_text(q.z()) + "\n";
  }
  return out;
}

}  // namespace

void write_pair(const std::filesystem::path& folder, const Body& probe, const Body& fixed,
                std::span<const Row> rows) {
  const std::string path = (folder / rows.front().pair).string();
  write_whole(path + ".probe.off", off_text(probe.soup));
  write_whole(path + ".fixed.off", off_text(fixed.soup));
  write_whole(path + ".csv", poses_text(rows));
}

}  // namespace sonde::reference
