// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/repairs_control.hpp"

#include <QLayout>

#include "ui/actions/document_control.hpp"
#include "ui/base/format.hpp"
#include "ui/document/session.hpp"
#include "ui/panels/repairs_text.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

/// Whether a mesh has anything to be mended: as the engine sees it before it mends.
bool is_sound(const Body& body) {
  const Topology& t = body.topology;
  return t.closed && t.nonmanifold_edges == 0 && t.duplicate_triangles == 0 &&
         body.component_triangle.size() == 1;
}

/// Of more places than are kept, how many there are.
QString more_text(const RepairPlaces& places) {
  if (places.all == places.places.size()) return {};
  return QStringLiteral(" (the first of %1)").arg(static_cast<qulonglong>(places.all));
}

Role role_of(std::size_t body) { return body == RepairsBar::probe ? Role::probe : Role::fixed; }

}  // namespace

RepairsControl::RepairsControl(Viewport& viewport, DocumentControl& documents, QWidget& window)
    : QObject(&window),
      viewport_(viewport),
      documents_(documents),
      bar_(new RepairsBar(&window)),
      notice_(new RepairsNotice(&window)),
      flight_(viewport, this) {
  connect(bar_, &RepairsBar::show_wanted, this, qOverload<std::size_t>(&RepairsControl::show_next));
  connect(bar_, &RepairsBar::repair_wanted, this, &RepairsControl::repair);
  connect(bar_, &RepairsBar::close_wanted, this, &RepairsControl::close_openings);
  connect(bar_, &RepairsBar::put_away, this, &RepairsControl::put_away);
}

void RepairsControl::repair(std::size_t body, bool as_in_file) {
  documents_.set_repair(role_of(body), as_in_file ? Repair::none : Repair::automatic);
}

void RepairsControl::close_openings(std::size_t body) { documents_.make_solid(role_of(body)); }

void RepairsControl::put_away() {
  set_away(true);
  viewport_.canvas()->setFocus();
}

void RepairsControl::attach(Session* session, bool same_document) {
  session_ = session;
  flight_.stop();
  next_ = {};
  last_ = RepairsBar::probe;
  if (!same_document) set_away(true);
  show_rows();
}

void RepairsControl::set_away(bool away) {
  if (away == away_) return;
  away_ = away;
  show_rows();
  emit away_changed(away);
}

const Body& RepairsControl::body(std::size_t index) const {
  return index == RepairsBar::probe ? session_->probe() : session_->fixed();
}

std::optional<RepairsRow> RepairsControl::row_of(std::size_t index) const {
  if (!session_) return {};
  const Body& body = this->body(index);
  const bool is_probe = index == RepairsBar::probe;
  const Scene& scene = session_->loaded().scene;
  const SceneBody& wanted = is_probe ? scene.probe : scene.fixed;
  if (wanted.model == Model::surface) return {};
  RepairsRow row;
  row.name = short_name(body);
  row.in_full = repairs_in_full(body);
  row.as_in_file = wanted.repair == Repair::none;
  if (row.as_in_file) {
    if (is_sound(body)) return {};
    row.text = QStringLiteral("taken as in the file");
    return row;
  }
  row.text = repairs_in_brief(body);
  if (row.text.isEmpty()) return {};
  row.can_show = !body.places.places.empty();
  row.can_be_as_in_file = row.can_show && !is_sound(body);
  row.can_close = body.repairs.could_be_solid && wanted.model == Model::automatic;
  return row;
}

void RepairsControl::show_rows() {
  const std::optional<RepairsRow> probe = row_of(RepairsBar::probe),
                                  fixed = row_of(RepairsBar::fixed);
  bar_->show_row(RepairsBar::probe, probe);
  bar_->show_row(RepairsBar::fixed, fixed);
  notice_->show_row(RepairsBar::probe, probe);
  notice_->show_row(RepairsBar::fixed, fixed);
  bar_->setVisible(!away_ && (probe || fixed));
  // The view has its size before anything is fitted into it.
  if (QWidget* around = bar_->parentWidget(); around && around->layout())
    around->layout()->activate();
  viewport_.invalidate();
}

void RepairsControl::show_next() {
  if (!session_) return;
  for (const std::size_t index : {last_, 1 - last_, last_}) {
    const bool has_more = next_.at(index) < body(index).places.places.size();
    if (has_more) return show_next(index);
    next_.at(index) = 0;  // through: the other one, and then it again
  }
  emit say(QStringLiteral("Nothing was mended."));
}

void RepairsControl::show_next(std::size_t index) {
  if (!session_) return;
  const Body& body = this->body(index);
  const RepairPlaces& all = body.places;
  if (all.places.empty()) return;
  last_ = index;
  std::size_t& next = next_.at(index);
  if (next >= all.places.size()) next = 0;
  const RepairPlace& place = all.places[next];
  const QString count = QStringLiteral("%1 of %2").arg(++next).arg(all.places.size());
  const QString in_full = count + more_text(all);
  const PointedPlace pointed{index == RepairsBar::probe, place.at, place.outward, place.size,
                             QStringLiteral("%1: %2").arg(in_full, words(place.kind))};
  bar_->show_places(index, count, in_full);
  flight_.show(pointed);
  emit say(
      QStringLiteral("%1, %2, %3 across")
          .arg(short_name(body), pointed.text, LengthUnit(body.mass.radius).text(2 * place.size)));
}

}  // namespace sonde::ui
