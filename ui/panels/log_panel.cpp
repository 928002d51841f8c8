// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/log_panel.hpp"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTime>
#include <QVBoxLayout>

namespace sonde::ui {
namespace {

constexpr int most_lines = 2000;

}  // namespace

LogPanel::LogPanel(QWidget* parent) : QDockWidget(QStringLiteral("Messages"), parent) {
  setObjectName(QStringLiteral("log_panel"));
  auto* content = new QWidget(this);
  lines_ = new QPlainTextEdit(content);
  lines_->setObjectName(QStringLiteral("log_lines"));
  lines_->setReadOnly(true);
  lines_->setMaximumBlockCount(most_lines);
  lines_->setMinimumHeight(60);
  auto* copy = new QPushButton(QStringLiteral("Copy all"), content);
  copy->setObjectName(QStringLiteral("log_copy"));
  auto* clear = new QPushButton(QStringLiteral("Clear"), content);
  connect(copy, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(text()); });
  connect(clear, &QPushButton::clicked, lines_, &QPlainTextEdit::clear);
  auto* buttons = new QVBoxLayout;
  buttons->addWidget(copy);
  buttons->addWidget(clear);
  buttons->addStretch();
  auto* layout = new QHBoxLayout(content);
  layout->addWidget(lines_);
  layout->addLayout(buttons);
  setWidget(content);
}

void LogPanel::add(const QString& message) {
  if (message.isEmpty() || message == last_) return;
  last_ = message;
  lines_->appendPlainText(QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + message);
}

QString LogPanel::text() const { return lines_->toPlainText(); }

}  // namespace sonde::ui
