// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/tick_blocks.hpp"

#include <stdexcept>
#include <string>

#include "engine/base/error.hpp"

namespace sonde::ui {

TickBlocks TickBlocks::of(const TickLog& log) {
  return {log.all(),        log.probe_radius(), log.rate_hz(),
          log.first_time(), log.last_time(),    log.along_path};
}

TickLog TickBlocks::log() const {
  TickLog log(probe_radius, rate_hz);
  log.along_path = along_path;
  for (const BlockBytes& block : blocks) try {
      const std::string bytes = block();
      const BlockHead head = head_of(bytes);
      if (head.kind == BlockKind::ticks) log.add(head, block);
      if (head.kind == BlockKind::searches)
        for (const RecordedSearch& search : searches_in(content_of(head, bytes))) log.add(search);
    } catch (const std::invalid_argument& bad) {
      throw InputError(std::string("the recording has changed while it was open: ") + bad.what());
    }
  return log;
}

}  // namespace sonde::ui
