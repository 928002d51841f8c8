// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QStringList>

class QLabel;
class QLineEdit;
class QTextBrowser;
class QUrl;

namespace sonde::ui {

/// The manual, rendered, in a window of its own: its pages lead to each other, and a search goes on
/// from page to page.
class Manual : public QDialog {
 public:
  /// The folder that its pages (*.md) lie below; index.md is the first.
  Manual(const QString& folder, QWidget* parent);
  /// A page, by its path from the folder; of that, the heading a link names (empty: the beginning).
  void open_page(const QString& name, const QString& heading = {});
  /// The next place with this text, after the one found last: on this page, then on those after it.
  /// False where no page has it.
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
