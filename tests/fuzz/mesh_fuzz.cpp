// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a mesh file of any format, and the body that is made of what was read.
#include <cmath>

#include "engine/body/body.hpp"
#include "engine/mesh_io/mesh_readers.hpp"
#include "tests/fuzz/soup_checks.hpp"

namespace {

using namespace sonde;
using fuzz::require;

PolygonSoup read(std::uint8_t format, std::string_view bytes) {
  switch (format % 4) {
    case 0:
      return read_off("a.off", bytes, {});
    case 1:
      return read_obj("a.obj", bytes, {});
    case 2:
      return read_ply("a.ply", bytes, {});
    default:
      return read_stl("a.stl", bytes, {});
  }
}

/// Larger bodies are for the tests: here executions count.
constexpr std::size_t most_corners = 2000;

void check(const PolygonSoup& soup) {
  if (fuzz::require_sound(soup) > most_corners) return;
  const auto body = make_body(soup, Model::automatic, "a");
  require(std::isfinite(body->mass.measure) && body->mass.radius > 0, "a body has a size");
  require(body->mass.com.allFinite(), "a body has a centre of mass");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    check(read(data[0], fuzz::text_of(data + 1, size - 1)));
  } catch (const InputError& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos,
            "a message is one line");
  }
  return 0;
}
