// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractNativeEventFilter>
#include <QObject>
#include <functional>

namespace sonde::ui {

/// Calls a function on Esc, wherever in the application and whatever the key does there besides.
/// Where something is open in front of the window (a dialog, a menu, a list), Esc closes that and
/// nothing else, unless the function is wanted first.
class EscapeKey : public QObject, public QAbstractNativeEventFilter {
 public:
  /// `first` says whether `pressed` is called even where something is open: the hand at a device
  /// with motors must not have to wait for a dialog.
  EscapeKey(std::function<void()> pressed, std::function<bool()> first);
  ~EscapeKey() override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool nativeEventFilter(const QByteArray& type, void* message, long* result) override;

 private:
  void decide();

  std::function<void()> pressed_;
  std::function<bool()> first_;
  bool closes_ = false;  ///< this press is for what was open: several events tell of one press
};

}  // namespace sonde::ui
