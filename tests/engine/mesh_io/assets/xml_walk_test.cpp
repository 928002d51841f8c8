// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/xml_walk.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

std::string walked(const std::string& text) {
  std::string out;
  try {
    walk_xml("f", text,
             {.begin =
                  [&](const XmlElement& e) {
                    out += "<" + std::string(e.name) + "@" + std::to_string(e.line) + ":" +
                           std::string(e.attribute("k"));
                  },
              .end = [&](std::string_view name) { out += ">" + std::string(name); },
              .text = [&](std::string_view more) { out += more; }},
             {});
  } catch (const InputError& error) {
    return error.what();
  }
  return out;
}

TEST(XmlWalk, elements_and_text_in_order) {
  EXPECT_EQ(walked("<a>t\n<x:b y:k='1'>u</x:b></a>"), "<a@1:t\n<b@2:1u>b>a");
}

TEST(XmlWalk, faults) {
  EXPECT_EQ(walked("<a>\n<b></a>"), "f:2: not well-formed XML: mismatched tag");
  EXPECT_EQ(walked("<!DOCTYPE a [\n<!ENTITY b 'c'>]><a>&b;</a>"),
            "f:2: declares an entity, which is not read");
  std::string deep;
  for (int k = 0; k < 201; ++k) deep += "<a>";
  EXPECT_EQ(walked(deep), "f:1: nested more than 200 elements deep");
}

TEST(XmlWalk, is_cancelled) {
  EXPECT_THROW(walk_xml("f", "<a/>", {}, [](double) { return false; }), Cancelled);
}

}  // namespace
}  // namespace sonde
