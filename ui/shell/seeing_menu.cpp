// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/seeing_menu.hpp"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <functional>

#include "ui/actions/seeing_control.hpp"
#include "ui/shell/main_window.hpp"

namespace sonde::ui {
namespace {

QAction* add(MainWindow& window, QMenu& menu, const char* object, const char* text, const char* key,
             const std::function<void()>& slot) {
  QAction* action = menu.addAction(QString::fromUtf8(text));
  action->setObjectName(QLatin1String(object));
  action->setShortcut(QKeySequence(QLatin1String(key)));
  QObject::connect(action, &QAction::triggered, &window, slot);
  return action;
}

QAction* add_toggle(MainWindow& window, QMenu& menu, const char* object, const char* text,
                    const char* key, const std::function<void(bool)>& slot) {
  QAction* action = menu.addAction(QString::fromUtf8(text));
  action->setObjectName(QLatin1String(object));
  action->setShortcut(QKeySequence(QLatin1String(key)));
  action->setCheckable(true);
  QObject::connect(action, &QAction::triggered, &window, slot);
  return action;
}

/// At once, and whenever the dock says something else.
void check_where(QAction& action, SeeingControl& seeing,
                 const std::function<bool(const Seeing&)>& is_so) {
  const auto check = [&action, &seeing, is_so] { action.setChecked(is_so(seeing.seeing())); };
  check();
  QObject::connect(&seeing, &SeeingControl::changed, &action, check);
}

/// A toggle between opaque and another look, which follows what the dock says.
void add_look(MainWindow& window, QMenu& menu, const char* object, const char* text,
              const char* key, SeeingControl& seeing, Look Seeing::*body, Look look) {
  SeeingControl* control = &seeing;
  QAction* action = add_toggle(window, menu, object, text, key, [control, body, look](bool on) {
    Seeing wanted = control->seeing();
    wanted.*body = on ? look : Look::opaque;
    control->set_seeing(wanted);
  });
  check_where(*action, seeing, [body, look](const Seeing& now) { return now.*body == look; });
}

void add_directions(MainWindow& window, QMenu& menu, SeeingControl& seeing) {
  struct Direction {
    const char *object, *text, *key;
    Vec3 towards, up;
  };
  const Direction directions[] = {
      {"from_right", "From +x", "Ctrl+1", Vec3::UnitX(), Vec3::UnitZ()},
      {"from_left", "From -x", "Ctrl+2", -Vec3::UnitX(), Vec3::UnitZ()},
      {"from_back", "From +y", "Ctrl+3", Vec3::UnitY(), Vec3::UnitZ()},
      {"from_front", "From -y", "Ctrl+4", -Vec3::UnitY(), Vec3::UnitZ()},
      {"from_above", "From +z", "Ctrl+5", Vec3::UnitZ(), Vec3::UnitY()},
      {"from_below", "From -z", "Ctrl+6", -Vec3::UnitZ(), Vec3::UnitY()}};
  SeeingControl* control = &seeing;
  QMenu& from = *menu.addMenu(QStringLiteral("&Look along an axis"));
  for (const Direction& d : directions)
    add(window, from, d.object, d.text, d.key,
        [control, towards = d.towards, up = d.up] { control->look_from(towards, up); });
}

}  // namespace

void add_seeing_menu(MainWindow& window, QMenuBar& bar, SeeingControl& seeing) {
  QMenu& menu = *bar.addMenu(QStringLiteral("&Bodies"));
  SeeingControl* control = &seeing;
  const auto look = [&](const char* object, const char* text, const char* key, Look Seeing::*body,
                        Look wanted) {
    add_look(window, menu, object, text, key, seeing, body, wanted);
  };
  look("xray_fixed", "&X-ray of the fixed body", "X", &Seeing::fixed, Look::xray);
  look("xray_probe", "X-ray of the &probe", "Shift+X", &Seeing::probe, Look::xray);
  look("wire_fixed", "Fixed body as a &wireframe", "", &Seeing::fixed, Look::wireframe);
  look("wire_probe", "Probe as a wireframe", "", &Seeing::probe, Look::wireframe);
  look("hide_fixed", "Hide the fixed body", "", &Seeing::fixed, Look::hidden);
  look("hide_probe", "&Hide the probe", "", &Seeing::probe, Look::hidden);
  menu.addSeparator();
  QAction* cut = add_toggle(window, menu, "cut", "&Cut plane", "C",
                            [control](bool on) { control->set_cut(on); });
  check_where(*cut, seeing, [](const Seeing& now) { return now.cut.on; });
  add(window, menu, "cut_flip_now", "&Flip the cut", "Shift+C", [control] {
    Seeing wanted = control->seeing();
    wanted.cut.normal = -wanted.cut.normal;
    control->set_seeing(wanted);
  });
  add(window, menu, "cut_snap_now", "Cut through the con&tact", "Alt+C",
      [control] { control->snap_cut(); });
  add(window, menu, "cut_face_now", "Cut across the &line of sight", "",
      [control] { control->face_cut(); });
  menu.addSeparator();
  add_toggle(window, menu, "measure", "&Measure", "M",
             [control](bool on) { control->set_measuring(on); });
  add_toggle(window, menu, "gap_colours", "Colours of the &gap", "K",
             [control](bool on) { control->set_gaps(on); });
  QAction* crossings = add_toggle(window, menu, "show_crossings", "Se&lf-intersections", "Shift+D",
                                  [control](bool on) { control->crossings().set_on(on); });
  QObject::connect(&seeing.crossings(), &CrossingFinder::given_up, crossings, [control, crossings] {
    crossings->setChecked(false);
    control->crossings().set_on(false);
  });
}

void add_camera_actions(MainWindow& window, QMenu& menu, SeeingControl& seeing) {
  SeeingControl* control = &seeing;
  add_directions(window, menu, seeing);
  add_toggle(window, menu, "follow_contact", "Follow the &contact", "V",
             [control](bool on) { control->set_follow(on); });
  add(window, menu, "save_view", "&Save this view", "Ctrl+D", [control] { control->save_view(); });
}

}  // namespace sonde::ui
