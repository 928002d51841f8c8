// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/endings.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "ui/document/session.hpp"

namespace sonde::ui {

Endings::Endings() = default;
Endings::~Endings() = default;

void Endings::add(std::unique_ptr<Session> session) {
  std::erase_if(running_, [](const std::future<void>& ending) {
    return ending.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  if (!session) return;
  session->let_go();
  running_.push_back(
      std::async(std::launch::async, [ended = std::move(session)]() mutable { ended.reset(); }));
}

}  // namespace sonde::ui
