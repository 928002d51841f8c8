// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/parts_control.hpp"

#include <QMainWindow>
#include <vector>

#include "ui/actions/document_control.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/parts_panel.hpp"
#include "ui/views/part_surface.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {

PartsControl::PartsControl(Viewport& viewport, DocumentControl& documents, Prompts& prompts,
                           QMainWindow& window, QDockWidget& beside)
    : QObject(&window),
      viewport_(viewport),
      documents_(documents),
      prompts_(prompts),
      panel_(new PartsPanel(&window)) {
  window.addDockWidget(window.dockWidgetArea(&beside), panel_);
  connect(panel_, &PartsPanel::add_wanted, this, &PartsControl::ask_parts);
  connect(panel_, &PartsPanel::swap_wanted, &documents_, &DocumentControl::swap_bodies);
  connect(panel_, &PartsPanel::remove_wanted, &documents_, &DocumentControl::remove_part);
  connect(panel_, &PartsPanel::take_apart_wanted, &documents_, &DocumentControl::take_apart);
  connect(panel_, &PartsPanel::colour_wanted, this, &PartsControl::ask_colour);
  connect(panel_, &PartsPanel::rename_wanted, &documents_, &DocumentControl::rename_part);
  connect(panel_, &PartsPanel::shown_wanted, &documents_, &DocumentControl::set_part_shown);
  connect(panel_, &PartsPanel::felt_wanted, &documents_, &DocumentControl::set_part_felt);
  connect(panel_, &PartsPanel::chosen_changed, &viewport_, &Viewport::choose_part);
}

void PartsControl::attach(const Session* session) {
  session_ = session;
  choose({});
  show_document();
}

void PartsControl::show_document() {
  const Document& document = documents_.document();
  if (!session_ || document.empty()) return panel_->show_nothing();
  const Bodies& bodies = *document.content().bodies;
  std::vector<std::size_t> triangles;
  for (const BodyPart& part : bodies.parts) triangles.push_back(part.body->soup.triangles.size());
  if (triangles.empty()) triangles = {bodies.pair.fixed().soup.triangles.size()};
  panel_->show_parts(document.content().scene.fixed, triangles);
}

void PartsControl::choose(std::optional<std::size_t> part) {
  panel_->choose(part);
  viewport_.choose_part(part);
}

void PartsControl::click(QPointF at) {
  if (!session_ || documents_.document().content().bodies->parts.empty()) return;
  const auto hit = viewport_.pick(at);
  const auto part = hit ? hit->part : std::nullopt;
  choose(part == panel_->chosen() ? std::nullopt : part);
}

void PartsControl::ask_parts() {
  if (session_) documents_.add_parts(prompts_.ask_parts());
}

void PartsControl::ask_colour(std::size_t part) {
  const SceneBody& fixed = documents_.document().content().scene.fixed;
  const QColor first = fixed.parts.empty() ? colour::fixed : part_colour(fixed, part);
  const QString colour = prompts_.ask_colour(first.name());
  if (!colour.isEmpty()) documents_.set_part_colour(part, colour);
}

}  // namespace sonde::ui
