// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a file of models that place meshes.
#include "engine/mesh_io/assets/asset_readers.hpp"
#include "tests/engine/mesh_io/assets/asset_files.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/soup_checks.hpp"

namespace {

using namespace sonde;
using fuzz::require;

PolygonSoup read(std::uint8_t format, std::string_view bytes) {
  switch (format % 4) {
    case 0:
      return read_gltf("a.glb", bytes, {});
    case 1:
      return read_3mf("a.3mf", bytes, {});
    case 2:  // the sums of a ZIP file keep most changes out: here they are right
      return read_3mf("a.3mf", test::as_3mf(std::string(bytes), false), {});
    default:
      return read_dae("a.dae", bytes, {});
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    fuzz::require_sound(read(data[0], fuzz::text_of(data + 1, size - 1)));
  } catch (const InputError& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos,
            "a message is one line");
  }
  return 0;
}
