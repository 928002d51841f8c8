// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QStringList>

class QLabel;
class QLineEdit;
class QTextBrowser;
class QUrl;

namespace sonde::ui {

/// The rendered manual in a window of its own, with links between its pages and a search through
/// all of them.
class Manual : public QDialog {
 public:
  /// The folder of its pages (*.md); index.md is the first.
  Manual(const QString& folder, QWidget* parent);
  /// Opens a page by its path from the folder, at the heading that a link names (empty: the
  /// beginning).
  void open_page(const QString& name, const QString& heading = {});
  /// Goes to the next place with this text, after the last one found: on this page, then on those
  /// after it. False where no page has it.
  bool find_next(const QString& text);
  QTextBrowser& browser() { return *browser_; }

 private:
  /// The path of a page from the folder.
  QString page_of(const QUrl& url) const;
  int page_now() const;
  QString folder_;
  QStringList pages_;
  QTextBrowser* browser_;
  QLineEdit* search_;
  QLabel* found_;
};

}  // namespace sonde::ui
