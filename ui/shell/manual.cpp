// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/manual.hpp"

#include <QDesktopServices>
#include <QDir>
#include <QDirIterator>
#include <QHBoxLayout>
#include <QImage>
#include <QImageReader>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QResizeEvent>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTimer>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

namespace sonde::ui {
namespace {

constexpr int resized_ms = 60;  // a window that is being drawn larger is laid out once

/// Pages as they are written, without comments, and with a link in place of each picture that this
/// Qt cannot draw.
class Pages : public QTextBrowser {
 public:
  explicit Pages(QWidget* parent) : QTextBrowser(parent) {
    // One that comes and goes with the page's length would change the width that pictures fit.
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    again_.setSingleShot(true);
    connect(&again_, &QTimer::timeout, this, &Pages::show_again);
  }
  QVariant loadResource(int type, const QUrl& name) override {
    QVariant found = QTextBrowser::loadResource(type, name);
    if (type == QTextDocument::ImageResource) {
      pictured_ = true;
      return fitted(source().resolved(name), found);
    }
    if (type != QTextDocument::MarkdownResource) return found;
    QString text = QString::fromUtf8(found.toByteArray());
    static const QRegularExpression comment(QStringLiteral("<!--.*?-->\n*"),
                                            QRegularExpression::DotMatchesEverythingOption);
    text.remove(comment);
    static const bool drawn = QImageReader::supportedImageFormats().contains("svg");
    static const QRegularExpression picture(QStringLiteral(R"(!\[([^\]]*)\]\(([^)]*\.svg)\))"));
    if (!drawn) text.replace(picture, QStringLiteral("[Picture: \\1](\\2)"));
    return text.toUtf8();
  }

 protected:
  /// What was fitted before the window had its width is fitted again.
  void resizeEvent(QResizeEvent* event) override {
    QTextBrowser::resizeEvent(event);
    if (pictured_ && event->size().width() != event->oldSize().width()) again_.start(resized_ms);
  }

 private:
  void show_again() {
    const int at = verticalScrollBar()->value();
    const int from = textCursor().anchor(), to = textCursor().position();
    reload();
    QTextCursor found = textCursor();
    found.setPosition(from);
    found.setPosition(to, QTextCursor::KeepAnchor);
    setTextCursor(found);
    verticalScrollBar()->setValue(at);
  }
  /// A picture no wider than the page.
  QVariant fitted(const QUrl& file, const QVariant& otherwise) const {
    const QImage picture(file.toLocalFile());
    const int width = viewport()->width() - 2 * static_cast<int>(document()->documentMargin());
    if (picture.isNull() || picture.width() <= width || width < 100) return otherwise;
    return picture.scaledToWidth(width, Qt::SmoothTransformation);
  }

  QTimer again_;
  bool pictured_ = false;  ///< some page so far
};

/// The name under which a link finds a heading: small letters, dashes for blanks, nothing else.
QString anchor_of(const QString& heading) {
  QString name;
  for (const QChar c : heading.toLower())
    if (c.isLetterOrNumber() || c == '-' || c == '_')
      name += c;
    else if (c.isSpace())
      name += '-';
  return name;
}

/// Every page below a folder, as a path from there, in the order in which a search visits them.
QStringList pages_below(const QString& folder) {
  QStringList pages;
  QDirIterator found(folder, {QStringLiteral("*.md")}, QDir::Files, QDirIterator::Subdirectories);
  while (found.hasNext()) pages += QDir(folder).relativeFilePath(found.next());
  pages.sort();
  return pages;
}

}  // namespace

Manual::Manual(const QString& folder, QWidget* parent)
    : QDialog(parent, Qt::Window),
      folder_(folder),
      pages_(pages_below(folder)),
      browser_(new Pages(this)),
      search_(new QLineEdit(this)),
      found_(new QLabel(this)) {
  setObjectName(QStringLiteral("manual"));
  setWindowTitle(QStringLiteral("Manual of Sonde"));
  resize(820, 640);
  // The index is where one begins, and so where a search goes on after the last page.
  if (const qsizetype index = pages_.indexOf(QStringLiteral("index.md")); index > 0)
    pages_.move(static_cast<int>(index), 0);
  search_->setObjectName(QStringLiteral("manual_search"));
  search_->setPlaceholderText(QStringLiteral("Search all pages: Enter finds the next"));
  search_->setClearButtonEnabled(true);
  browser_->setObjectName(QStringLiteral("manual_page"));
  browser_->setSearchPaths({folder});
  browser_->setOpenLinks(false);
  const auto button = [this](const char* text, const char* object) {
    auto* made = new QPushButton(QString::fromUtf8(text), this);
    made->setObjectName(QLatin1String(object));
    made->setAutoDefault(false);  // Enter is for the search
    return made;
  };
  auto* contents = button("Contents", "manual_contents");
  auto* back = button("Back", "manual_back");
  back->setEnabled(false);
  auto* bar = new QHBoxLayout;
  bar->addWidget(contents);
  bar->addWidget(back);
  bar->addWidget(search_, 1);
  bar->addWidget(found_);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(bar);
  layout->addWidget(browser_);
  connect(contents, &QPushButton::clicked, this, [this] { open_page(pages_.value(0)); });
  connect(back, &QPushButton::clicked, browser_, &QTextBrowser::backward);
  connect(browser_, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
  connect(browser_, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
    // Pages of the manual open here; what is on the web, or a file beside it, is the system's.
    const QString page = page_of(browser_->source().resolved(link));
    if (pages_.contains(page))
      open_page(page, link.fragment());
    else
      QDesktopServices::openUrl(browser_->source().resolved(link));
  });
  connect(search_, &QLineEdit::returnPressed, this, [this] { find_next(search_->text()); });
  search_->setFocus();
  open_page(pages_.value(0));
}

void Manual::open_page(const QString& name, const QString& heading) {
  if (!name.isEmpty() && name != page_of(browser_->source()))
    browser_->setSource(QUrl::fromLocalFile(QDir(folder_).filePath(name)));
  if (heading.isEmpty()) return;
  for (QTextBlock block = browser_->document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || anchor_of(block.text()) != heading) continue;
    browser_->moveCursor(QTextCursor::End);  // so that the heading comes to the top
    browser_->setTextCursor(QTextCursor(block));
    return;
  }
}

QString Manual::page_of(const QUrl& url) const {
  return QDir(folder_).relativeFilePath(QDir::cleanPath(url.toLocalFile()));
}

int Manual::page_now() const {
  return std::max(0, static_cast<int>(pages_.indexOf(page_of(browser_->source()))));
}

bool Manual::find_next(const QString& text) {
  found_->clear();
  if (text.isEmpty()) return false;
  if (browser_->find(text)) return true;
  const int count = static_cast<int>(pages_.size()), from = page_now();
  for (int i = 1; i <= count; ++i) {
    const QString& page = pages_[(from + i) % count];
    QFile file(QDir(folder_).filePath(page));
    if (!file.open(QIODevice::ReadOnly)) continue;
    QTextDocument rendered;
    rendered.setMarkdown(QString::fromUtf8(file.readAll()));
    if (rendered.find(text).isNull()) continue;
    open_page(page);
    browser_->moveCursor(QTextCursor::Start);
    return browser_->find(text);
  }
  found_->setText(QStringLiteral("on no page"));
  return false;
}

}  // namespace sonde::ui
