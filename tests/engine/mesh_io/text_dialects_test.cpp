// SPDX-License-Identifier: GPL-3.0-or-later
// What text files of any format may have. Reference: the same mesh written plainly.
#include "engine/mesh_io/plain_text.hpp"
#include "tests/engine/mesh_io/mesh_checks.hpp"

namespace sonde {
namespace {

using namespace std::string_literals;
using test::expect_read;
using test::refusal_of;
using test::replaced;

struct TextFormat {
  const char* name;
  std::string (*write)(const PolygonSoup&);
};
constexpr TextFormat text_formats[] = {{"a.off", test::as_off},
                                       {"a.obj", test::as_obj},
                                       {"a.ply", test::as_text_ply},
                                       {"a.stl", test::as_text_stl}};

template <class F>
void for_each_text(const F& f) {
  for (const TextFormat& format : text_formats)
    for (const PolygonSoup& mesh : test::dialect_meshes()) {
      const std::string text = format.write(mesh);
      f(std::string(format.name), text, test::read_bytes_as(format.name, text));
    }
}

TEST(TextDialects, lines_may_end_in_any_way) {
  for_each_text([](const std::string& name, const std::string& text, const PolygonSoup& plain) {
    for (const char* end : {"\r", "\r\n", "\r\r\n", " \r", "\n\n", "\n\r\n"})
      expect_read(name, replaced(text, "\n", end), plain);
    std::string mixed;
    int line = 0;
    for (const std::string& one : test::lines_of(text))
      mixed += one + std::array{"\n", "\r", "\r\n"}[static_cast<std::size_t>(line++ % 3)];
    expect_read(name, mixed, plain);
  });
}

TEST(TextDialects, faults_have_their_line_whatever_ends_it) {
  for (const char* end : {"\n", "\r", "\r\n", "\r\r\n"}) {
    const auto with = [end](const std::string& text) { return replaced(text, "\n", end); };
    EXPECT_EQ(refusal_of("a.obj", with("# a\n\nv 0 0 0\nv 1 0 x\n")), ":4: \"x\" is not a number");
    EXPECT_EQ(refusal_of("a.off", with("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1\n3 0 1 2\n")),
              ":5: three coordinates expected");
    EXPECT_EQ(refusal_of("a.stl", with("solid\nfacet normal 0 0 1\nouter\n")),
              ":3: \"outer loop\" is expected");
  }
}

TEST(TextDialects, what_fills_the_file_up_after_the_end_is_left_out) {
  for_each_text([](const std::string& name, const std::string& text, const PolygonSoup& plain) {
    for (const std::string& end : {"\x1a"s, "\0\0"s, "\x1a\r\n"s, std::string(512, '\0')})
      expect_read(name, text + end, plain,
                  {std::to_string(end.size()) + (end.size() == 1 ? " byte" : " bytes") +
                   " after the end of the text (NUL, Ctrl-Z) " + (end.size() == 1 ? "is" : "are") +
                   " not read"});
  });
}

TEST(TextDialects, other_encodings_are_named) {
  for_each_text([](const std::string& name, const std::string& text, const PolygonSoup&) {
    for (const bool big : {false, true})
      for (const bool mark : {false, true})
        EXPECT_EQ(refusal_of(name, test::utf16_of(text, big, mark)),
                  ":1: UTF-16 text: save it as UTF-8")
            << name;
    EXPECT_EQ(refusal_of(name, "\xff\xfe\0\0v\0\0\0"s), ":1: UTF-32 text: save it as UTF-8");
  });
}

TEST(TextDialects, numbers_of_other_languages) {
  const PolygonSoup triangle{{{0, 0, 0}, {1, 0, 0}, {0, 0.125, 0}}, {{0, 1, 2}}};
  expect_read("a.obj", "v 0 0 0\nv 1D0 0.0d+00 0\nv 0 1.25D-1 0\nf 1 2 3\n", triangle,
              {"line 2: 3 numbers with the exponent sign D of Fortran"});
  expect_read("a.off", "OFF\n3.0 1.0 0\n0 0 0\n1 0 0\n0 .125 0\n3 0 1.0 2.\n", triangle,
              {"line 2: 4 whole numbers written with a point"});
  expect_read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 .125 0\nf 1.0/1 2.0//3 3\n", triangle,
              {"line 4: 2 whole numbers written with a point"});
  EXPECT_EQ(refusal_of("a.obj", "v 0,0 0,5 1,0\n"),
            ":1: \"0,0\" is not a number: decimals take a point, no comma");
  EXPECT_EQ(refusal_of("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 -1,5e3 0\n"),
            ":4: \"-1,5e3\" is not a number: decimals take a point, no comma");
  EXPECT_EQ(refusal_of("a.obj", "v 0 1,2,x 1\n"), ":1: \"1,2,x\" is not a number");
  EXPECT_EQ(refusal_of("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n"),
            ":6: \"1.5\" is not a vertex index");
  EXPECT_EQ(refusal_of("a.off", "OFF\n1e30 1 0\n"), ":2: \"1e30\" is not a number of vertices");
}

TEST(TextDialects, end_marks_and_padding) {
  EXPECT_EQ(end_marks("a\n"), 0u);
  EXPECT_EQ(end_marks("a\n\0\n"s), 2u);
  EXPECT_EQ(end_marks("\0a\n \x1a"s), 1u);
  EXPECT_EQ(end_marks("\0\0"s), 2u);
  EXPECT_TRUE(is_padding(" \r\n\0\x1a"s));
  EXPECT_FALSE(is_padding(" x"));
}

}  // namespace
}  // namespace sonde
