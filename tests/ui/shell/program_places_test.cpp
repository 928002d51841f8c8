// SPDX-License-Identifier: GPL-3.0-or-later
// The real sonde-view in other languages, and with files in places of all names. The reference is
// the picture that it makes of the same scene in a plain place.
#include <QImage>
#include <filesystem>

#include "tests/support/locales.hpp"
#include "tests/ui/shell/program_fixture.hpp"
#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

namespace fs = std::filesystem;

class ProgramPlaces : public Program {
 protected:
  void SetUp() override { write_scene(folder.path()); }

  /// Two boxes apart, in a file with decimals in every number. Apart: a force that comes in and the
  /// searches of a contact would make a picture one of its moment.
  static void write_scene(const fs::path& in) {
    std::string text;
    for (int i = 0; i < 8; ++i)
      text += "v " + std::string(i & 1 ? "0.15" : "-0.05") + (i & 2 ? " 0.125" : " -0.075") +
              (i & 4 ? " 0.0625" : " -0.0375") + '\n';
    text += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    std::ofstream(in / "box.obj") << text;
    std::ofstream(in / "boxes.sonde.json") << R"({"probe": {"mesh": "box.obj", "scale": 0.5,
        "pose": [0.21875, 0.03125, 0.015625, 1, 0, 0, 0]}, "fixed": {"mesh": "box.obj"}})";
  }
  /// Of the view between the docks, whose numbers (times, rates) are of the moment.
  QImage picture_of(const std::string& scene, const std::string& environment = "") {
    const Outcome shown = run("--screenshot shown.png " + scene, environment);
    EXPECT_EQ(shown.exit_code, 0) << shown.err;
    QImage picture(QString::fromStdString((folder / "shown.png").string()));
    fs::remove(folder / "shown.png");
    const int w = picture.width(), h = picture.height();
    return picture.copy(w / 4, h / 10, w / 2, h * 8 / 10);
  }
  /// The share of pixels that differ visibly.
  static double difference(const QImage& a, const QImage& b) {
    return a.isNull() || a.size() != b.size()
               ? 1
               : double(pixels_between(a, b)) / (double(a.width()) * a.height());
  }
};

/// Edges may be drawn otherwise by a pixel.
constexpr double of_edges = 0.002;

TEST_F(ProgramPlaces, in_german_and_in_turkish_it_shows_the_same) {
  const QImage plain = picture_of("boxes.sonde.json");
  ASSERT_LT(difference(picture_of("boxes.sonde.json"), plain), of_edges);
  for (const std::string name : {"de_DE", "tr_TR"}) {
    const std::string set = "LOCPATH='" + sonde::test::make_locale(folder, name).string() +
                            "' LC_ALL=" + name + ".UTF-8";
    EXPECT_LT(difference(picture_of("boxes.sonde.json", set), plain), of_edges) << name;
  }
  // The reference can tell: a box of other sizes is another picture.
  std::ofstream(folder / "boxes.sonde.json") << R"({"probe": {"mesh": "box.obj", "scale": 1,
        "pose": [0.21875, 0.03125, 0.015625, 1, 0, 0, 0]}, "fixed": {"mesh": "box.obj"}})";
  EXPECT_GT(difference(picture_of("boxes.sonde.json"), plain), of_edges);
}

TEST_F(ProgramPlaces, with_spaces_letters_of_any_script_and_four_thousand_of_them) {
  const QImage plain = picture_of("boxes.sonde.json");
  fs::path deep = folder.path();
  while (deep.string().size() < 3800) deep /= std::string(180, 'd');
  for (const fs::path& place : {folder / "a b", folder / "Körper 箱 é", folder / "a'b\"c", deep}) {
    fs::create_directories(place);
    write_scene(place);
    ::setenv("PLACE", place.c_str(), 1);
    EXPECT_LT(difference(picture_of("\"$PLACE/boxes.sonde.json\""), plain), of_edges) << place;
  }
  ::unsetenv("PLACE");
}

}  // namespace
}  // namespace sonde::ui::test
