// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/export_menu.hpp"

#include <QAction>
#include <QMenu>
#include <functional>

#include "ui/actions/export_control.hpp"
#include "ui/shell/main_window.hpp"

namespace sonde::ui {

void add_export_menu(MainWindow& window, QMenu& file, ExportControl& control) {
  QMenu* menu = file.addMenu(QStringLiteral("&Export"));
  const auto add = [&](const char* object, const char* text, const char* key,
                       const std::function<void()>& slot) {
    QAction* action = menu->addAction(QString::fromUtf8(text));
    action->setObjectName(QLatin1String(object));
    action->setShortcut(QKeySequence(QLatin1String(key)));
    QObject::connect(action, &QAction::triggered, &window, slot);
  };
  ExportControl* c = &control;
  add("export_picture", "&Picture…", "Ctrl+E", [c] { c->export_picture(); });
  add("export_animation", "Pictures of the &separation…", "", [c] { c->export_animation(); });
  add("export_tables", "&Numbers (CSV)…", "", [c] { c->export_tables(); });
  add("export_vtk", "Para&View…", "", [c] { c->export_vtk(false); });
  add("export_series", "ParaView, the separation in &time…", "", [c] { c->export_vtk(true); });
  menu->addSeparator();
  add("export_recording_pictures", "Pictures of the &recording…", "",
      [c] { c->export_recording_pictures(); });
  add("export_recording_tables", "N&umbers of the recording (CSV)…", "",
      [c] { c->export_recording_tables(); });
  add("export_recording_series", "ParaView, the re&cording in time…", "",
      [c] { c->export_recording_vtk(); });
  menu->addSeparator();
  add("export_gltf", "&glTF…", "", [c] { c->export_gltf(); });
}

}  // namespace sonde::ui
