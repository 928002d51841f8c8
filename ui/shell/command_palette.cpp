// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/command_palette.hpp"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <algorithm>

namespace sonde::ui {
namespace {

/// "&" marks a key, and "&&" is the sign itself.
QString plain(const QAction& action) {
  static const QRegularExpression mark(QStringLiteral("&(.)"));
  return QString(action.text()).replace(mark, QStringLiteral("\\1")).remove(QStringLiteral("…"));
}

/// Every action below a menu, as "File › Export › Picture   (Ctrl+E)".
void list_actions(const QList<QAction*>& actions, const QString& above, QListWidget& list) {
  for (QAction* action : actions) {
    if (action->isSeparator() || !action->isEnabled() || action->text().isEmpty()) continue;
    const QString name = above.isEmpty() ? plain(*action) : above + " › " + plain(*action);
    if (const QMenu* menu = action->menu()) {
      list_actions(menu->actions(), name, list);
      continue;
    }
    const QString key = action->shortcut().toString();
    auto* item =
        new QListWidgetItem((action->isChecked() ? QStringLiteral("✓ ") : QString()) + name +
                                (key.isEmpty() ? QString() : QStringLiteral("   (%1)").arg(key)),
                            &list);
    item->setData(Qt::UserRole, QVariant::fromValue<QObject*>(action));
  }
}

}  // namespace

CommandPalette::CommandPalette(QMenuBar& menus, QWidget* parent)
    : QDialog(parent), words_(new QLineEdit(this)), found_(new QListWidget(this)) {
  setObjectName(QStringLiteral("command_palette"));
  setWindowTitle(QStringLiteral("Find a command"));
  words_->setObjectName(QStringLiteral("command_words"));
  words_->setPlaceholderText(QStringLiteral("Words of what is wanted"));
  words_->installEventFilter(this);
  found_->setObjectName(QStringLiteral("commands_found"));
  found_->setFocusPolicy(Qt::NoFocus);  // the keys that choose go there from the words
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(words_);
  layout->addWidget(found_);
  resize(480, 380);
  list_actions(menus.actions(), {}, *found_);
  found_->setCurrentRow(0);
  connect(words_, &QLineEdit::textChanged, this, &CommandPalette::filter);
  connect(words_, &QLineEdit::returnPressed, this, &CommandPalette::take);
  connect(found_, &QListWidget::itemClicked, this, &CommandPalette::take);
}

/// What has every word in it, in any order.
void CommandPalette::filter(const QString& words) {
  const QStringList wanted = words.split(' ', Qt::SkipEmptyParts);
  int first = -1;
  for (int i = 0; i < found_->count(); ++i) {
    QListWidgetItem& item = *found_->item(i);
    const bool fits = std::all_of(wanted.begin(), wanted.end(), [&](const QString& word) {
      return item.text().contains(word, Qt::CaseInsensitive);
    });
    item.setHidden(!fits);
    if (fits && first < 0) first = i;
  }
  found_->setCurrentRow(first);
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) switch (static_cast<QKeyEvent*>(event)->key()) {
      case Qt::Key_Up:
      case Qt::Key_Down:
      case Qt::Key_PageUp:
      case Qt::Key_PageDown:
        QApplication::sendEvent(found_, event);
        return true;
      default:
        break;
    }
  return QDialog::eventFilter(watched, event);
}

void CommandPalette::take() {
  const QListWidgetItem* item = found_->currentItem();
  if (!item || item->isHidden()) return;
  chosen_ = qobject_cast<QAction*>(item->data(Qt::UserRole).value<QObject*>());
  accept();
}

void find_command(QMenuBar& menus, QWidget& window) {
  QPointer<QAction> chosen;
  {
    CommandPalette palette(menus, &window);
    if (palette.exec() == QDialog::Accepted) chosen = palette.chosen();
  }
  if (chosen && chosen->isEnabled()) chosen->trigger();
}

}  // namespace sonde::ui
