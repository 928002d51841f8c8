// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <vector>

namespace sonde::ui {

/// Recent files, the newest first: one scene, or the probe and the fixed body. Stored with the
/// settings of the window.
std::vector<QStringList> recent_files();
void remember_recent(const QStringList& files);
/// "cup.sonde.json", "spoon.ply and cup.ply".
QString recent_name(const QStringList& files);

}  // namespace sonde::ui
