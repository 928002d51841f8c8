// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/repairs_text.hpp"

#include <QStringList>

#include "engine/mending/repair_sentences.hpp"
#include "ui/base/format.hpp"

namespace sonde::ui {
namespace {

QString counted(std::size_t n, const char* one, const char* more) {
  return QStringLiteral("%1 %2").arg(n).arg(QLatin1String(n == 1 ? one : more));
}

}  // namespace

QString repairs_in_brief(const Body& body) {
  const Repairs& r = body.repairs;
  QStringList done;
  const auto add = [&](std::size_t n, const char* one, const char* more) {
    if (n > 0) done << counted(n, one, more);
  };
  add(r.turned_triangles, "triangle turned", "triangles turned");
  if (r.turned_parts > 0 && r.turned_parts == r.parts)
    done << QStringLiteral("was inside out");
  else
    add(r.turned_parts, "part was inside out", "parts were inside out");
  add(r.caps, "opening closed", "openings closed");
  add(r.joined + r.on_edges, "corner joined", "corners joined");
  add(r.repeated, "repeated triangle", "repeated triangles");
  add(r.hidden, "triangle inside left out", "triangles inside left out");
  if (r.solid_parts > 0 && r.solid_parts < r.parts)
    add(r.parts - r.solid_parts, "part stays open", "parts stay open");
  if (r.could_be_solid)
    done << QStringLiteral("could be a solid (open by %1 %)").arg(number(100 * r.widest_mouth));
  return done.join(QStringLiteral(", "));
}

QString repairs_in_full(const Body& body) {
  QStringList lines;
  for (const std::string& sentence : sentences(body.repairs))
    lines << text(sentence) + QLatin1Char('.');
  if (body.repairs.could_be_solid)
    lines << QStringLiteral(
                 "Its widest opening is %1 % of what is seen of it from all around; "
                 "closed, it would bound an inside.")
                 .arg(number(100 * body.repairs.widest_mouth));
  lines << text(body.why) + QLatin1Char('.');
  if (!body.mass_why.empty())
    lines << QStringLiteral("As a probe it has its mass ") + text(body.mass_why) + QLatin1Char('.');
  return lines.join(QLatin1Char('\n'));
}

QString words(RepairKind kind) {
  switch (kind) {
    case RepairKind::cap:
      return QStringLiteral("opening closed");
    case RepairKind::turned:
      return QStringLiteral("triangles turned");
    case RepairKind::inside_out:
      return QStringLiteral("part turned: it was inside out");
    case RepairKind::hidden:
      return QStringLiteral("triangles inside, left out");
    case RepairKind::repeated:
      return QStringLiteral("repeated triangles");
    case RepairKind::seam:
      return QStringLiteral("corners joined");
  }
  return {};
}

}  // namespace sonde::ui
