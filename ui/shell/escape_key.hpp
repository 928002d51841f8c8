// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractNativeEventFilter>
#include <QObject>
#include <functional>

namespace sonde::ui {

/// Tells of Esc, wherever in the application and whatever the key does there besides.
/// Where something is open in front of the window (a dialog, a menu, a list), Esc closes that and
/// nothing else, unless it is to be told of first.
class EscapeKey : public QObject, public QAbstractNativeEventFilter {
  Q_OBJECT
 public:
  /// `first` says whether pressed() comes even where something is open: the hand at a device with
  /// motors must not have to wait for a dialog.
  explicit EscapeKey(std::function<bool()> first);
  ~EscapeKey() override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool nativeEventFilter(const QByteArray& type, void* message, long* result) override;

 signals:
  void pressed();

 private:
  void decide();

  std::function<bool()> first_;
  bool closes_ = false;  ///< this press is for what was open: several events tell of one press
};

}  // namespace sonde::ui
