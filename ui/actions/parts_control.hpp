// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <cstddef>
#include <optional>

#include "ui/actions/prompts.hpp"

class QDockWidget;
class QMainWindow;

namespace sonde::ui {

class DocumentControl;
class PartsPanel;
class Session;
class Viewport;

/// The parts of the fixed body: their dock, and the one that is chosen, in the dock or by a click
/// in the view.
class PartsControl : public QObject {
 public:
  /// Its dock is added to the window, in the place of that one.
  PartsControl(Viewport& viewport, DocumentControl& documents, Prompts& prompts,
               QMainWindow& window, QDockWidget& beside);

  PartsPanel& panel() { return *panel_; }
  /// Null: nothing is open.
  void attach(const Session* session);
  /// The document may have other parts, names or ticks now.
  void show_document();
  void choose(std::optional<std::size_t> part);
  /// A click in the view that was about nothing else: it chooses the part there, or none.
  void click(QPointF at);
  void ask_parts();

 private:
  void ask_colour(std::size_t part);

  Viewport& viewport_;
  DocumentControl& documents_;
  Prompts& prompts_;
  PartsPanel* panel_;
  const Session* session_ = nullptr;
};

}  // namespace sonde::ui
