// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMenu;

namespace sonde::ui {

class ExportControl;
class MainWindow;

/// File, Export. Object names of actions: export_picture, export_tables, export_vtk, export_series,
/// export_gltf, export_animation.
void add_export_menu(MainWindow& window, QMenu& file, ExportControl& control);

}  // namespace sonde::ui
