// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/tick_blocks.hpp"

namespace sonde::ui {

TickBlocks TickBlocks::of(const TickLog& log) {
  return {log.all(),        log.probe_radius(), log.rate_hz(),
          log.first_time(), log.last_time(),    log.along_path};
}

TickLog TickBlocks::log() const {
  TickLog log(probe_radius, rate_hz);
  log.along_path = along_path;
  for (const BlockBytes& block : blocks) {
    const std::string bytes = block();
    const BlockHead head = head_of(bytes);
    if (head.kind == BlockKind::ticks) log.add(head, block);
    if (head.kind == BlockKind::searches)
      for (const RecordedSearch& search : searches_in(content_of(head, bytes))) log.add(search);
  }
  return log;
}

}  // namespace sonde::ui
