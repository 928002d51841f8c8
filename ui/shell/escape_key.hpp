// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractNativeEventFilter>
#include <QObject>
#include <functional>

namespace sonde::ui {

/// Reports Esc before any other part of the program gets it, whatever window is open and whatever
/// has the focus. It does not consume the key: the key press still reaches its target.
class EscapeKey : public QObject, private QAbstractNativeEventFilter {
 public:
  explicit EscapeKey(std::function<void()> pressed);
  ~EscapeKey() override;

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool nativeEventFilter(const QByteArray& type, void* message, long* result) override;
  std::function<void()> pressed_;
};

}  // namespace sonde::ui
