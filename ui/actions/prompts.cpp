// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/prompts.hpp"

#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QMessageBox>

#include "ui/actions/meshes_dialog.hpp"
#include "ui/actions/unit_dialog.hpp"

namespace sonde::ui {

Prompts dialogs(QWidget& window) {
  QWidget* parent = &window;
  Prompts prompts;
  prompts.report_error = [parent](const QString& reason) {
    QMessageBox::warning(parent, QStringLiteral("Sonde"), reason);
  };
  prompts.ask_unit = [parent](const MeshPair& pair) -> std::optional<double> {
    UnitDialog dialog(pair, parent);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return dialog.metres();
  };
  prompts.ask_scene = [parent] {
    return QFileDialog::getOpenFileName(parent, QStringLiteral("Open a scene"), last_folder(),
                                        QStringLiteral("Scenes (*.sonde.json);;All files (*)"));
  };
  prompts.ask_meshes = [parent]() -> std::optional<std::pair<QString, QString>> {
    MeshesDialog dialog(parent);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return std::pair{dialog.probe(), dialog.fixed()};
  };
  prompts.ask_path = [parent] {
    return QFileDialog::getOpenFileName(parent, QStringLiteral("Play a recorded path"),
                                        last_folder(),
                                        QStringLiteral("Recorded paths (*.csv);;All files (*)"));
  };
  prompts.ask_picture = [parent] {
    const QString name =
        QDateTime::currentDateTime().toString(QStringLiteral("'sonde-'yyyyMMdd-HHmmss'.png'"));
    // The dialog asks before it takes a file that exists.
    return QFileDialog::getSaveFileName(parent, QStringLiteral("Save a picture of the window"),
                                        QDir(last_folder()).filePath(name),
                                        QStringLiteral("Pictures (*.png)"));
  };
  const auto ask_folder = [parent](const char* what) {
    return QFileDialog::getExistingDirectory(parent, QString::fromUtf8(what), last_folder());
  };
  prompts.ask_tuning = [ask_folder] { return ask_folder("Open what sonde tune has written"); };
  prompts.ask_tuning_folder = [ask_folder] { return ask_folder("A folder for the study"); };
  return prompts;
}

}  // namespace sonde::ui
