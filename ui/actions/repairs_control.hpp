// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <optional>

#include "ui/actions/flight.hpp"
#include "ui/panels/repairs_bar.hpp"
#include "ui/panels/repairs_notice.hpp"

namespace sonde::ui {

class DocumentControl;
class Session;
class Viewport;

/// What was mended of the bodies on show: the notice that says so, the bar that it unfolds, the way
/// to each place, and taking it back.
class RepairsControl : public QObject {
  Q_OBJECT
 public:
  RepairsControl(Viewport& viewport, DocumentControl& documents, QWidget& window);

  RepairsBar& bar() { return *bar_; }
  RepairsNotice& notice() { return *notice_; }
  /// Null: nothing is open. The bar of another document is folded away, so that the view has its
  /// room.
  void attach(Session* session, bool same_document = false);
  /// The next place of that body, and after its last the first.
  void show_next(std::size_t body);
  /// The next place of either body.
  void show_next();
  /// Folds the bar away, or unfolds it, until another document is open.
  void set_away(bool away);
  bool away() const { return away_; }
  bool flying() const { return flight_.flying(); }

 signals:
  void say(const QString& what);
  void away_changed(bool away);

 private:
  void repair(std::size_t body, bool as_in_file);
  void close_openings(std::size_t body);
  void put_away();
  const Body& body(std::size_t index) const;
  std::optional<RepairsRow> row_of(std::size_t index) const;
  void show_rows();

  Viewport& viewport_;
  DocumentControl& documents_;
  RepairsBar* bar_;
  RepairsNotice* notice_;
  Session* session_ = nullptr;
  bool away_ = true;
  std::array<std::size_t, 2> next_{};  ///< place of each body
  std::size_t last_ = 0;               ///< the body that was shown last
  Flight flight_;
};

}  // namespace sonde::ui
