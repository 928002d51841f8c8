// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/loop/tick_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"

namespace sonde::ticks {
namespace {

/// Nearest rank; 0 where there are none.
double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(1.0, rank)) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

bool in_contact(const Tick& tick) { return tick.separation.status == Status::penetrating; }

Wrench wrench(const TickCase& c, const Tick& tick) {
  if (!in_contact(tick)) return {};
  return object_norm_wrench(c.probe->mass, tick.separation.device, tick.separation.separated, c.k);
}

struct Forces {
  double tangential = 0;  ///< largest ratio to the normal force
  double least_up = 0;    ///< N
  double work = 0;        ///< on the hand, in parts of the largest energy stored
  double lost = 0;        ///< neither stored nor given back, but for the ticks that jumped
};

Forces forces(const TickCase& c, const std::vector<Tick>& ticks) {
  double deepest = 0;
  for (const Tick& tick : ticks) deepest = std::max(deepest, tick.separation.depth);
  Forces out;
  double given = 0, lost = 0, stored = 0;
  Wrench last;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const Wrench now = wrench(c, ticks[i]);
    const double normal = now.force.dot(c.up);
    out.least_up = std::min(out.least_up, normal);
    // As good as no force has no direction either.
    if (in_contact(ticks[i]) && ticks[i].separation.depth > 1e-4 * deepest)
      out.tangential =
          std::max(out.tangential, (now.force - normal * c.up).norm() / std::abs(normal));
    const double energy = 0.5 * c.k * ticks[i].separation.sigma;
    if (i > 0) {
      const SeparationMotion step =
          separation_motion(c.probe->mass, c.path[i - 1].pose, c.path[i].pose);
      const double done = 0.5 * (now.force + last.force).dot(step.t) +
                          0.5 * (now.torque + last.torque).dot(step.theta);
      given += done;
      if (!ticks[i].separation.jumped) lost += stored - energy - done;
    }
    stored = energy;
    last = now;
  }
  const double largest = 0.5 * c.k * deepest * deepest;
  if (largest > 0) {
    out.work = given / largest;
    out.lost = lost / largest;
  }
  return out;
}

std::string text(const char* format, double value) {
  char out[64];
  std::snprintf(out, sizeof out, format, value);
  return out;
}

}  // namespace

std::string table_head() {
  return "| scene | triangles | in contact | median | in contact | p99 | p99.9 | longest | jumps "
         "| not converged | steps | p99.9 in contact | not converged in contact, % "
         "| tangential / normal | least force up, N | work on the hand, % | lost but at jumps, % "
         "| longest not converged, ticks |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
}

std::string table_row(const TickCase& c, const std::vector<Tick>& ticks) {
  std::vector<double> all, contact;
  int jumps = 0, unconverged = 0, unconverged_in_contact = 0, steps = 0;
  int in_a_row = 0, most_in_a_row = 0;
  for (const Tick& t : ticks) {
    all.push_back(t.us);
    if (in_contact(t)) contact.push_back(t.us);
    jumps += t.separation.jumped;
    unconverged += !t.separation.converged;
    in_a_row = t.separation.converged ? 0 : in_a_row + 1;
    most_in_a_row = std::max(most_in_a_row, in_a_row);
    unconverged_in_contact += in_contact(t) && !t.separation.converged;
    steps += t.separation.iterations;
  }
  const Forces f = forces(c, ticks);
  const double share =
      contact.empty() ? 0 : 100.0 * unconverged_in_contact / static_cast<double>(contact.size());
  std::string out = "| " + c.name;
  const auto cell = [&](const std::string& words) { out.append(" | ").append(words); };
  cell(std::to_string(c.probe->soup.triangles.size()) + ", " +
       std::to_string(c.fixed->soup.triangles.size()));
  cell(std::to_string(contact.size()) + " of " + std::to_string(all.size()));
  for (const double us : {percentile(all, 0.5), percentile(contact, 0.5), percentile(all, 0.99),
                          percentile(all, 0.999), percentile(all, 1)})
    cell(text("%.0f", us));
  for (const int count : {jumps, unconverged, steps}) cell(std::to_string(count));
  cell(text("%.0f", percentile(contact, 0.999)));
  cell(text("%.2f", share));
  cell(c.flat_contact ? text("%.3g", f.tangential) : "–");
  cell(text("%.3g", f.least_up));
  cell(text("%.2f", 100 * f.work));
  cell(text("%.2f", 100 * f.lost));
  cell(std::to_string(most_in_a_row));
  return out + " |\n";
}

void write_csv(const std::string& file, const TickCase& c, const std::vector<Tick>& ticks) {
  std::FILE* out = std::fopen(file.c_str(), "w");
  if (!out) throw std::runtime_error(file + " cannot be written");
  std::fputs("us,depth,iterations,converged,jumped,contacts,residual,fx,fy,fz,tx,ty,tz\n", out);
  for (const Tick& t : ticks) {
    const Wrench w = wrench(c, t);
    std::fprintf(out, "%.1f,%.17g,%d,%d,%d,%d,%.3g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", t.us,
                 t.separation.depth, t.separation.iterations, t.separation.converged,
                 t.separation.jumped, t.separation.contacts.size, t.separation.residual,
                 w.force.x(), w.force.y(), w.force.z(), w.torque.x(), w.torque.y(), w.torque.z());
  }
  std::fclose(out);
}

}  // namespace sonde::ticks
