// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>
#include <memory>
#include <vector>

namespace sonde::ui {

class Session;

/// Ends sessions in threads of their own: a search that is on its way, and the memory of large
/// meshes, take longer than a window may wait. Its own end waits for theirs.
class Endings {
 public:
  Endings();
  ~Endings();
  /// Nothing holds the probe any more when this returns. Null: nothing.
  void add(std::unique_ptr<Session> session);

 private:
  std::vector<std::future<void>> running_;
};

}  // namespace sonde::ui
