// SPDX-License-Identifier: GPL-3.0-or-later
// Any text as a scene; what is read must come out the same when it is written and read again.
#include "engine/base/error.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/write_scene.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sonde;
  const std::filesystem::path file = "/nowhere/a.sonde.json";
  try {
    const Scene scene = scene_in(std::string(fuzz::text_of(data, size)), file);
    const std::string text = scene_text(scene, file.parent_path());
    fuzz::require(scene_text(scene_in(text, file), file.parent_path()) == text,
                  "a scene survives being saved");
  } catch (const InputError& error) {
    fuzz::require(std::string_view(error.what()).find('\n') == std::string_view::npos,
                  "a message is one line");
  }
  return 0;
}
