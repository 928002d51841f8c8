// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/seeing_control.hpp"

#include <QMainWindow>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/proximity/queries/point_distance.hpp"
#include "ui/actions/click_taker.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/view_pick.hpp"
#include "ui/document/saved_views.hpp"
#include "ui/panels/contacts_panel.hpp"
#include "ui/panels/seeing_panel.hpp"
#include "ui/views/glyphs.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr double near_contact = 12;   // pixels
constexpr double follow_part = 0.15;  // of what is left, a frame: the picture glides
constexpr double follow_still = 0.5;  // pixels
constexpr double least_arm = 0.05;    // of the probe's radius, beside the contact's normal

/// The middle of what pushes: the contacts by what they carry.
std::optional<Vec3> middle_of(const Separation& separation) {
  if (separation.status != Status::penetrating) return {};
  Vec3 sum = Vec3::Zero();
  double weight = 0;
  for (const ContactCluster& c : separation.clusters) {
    sum += c.contact.multiplier * c.contact.on_fixed;
    weight += c.contact.multiplier;
  }
  if (!(weight > 0)) return {};
  return Vec3(sum / weight);
}

}  // namespace

SeeingControl::SeeingControl(Viewport& viewport, DocumentControl& documents, QMainWindow& window,
                             QDockWidget& beside)
    : QObject(&window),
      viewport_(viewport),
      documents_(documents),
      panel_(new SeeingPanel(&window)),
      contacts_(new ContactsPanel(&window)),
      pick_(new ViewPick(viewport, this)),
      gaps_(viewport),
      crossings_(viewport, window) {
  connect(&crossings_, &CrossingFinder::say, this, &SeeingControl::say);
  window.addDockWidget(window.dockWidgetArea(&beside), panel_);
  window.addDockWidget(window.dockWidgetArea(&beside), contacts_);
  connect(panel_, &SeeingPanel::changed, this, &SeeingControl::set_seeing);
  connect(panel_, &SeeingPanel::snap_wanted, this, &SeeingControl::snap_cut);
  connect(panel_, &SeeingPanel::face_wanted, this, &SeeingControl::face_cut);
  connect(panel_, &SeeingPanel::gap_reach_changed, this,
          [this](std::optional<double> reach) { gaps_.set_reach(reach); });
  connect(panel_, &SeeingPanel::save_wanted, this, &SeeingControl::save_view);
  connect(panel_, &SeeingPanel::view_wanted, this, &SeeingControl::go_to_view);
  connect(panel_, &SeeingPanel::forget_wanted, this, &SeeingControl::forget_view);
  connect(contacts_, &ContactsPanel::chosen_changed, &viewport_, &Viewport::choose_contact);
  connect(pick_, &ViewPick::picked, this, &SeeingControl::measure);
  connect(pick_, &ViewPick::clicked, this, &SeeingControl::click);
  connect(pick_, &ViewPick::cut_moved, this, &SeeingControl::move_cut);
  connect(pick_, &ViewPick::cut_turned, this, &SeeingControl::turn_cut);
}

SeeingControl::~SeeingControl() = default;

void SeeingControl::attach(Session* session) {
  const bool first = session && !session_;
  session_ = session;
  gaps_.attach(session);
  crossings_.attach(session);
  viewport_.choose_contact(0);
  contacts_->choose(0);
  if (!session) return;
  const MassProperties& mass = session->fixed().mass;
  contacts_->take(session->loaded().pair);
  panel_->set_extent(mass.com, mass.radius);
  if (first || !seeing_.cut.on) seeing_.cut.point = mass.com;
  set_seeing(seeing_);
  show_saved();
}

void SeeingControl::set_seeing(const Seeing& seeing) {
  seeing_ = seeing;
  viewport_.set_seeing(seeing);
  panel_->show_seeing(seeing);
  emit changed();
}

void SeeingControl::move_cut(double along) {
  Seeing seeing = seeing_;
  seeing.cut.point += seeing.cut.normal * along;
  set_seeing(seeing);
}

void SeeingControl::turn_cut(const Vec3& turn) {
  Seeing seeing = seeing_;
  if (const double angle = turn.norm(); angle > 0)
    seeing.cut.normal = (Eigen::AngleAxisd(angle, turn / angle) * seeing.cut.normal).normalized();
  set_seeing(seeing);
}

void SeeingControl::set_cut(bool on) {
  Seeing seeing = seeing_;
  seeing.cut.on = on;
  set_seeing(seeing);
}

void SeeingControl::set_measuring(bool on) {
  pick_->set_measuring(on);
  if (!on) viewport_.clear_measured();
  viewport_.set_shown(Layer::measures, on);
}

const ContactCluster* SeeingControl::leading() const {
  const ContactCluster* best = nullptr;
  if (shown_.status != Status::penetrating) return best;
  for (const ContactCluster& c : shown_.clusters) {
    if (c.id != 0 && c.id == contacts_->chosen()) return &c;
    if (!best || c.contact.multiplier > best->contact.multiplier) best = &c;
  }
  return best;
}

/// Both bodies are cut, by a plane through the contact along its normal and through the probe's
/// centre of mass: there both are thick. Where these are in one line, it is seen as openly as that
/// allows. One looks at the contact from the side, and what lies before it is cut away.
void SeeingControl::snap_cut() {
  const ContactCluster* contact = leading();
  if (!contact) {
    emit say(QStringLiteral("There is no contact to cut through."));
    return;
  }
  Seeing seeing = seeing_;
  const Vec3& n = contact->contact.normal;
  const Vec3& at = contact->contact.on_fixed;
  const Vec3 towards = viewport_.camera().axes().towards;
  const MassProperties& mass = session_->probe().mass;
  const Vec3 arm = (shown_.device * mass.com - at) / mass.radius;
  Vec3 normal = n.cross(arm);
  if (normal.norm() < least_arm) normal = towards - n * n.dot(towards);
  if (!(normal.norm() > 1e-6)) normal = any_normal(n);
  if (normal.dot(towards) < 0) normal = -normal;
  seeing.cut = {true, true, true, at, normal.normalized()};
  set_seeing(seeing);
}

void SeeingControl::face_cut() {
  Seeing seeing = seeing_;
  seeing.cut.on = true;
  seeing.cut.normal = viewport_.camera().axes().towards;
  set_seeing(seeing);
}

void SeeingControl::frame(const Snapshot& snapshot) {
  shown_ = snapshot.separation;
  wrench_ = snapshot.wrench;
  gaps_.frame(shown_);
  if (follow_) follow(snapshot);
}

void SeeingControl::follow(const Snapshot& snapshot) {
  const Vec3 to = middle_of(snapshot.separation)
                      .value_or(snapshot.separation.device * session_->probe().mass.com);
  const Vec3 way = to - viewport_.camera().target();
  if (way.norm() < follow_still * viewport_.metres_per_pixel(to)) return;
  viewport_.camera().pan(follow_part * way);
  viewport_.invalidate();
}

void SeeingControl::show_numbers(const Snapshot& snapshot) {
  if (contacts_->isVisible()) contacts_->show_contacts(snapshot.separation, snapshot.wrench);
}

void SeeingControl::measure(QPointF at) {
  emit touched(at);
  const auto hit = viewport_.pick(at);
  if (!hit || !session_) return;
  const Body& other = hit->on_probe ? session_->fixed() : session_->probe();
  const Pose& device = shown_.device;
  const Vec3 there = hit->on_probe ? device * hit->x : inverse(device) * hit->x;
  viewport_.add_measured({hit->on_probe, hit->x, point_distance(other, there)});
}

void SeeingControl::click(QPointF at) {
  emit touched(at);
  if (!session_) return;
  for (ClickTaker* taker : takers_)
    if (taker->click(at)) return;
  const ContactCluster* best = nullptr;
  double nearest = near_contact;
  for (const ContactCluster& c : shown_.clusters) {
    if (shown_.status != Status::penetrating) break;
    const QPointF away = viewport_.on_screen(c.contact.on_fixed) - at;
    const double distance = std::hypot(away.x(), away.y());
    if (distance < nearest) nearest = distance, best = &c;
  }
  if (best) return choose_contact(best->id == contacts_->chosen() ? 0 : best->id);
  emit clicked(at);
}

void SeeingControl::choose_contact(std::uint64_t id) {
  contacts_->show_contacts(shown_, wrench_);
  contacts_->choose(id);
  viewport_.choose_contact(id);
}

void SeeingControl::look_from(const Vec3& direction, const Vec3& up) {
  const double distance = viewport_.camera().distance();
  viewport_.camera().look_at(viewport_.camera().target(), direction, up, distance);
  viewport_.fit();
}

void SeeingControl::show_saved() {
  QStringList names;
  for (const SavedView& view : saved_views(documents_.document().content().scene))
    names << view.name;
  panel_->show_saved(names);
}

void SeeingControl::change_views(const QString& what,
                                 const std::function<bool(std::vector<SavedView>&)>& change) {
  if (!session_ || documents_.document().empty()) return;
  Content content = documents_.document().content();
  std::vector<SavedView> views = saved_views(content.scene);
  if (!change(views)) return;
  content.scene.view = view_with(content.scene, views);
  documents_.document().change(what, content);
  show_saved();
}

void SeeingControl::save_view() {
  change_views(QStringLiteral("Save the view"), [this](std::vector<SavedView>& views) {
    int number = 1;
    const auto taken = [&](const QString& name) {
      return std::any_of(views.begin(), views.end(),
                         [&](const SavedView& view) { return view.name == name; });
    };
    while (taken(QStringLiteral("View %1").arg(number))) ++number;
    views.push_back({QStringLiteral("View %1").arg(number), viewport_.place()});
    return true;
  });
}

void SeeingControl::forget_view(int index) {
  change_views(QStringLiteral("Forget the view"), [index](std::vector<SavedView>& views) {
    if (index < 0 || index >= static_cast<int>(views.size())) return false;
    views.erase(views.begin() + index);
    return true;
  });
}

void SeeingControl::go_to_view(int index) {
  const std::vector<SavedView> views = saved_views(documents_.document().content().scene);
  if (index < 0 || index >= static_cast<int>(views.size())) return;
  viewport_.look(views[static_cast<std::size_t>(index)].place);
}

}  // namespace sonde::ui
