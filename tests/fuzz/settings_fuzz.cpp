// SPDX-License-Identifier: GPL-3.0-or-later
// Any text as gains, as a device's profile and as its settings.
#include "engine/base/error.hpp"
#include "engine/scene/scene.hpp"
#include "engine/settings/device_profile.hpp"
#include "engine/settings/device_settings_file.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

template <class Task>
void quietly(const Task& task) {
  try {
    task();
  } catch (const sonde::InputError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sonde;
  const fuzz::InputFile file(fuzz::text_of(data, size), ".json");
  quietly([&] { read_coupling(file.path()); });
  quietly([&] { simulated(read_device_profile(file.path())); });
  quietly([&] {
    const std::string text = device_settings_text(read_device_settings(file.path()));
    const fuzz::InputFile again(text, ".again.json");
    fuzz::require(device_settings_text(read_device_settings(again.path())) == text,
                  "settings survive being saved");
  });
  return 0;
}
