// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/prompts.hpp"

#include <QColorDialog>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>

#include "engine/text/printable.hpp"
#include "ui/actions/bodies_dialog.hpp"
#include "ui/actions/meshes_dialog.hpp"

namespace sonde::ui {
namespace {

struct Button {
  const char* text;
  QMessageBox::ButtonRole role;
};

/// The place of the button that was pressed: the first one on Enter, the last one on Esc.
int choose(QWidget* parent, const char* object, const QString& text, const QString& more,
           const std::vector<Button>& buttons) {
  QMessageBox box(QMessageBox::Question, QStringLiteral("Sonde"), text, QMessageBox::NoButton,
                  parent);
  box.setObjectName(QLatin1String(object));
  box.setTextFormat(Qt::PlainText);  // file names
  box.setInformativeText(more);
  std::vector<QAbstractButton*> made;
  made.reserve(buttons.size());
  for (const Button& button : buttons)
    made.push_back(box.addButton(QString::fromUtf8(button.text), button.role));
  box.setDefaultButton(static_cast<QPushButton*>(made.front()));
  box.setEscapeButton(made.back());
  box.exec();
  for (std::size_t i = 0; i < made.size(); ++i)
    if (made[i] == box.clickedButton()) return static_cast<int>(i);
  return static_cast<int>(made.size()) - 1;
}

void add_document_questions(Prompts& prompts, QWidget* parent) {
  prompts.ask_leaving = [parent](const QString& name) {
    return static_cast<Leaving>(choose(
        parent, "leaving_box", QStringLiteral("“%1” has changes that are not saved.").arg(name),
        QStringLiteral("Save them first?"),
        {{"Save", QMessageBox::AcceptRole},
         {"Discard", QMessageBox::DestructiveRole},
         {"Cancel", QMessageBox::RejectRole}}));
  };
  prompts.ask_save = [parent](const QString& first) {
    QFileDialog dialog(parent, QStringLiteral("Save the scene"), first,
                       QStringLiteral("Scenes (*.sonde.json)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("sonde.json"));
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
  };
  prompts.ask_reload = [parent](const QString& file) {
    return choose(parent, "reload_box", QStringLiteral("%1 has changed on the disk.").arg(file),
                  QStringLiteral("Reading it again loses the changes that are not saved."),
                  {{"Read it again", QMessageBox::DestructiveRole},
                   {"Keep what is open", QMessageBox::RejectRole}}) == 0;
  };
  prompts.ask_overwrite = [parent](const QString& file) {
    return choose(parent, "overwrite_box",
                  QStringLiteral("%1 has just been changed by another program.").arg(file),
                  QStringLiteral("Saving loses that change."),
                  {{"Save all the same", QMessageBox::DestructiveRole},
                   {"Do not save", QMessageBox::RejectRole}}) == 0;
  };
  prompts.ask_recover = [parent](const QString& what) {
    return static_cast<Recovering>(choose(
        parent, "recover_box", QStringLiteral("Sonde ended without saving this: %1").arg(what),
        QStringLiteral("Its gains, poses and view were kept."),
        {{"Recover", QMessageBox::AcceptRole},
         {"Discard", QMessageBox::DestructiveRole},
         {"Later", QMessageBox::RejectRole}}));
  };
  prompts.ask_paths = [parent](const QString& scene, const QStringList& paths) {
    QString text = QStringLiteral("“%1” names files outside of its folder:\n").arg(scene);
    for (const QString& path : paths)
      text += '\n' + QString::fromStdString(printable(path.toStdString()));
    const int answer = choose(
        parent, "paths_box", text,
        QStringLiteral("Sonde only reads them. A stranger's scene should not name your own files."),
        {{"Open", QMessageBox::AcceptRole}, {"Cancel", QMessageBox::RejectRole}});
    return answer == 0 ? Consent::kept : Consent::refused;
  };
  prompts.ask_replace = [parent](const QString& file) {
    return choose(parent, "replace_box", QStringLiteral("%1 is there already.").arg(file),
                  QStringLiteral("It is written too. Nothing is written if it stays."),
                  {{"Replace it", QMessageBox::DestructiveRole},
                   {"Keep it", QMessageBox::RejectRole}}) == 0;
  };
  prompts.ask_role = [parent](const QString& name, int meshes) -> std::optional<Role> {
    struct Answer {
      Role role;
      const char* text;
    };
    std::vector<Answer> answers;
    if (meshes == 1) answers = {{Role::probe, "The probe"}, {Role::fixed, "The fixed body"}};
    answers.push_back({Role::parts, meshes == 1 ? "A further part" : "Further parts"});
    if (meshes == 2) answers.push_back({Role::pair, "Probe and fixed body"});
    std::vector<Button> buttons;
    buttons.reserve(answers.size() + 1);
    for (const Answer& answer : answers) buttons.push_back({answer.text, QMessageBox::AcceptRole});
    buttons.push_back({"Cancel", QMessageBox::RejectRole});
    const QString question = meshes == 1 ? QStringLiteral("What is %1 to be?").arg(name)
                                         : QStringLiteral("What are the %1 to be?").arg(name);
    const auto chosen = static_cast<std::size_t>(choose(parent, "role_box", question, {}, buttons));
    return chosen < answers.size() ? std::optional(answers[chosen].role) : std::nullopt;
  };
}

}  // namespace

Prompts dialogs(QWidget& window) {
  QWidget* parent = &window;
  Prompts prompts;
  prompts.report_error = [parent](const QString& reason) {
    QMessageBox box(QMessageBox::Warning, QStringLiteral("Sonde"), reason, QMessageBox::Ok, parent);
    box.setTextFormat(Qt::PlainText);  // file names
    box.exec();
  };
  add_document_questions(prompts, parent);
  prompts.ask_bodies = [parent](const MeshPair& pair,
                                const PairSetup& guess) -> std::optional<PairSetup> {
    BodiesDialog dialog(pair, guess, parent);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return dialog.setup();
  };
  prompts.ask_scene = [parent] {
    return QFileDialog::getOpenFileName(parent, QStringLiteral("Open a scene"), last_folder(),
                                        QStringLiteral("Scenes (*.sonde.json);;All files (*)"));
  };
  prompts.ask_meshes =
      [parent](const QString& first) -> std::optional<std::pair<QString, QString>> {
    MeshesDialog dialog(parent, first);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return std::pair{dialog.probe(), dialog.fixed()};
  };
  prompts.ask_parts = [parent] {
    return QFileDialog::getOpenFileNames(parent, QStringLiteral("Add parts to the fixed body"),
                                         last_folder(), mesh_filter());
  };
  prompts.ask_colour = [parent](const QString& first) {
    const QColor colour =
        QColorDialog::getColor(QColor(first), parent, QStringLiteral("The part's colour"));
    return colour.isValid() ? colour.name() : QString();
  };
  prompts.ask_path = [parent] {
    return QFileDialog::getOpenFileName(parent, QStringLiteral("Play a recorded path"),
                                        last_folder(),
                                        QStringLiteral("Recorded paths (*.csv);;All files (*)"));
  };
  prompts.ask_recording = [parent] {
    return QFileDialog::getOpenFileName(parent, QStringLiteral("Open a recording"), last_folder(),
                                        QStringLiteral("Recordings (*.sonderec);;All files (*)"));
  };
  prompts.ask_record = [parent] {
    const QString name =
        QDateTime::currentDateTime().toString(QStringLiteral("'sonde-'yyyyMMdd-HHmmss'.sonderec'"));
    return QFileDialog::getSaveFileName(parent, QStringLiteral("Record to a file"),
                                        QDir(last_folder()).filePath(name),
                                        QStringLiteral("Recordings (*.sonderec)"));
  };
  prompts.ask_picture = [parent] {
    const QString name =
        QDateTime::currentDateTime().toString(QStringLiteral("'sonde-'yyyyMMdd-HHmmss'.png'"));
    // The dialog asks before it takes a file that exists.
    return QFileDialog::getSaveFileName(parent, QStringLiteral("Save a picture of the window"),
                                        QDir(last_folder()).filePath(name),
                                        QStringLiteral("Pictures (*.png)"));
  };
  prompts.ask_profile = [parent](const QString& first) {
    return QFileDialog::getSaveFileName(parent, QStringLiteral("Save the device profile"), first,
                                        QStringLiteral("Device profiles (*.json)"));
  };
  const auto ask_folder = [parent](const char* what) {
    return QFileDialog::getExistingDirectory(parent, QString::fromUtf8(what), last_folder());
  };
  prompts.ask_tuning = [ask_folder] { return ask_folder("Open what sonde tune has written"); };
  prompts.ask_tuning_folder = [ask_folder] { return ask_folder("A folder for the study"); };
  return prompts;
}

}  // namespace sonde::ui
