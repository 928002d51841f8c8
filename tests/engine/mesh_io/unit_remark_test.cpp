// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/unit_remark.hpp"

#include "tests/engine/mesh_io/mesh_checks.hpp"

namespace sonde {
namespace {

using test::replaced;

std::vector<std::string> remarks_on(const std::string& name, const std::string& bytes,
                                    double scale) {
  const test::TempFolder folder;
  return read_mesh(folder.write(name, bytes), scale).remarks;
}

std::vector<std::string> said(const std::string& words, const std::string& read_as,
                              const std::string& unit) {
  return {"the file says \"" + words + "\"; read as " + read_as + "; --unit " + unit +
          " takes it at its word"};
}

std::string ply_with(const std::string& comment, std::string ply) {
  return replaced(std::move(ply), "comment made by a test", comment);
}

TEST(UnitRemark, a_unit_that_a_file_names_is_told_and_changes_no_number) {
  for (const PolygonSoup& mesh : test::dialect_meshes()) {
    const auto mm = said("units: mm", "metres", "mm");
    test::expect_read("a.obj", "# units: mm\n" + test::as_obj(mesh), mesh, mm);
    test::expect_read("a.obj", "# by X\r\n#Units: mm\r\n" + test::as_obj(mesh), mesh,
                      said("Units: mm", "metres", "mm"));
    test::expect_read("a.off", "# File units = inches\n" + test::as_off(mesh), mesh,
                      said("units = inches", "metres", "in"));
    const std::string comment = "comment units: mm", info = "obj_info unit centimetres";
    test::expect_read("a.ply", ply_with(comment, test::as_text_ply(mesh)), mesh, mm);
    test::expect_read("a.ply", ply_with(comment, test::as_binary_ply(mesh, true)), mesh, mm);
    test::expect_read("a.ply", ply_with(info, test::as_binary_ply(mesh, false)), mesh,
                      said("unit centimetres", "metres", "cm"));
    const PolygonSoup plain = test::read_bytes_as("a.stl", test::as_binary_stl(mesh));
    test::expect_read("a.stl", test::as_binary_stl(mesh, "UNITS=mm,COLOR=\xff\xff\xff\xff"), plain,
                      said("UNITS=mm", "metres", "mm"));
    const std::string text =
        replaced(test::as_text_stl(mesh), "solid a test\n  f", "solid a test UNITS=\"mm\"\n  f");
    EXPECT_EQ(remarks_on("a.stl", text, 1), said("UNITS=mm", "metres", "mm"));
  }
}

TEST(UnitRemark, a_unit_taken_at_its_word_needs_none_and_another_is_told_too) {
  const std::string mesh = test::as_obj(test::box({0.5, 2, 3}));
  struct Spelt {
    const char *line, *words, *unit;
    double metres;
  };
  for (const Spelt& c : {Spelt{"# units: mm", "units: mm", "mm", 1e-3},
                         Spelt{"# Unit: millimeters", "Unit: millimeters", "mm", 1e-3},
                         Spelt{"# units in micrometres", "units in micrometres", "um", 1e-6},
                         Spelt{"# the units are feet", "units are feet", "ft", 0.3048},
                         Spelt{"# unit=in", "unit=in", "in", 0.0254},
                         Spelt{"# units\tcm.", "units\tcm", "cm", 1e-2}}) {
    const std::string bytes = std::string(c.line) + "\n" + mesh;
    EXPECT_EQ(remarks_on("a.obj", bytes, 1), said(c.words, "metres", c.unit)) << c.line;
    const auto taken = remarks_on("a.obj", bytes, c.metres);
    EXPECT_TRUE(taken.empty() || taken[0].find("the file says") == std::string::npos) << c.line;
  }
  EXPECT_EQ(remarks_on("a.obj", "# units: m\n" + mesh, 1), std::vector<std::string>());
  EXPECT_EQ(remarks_on("a.obj", "# units: m\n" + mesh, 1e-3), said("units: m", "millimetres", "m"));
  EXPECT_EQ(remarks_on("a.obj", "# units: mm\n" + mesh, 0.5), std::vector<std::string>())
      << "a scale of the user's own";
}

TEST(UnitRemark, other_words_are_no_unit) {
  const std::string mesh = test::as_obj(test::box({0.5, 2, 3}));
  for (const char* line :
       {"# community: mm", "# units", "# units in", "# units: parsec", "# unit tests", "# unity mm",
        "# units: mm2", "# 12 units", "o units: mm", "# unitsmm", "# \xff units: \xc2\xb5m"})
    EXPECT_EQ(remarks_on("a.obj", std::string(line) + "\n" + mesh, 1), std::vector<std::string>())
        << line;
  // In a PLY, what follows the header is no comment.
  const std::string ply = test::as_binary_ply(test::box({0.5, 2, 3}), false);
  EXPECT_EQ(remarks_on("a.ply", ply_with("comment by X", ply), 1), std::vector<std::string>());
}

}  // namespace
}  // namespace sonde
