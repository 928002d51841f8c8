// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/response.hpp"

#include "engine/queries/pose_numbers.hpp"
#include "engine/text/csv_rows.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

/// Some hours at 1 kHz; more would only take longer.
constexpr std::size_t most_bytes = std::size_t{1} << 30;

}  // namespace

Response read_response(const std::filesystem::path& file) {
  Response out;
  read_csv_rows(file, response_columns, most_bytes, [&](std::span<const double> row) {
    if (!out.empty()) expect_later(row[0], out.back().t);
    out.push_back({row[0],
                   {.force = {row[1], row[2], row[3]}, .torque = {row[4], row[5], row[6]}},
                   pose_of_numbers(row.last<7>())});
  });
  return out;
}

std::string response_text(const Response& response) {
  std::string out;
  for (const std::string_view name : response_columns)
    out.append(out.empty() ? "" : ",").append(name);
  for (const ResponseSample& s : response) {
    out += '\n' + number_text(s.t);
    const Quat& q = s.X_BH.q;
    const Vec3 &f = s.command.force, &m = s.command.torque, &p = s.X_BH.p;
    for (const double x : {f.x(), f.y(), f.z(), m.x(), m.y(), m.z(), p.x(), p.y(), p.z(), q.w(),
                           q.x(), q.y(), q.z()})
      out += ',' + number_text(x);
  }
  return out + '\n';
}

}  // namespace sonde
