// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a recording, and behind its checksums: as the content of its blocks. The first byte
// says which.
#include <stdexcept>

#include "engine/base/error.hpp"
#include "engine/recording/block.hpp"
#include "engine/recording/recording.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace sonde;

void read_file(std::string_view bytes) {
  const fuzz::InputFile file(bytes, ".sonderec");
  try {
    read_recording(file.path());
  } catch (const InputError&) {
  }
}

void read_block(std::string_view bytes) { content_of(head_of(bytes), bytes); }

/// The separated pose is kept as a motion, so that only a true pose comes back to the bit.
void read_ticks(std::string_view content) {
  constexpr double radius = 0.1;
  const std::vector<Snapshot> ticks = ticks_in(content, radius);
  const std::vector<Snapshot> again = ticks_in(tick_content(ticks), radius);
  fuzz::require(again.size() == ticks.size(), "no tick is lost");
  for (std::size_t i = 0; i < ticks.size(); ++i)
    fuzz::require(again[i].separation.contacts.size == ticks[i].separation.contacts.size,
                  "no contact is lost");
}

void read_searches(std::string_view content) {
  const std::string written = search_content(searches_in(content));
  fuzz::require(search_content(searches_in(written)) == written, "searches survive being saved");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view rest = fuzz::text_of(data + 1, size - 1);
  constexpr void (*readers[])(std::string_view) = {read_file, read_block, read_ticks,
                                                   read_searches};
  try {
    readers[data[0] % std::size(readers)](rest);
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
