// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/demo.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QImage>
#include <filesystem>
#include <string>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

TEST(LitShare, is_what_differs_from_the_background_at_the_left_edge) {
  EXPECT_EQ(lit_share(QImage()), 0) << "of no picture";
  QImage image(100, 50, QImage::Format_RGB32);
  for (int y = 0; y < 50; ++y)  // a background that goes from dark to light
    for (int x = 0; x < 100; ++x) image.setPixel(x, y, qRgb(5 * y, 5 * y, 5 * y));
  EXPECT_EQ(lit_share(image), 0);
  for (int y = 10; y < 20; ++y)
    for (int x = 40; x < 90; ++x) image.setPixel(x, y, qRgb(250, 120, 30));
  EXPECT_DOUBLE_EQ(lit_share(image), 0.1);
  image.setPixel(99, 0, qRgb(3, 3, 3));
  EXPECT_DOUBLE_EQ(lit_share(image), 0.1) << "noise is no light";
}

/// The cubes, which begin in contact: with no trajectory the probe goes on inwards.
class DemoTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
  }
  /// The exit code, with what was printed.
  int play(const std::filesystem::path& picture) {
    Demo demo(*window, picture.string());
    std::optional<int> code;
    QObject::connect(&demo, &Demo::ended, [&](int exit_code) { code = exit_code; });
    testing::internal::CaptureStdout();
    demo.play();
    EXPECT_TRUE(wait_until([&] { return code.has_value(); }));
    out = testing::internal::GetCapturedStdout();
    return code.value_or(-1);
  }
  std::string out;
};

TEST_F(DemoTest, saves_a_picture_of_the_deepest_pose_and_prints_its_figures) {
  const Pose start = window->session()->device_pose();
  EXPECT_EQ(play(folder / "demo.png"), 0);
  EXPECT_FALSE(QImage(path("demo.png")).isNull());
  EXPECT_TRUE(complaints.empty());
  EXPECT_THAT(out, testing::StartsWith((folder / "demo.png").string() + "\ndepth held "));
  for (const char* figure : {"nearest way out ", "PD_t ", "lower bound ", "|F| ", "frames/s\n"})
    EXPECT_THAT(out, testing::HasSubstr(figure));
  EXPECT_GT((shown().separation.device.p - start.p).norm(), 0.01) << "it went on inwards";
  EXPECT_GT(shown().separation.depth, 0.01) << "further in than it began";
}

TEST_F(DemoTest, a_picture_that_cannot_be_written_is_3_and_a_complaint) {
  EXPECT_EQ(play(folder / "nowhere" / "demo.png"), 3);
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_TRUE(complaints[0].contains("nowhere")) << complaints[0].toStdString();
  EXPECT_EQ(out, "");
}

}  // namespace
}  // namespace sonde::ui::test
