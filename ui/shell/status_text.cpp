// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/status_text.hpp"

#include "engine/body/body.hpp"
#include "engine/offset/offset_faces.hpp"

namespace sonde::ui {
namespace {

QString nature(const char* role, const Body& body) {
  QString text = QStringLiteral("%1: %2 (%3)")
                     .arg(QLatin1String(role),
                          body.solid ? QStringLiteral("solid") : QStringLiteral("surface"),
                          QString::fromStdString(body.why));
  if (body.repairs.any()) text += QStringLiteral(", mended");
  if (body.degenerate > 0)
    text += QStringLiteral(", %1 triangles without area set aside").arg(body.degenerate);
  if (const std::string words = offset_words(body.offset); !words.empty())
    text += QStringLiteral(", ") + QString::fromStdString(words);
  return text;
}

}  // namespace

QString natures(const Body& probe, const Body& fixed) {
  QString of_probe = nature("Probe", probe);
  if (!probe.mass_why.empty())
    of_probe += QStringLiteral(", mass ") + QString::fromStdString(probe.mass_why);
  return of_probe + QStringLiteral("   ") + nature("Fixed body", fixed);
}

QString happening(const Instant& now, const LengthUnit& unit) {
  const Snapshot& s = now.snapshot;
  QString happens;
  if (s.paused)
    happens = QStringLiteral("Paused.");
  else if (s.hand.withheld == Withheld::failed)
    happens =
        QStringLiteral("No force (%1: %2).")
            .arg(QString::fromUtf8(words(s.hand.withheld)), QLatin1String(s.separation.reason));
  else if (s.hand.withheld != Withheld::nothing)
    happens = QStringLiteral("No force (%1).").arg(QString::fromUtf8(words(s.hand.withheld)));
  else if (const GaugedClearance* room = clearance_here(now))
    happens = QStringLiteral("Free, %1 clear.").arg(unit.text(room->distance));
  else if (s.separation.status == Status::separated)
    happens = QStringLiteral("Free.");
  else
    happens = QStringLiteral("In contact, %1 deep.").arg(unit.text(s.separation.depth));
  if (const char* way = now.searched ? words(way_out(s.separation, *now.searched)) : ""; *way != 0)
    happens += QLatin1Char(' ') + QString::fromUtf8(way);
  return happens;
}

}  // namespace sonde::ui
