// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/endings.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "ui/document/session.hpp"

namespace sonde::ui {

Endings::Endings() = default;
Endings::~Endings() = default;

void Endings::expect(Session* session) {
  if (session) expected_.push_back(session);
}

void Endings::add(std::unique_ptr<Session> session) {
  std::erase_if(running_, [](const Ending& ending) {
    return ending.over.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  if (!session) return;
  std::erase(expected_, session.get());
  session->let_go();
  std::shared_ptr<Session> shared = std::move(session);
  running_.push_back({shared, shared->ended(), {}});
  running_.back().over = std::async(std::launch::async, [ended = std::move(shared)]() mutable {
    ended->end();
    while (ended.use_count() > 1) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ended.reset();
  });
}

void Endings::stop_force() {
  for (Session* session : expected_) session->set_force(false);
  for (const Ending& ending : running_)
    if (!*ending.ended)
      if (const std::shared_ptr<Session> session = ending.session.lock()) session->stop_force();
}

std::vector<LoopEnded> Endings::unended() const {
  std::vector<LoopEnded> out;
  for (const Session* session : expected_) out.push_back(session->ended());
  for (const Ending& ending : running_)
    if (!*ending.ended) out.push_back(ending.ended);
  return out;
}

}  // namespace sonde::ui
