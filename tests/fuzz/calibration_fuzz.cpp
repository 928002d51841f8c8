// SPDX-License-Identifier: GPL-3.0-or-later
// Any text as a calibration.
#include "engine/base/error.hpp"
#include "engine/calibration/calibration_file.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sonde;
  try {
    const std::string text =
        to_json(calibration_in(std::string(fuzz::text_of(data, size)), "calibration.json"));
    fuzz::require(to_json(calibration_in(text, "again.json")) == text,
                  "a calibration survives being saved");
  } catch (const InputError&) {
  }
  return 0;
}
