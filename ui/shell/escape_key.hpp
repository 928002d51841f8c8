// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractNativeEventFilter>
#include <QObject>
#include <functional>

namespace sonde::ui {

/// Hears of Esc before anybody else in the program does, whatever is open and whatever has the
/// focus. It takes nothing away: the press goes on to where it was meant for.
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
