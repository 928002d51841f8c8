// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>

namespace sonde::ui {

/// Who may wait for a click in the view, before it chooses a contact or a part.
class ClickTaker {
 public:
  /// True where one was waited for: it means nothing else then.
  virtual bool click(QPointF at) = 0;

 protected:
  ~ClickTaker() = default;
};

}  // namespace sonde::ui
