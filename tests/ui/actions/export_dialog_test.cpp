// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/export_dialog.hpp"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSpinBox>

#include "tests/ui/window_fixture.hpp"
#include "ui/export/image_file.hpp"

namespace sonde::ui::test {
namespace {

using Of = ExportDialog::Of;

TEST(SpanTest, has_both_ends_and_rises) {
  EXPECT_EQ((Span{1, 2, 4}.times()), (std::vector<double>{1, 1.25, 1.5, 1.75, 2}));
  EXPECT_EQ((Span{0, 0.6, 2}.times()), (std::vector<double>{0, 0.5, 0.6}));
  EXPECT_EQ((Span{3, 3, 25}.times()), (std::vector<double>{3}));
}

TEST(SpanTest, that_ends_before_it_begins_is_its_beginning) {
  EXPECT_EQ((Span{2, 1, 10}.times()), (std::vector<double>{2}));
}

/// Tenths are no binary numbers: their sum may miss the end by a rounding.
TEST(SpanTest, has_its_end_once_whatever_the_rate) {
  for (const double from : {0.0, 0.1, 0.3, 0.7, 1.1, 2.9})
    for (const double rate : {0.1, 3.0, 7.0, 10.0, 25.0, 30.0, 1000.0}) {
      SCOPED_TRACE(std::to_string(from) + " s, " + std::to_string(rate) + " each");
      const std::vector<double> times = Span{from, from + 1.2, rate}.times();
      EXPECT_NEAR(times.back(), from + 1.2, 1e-12);
      for (std::size_t i = 1; i < times.size(); ++i) EXPECT_GT(times[i] - times[i - 1], 1e-6);
      EXPECT_LE(std::abs(double(times.size()) - (1.2 * rate + 1)), 1);
    }
}

class ExportDialogTest : public testing::Test {
 protected:
  void SetUp() override { need_application(); }
  void ask(Of of) {
    dialog = std::make_unique<ExportDialog>(of, QSize(800, 600), Span{2, 6, 5}, nullptr);
  }
  /// Fields that are asked for.
  bool asks(const char* name) const {
    const auto* field = dialog->findChild<QWidget*>(name);
    return field && field->isVisibleTo(dialog.get());
  }
  template <class T>
  T& field(const char* name) const {
    return *dialog->findChild<T*>(name);
  }
  std::unique_ptr<ExportDialog> dialog;
};

TEST_F(ExportDialogTest, asks_for_what_belongs_to_each_kind_alone) {
  const char* fields[] = {"picture_width", "picture_overlays", "picture_frames",
                          "picture_film",  "span_from",        "span_rate"};
  const std::pair<Of, std::vector<bool>> wanted[] = {
      {Of::picture, {true, true, false, false, false, false}},
      {Of::animation, {true, true, true, true, false, false}},
      {Of::recording, {true, true, false, true, true, true}},
      {Of::recording_steps, {false, false, false, false, true, true}}};
  QStringList titles;
  for (const auto& [of, asked] : wanted) {
    ask(of);
    titles << dialog->windowTitle();
    for (std::size_t i = 0; i < asked.size(); ++i)
      EXPECT_EQ(asks(fields[i]), asked[i])
          << dialog->windowTitle().toStdString() << ", " << fields[i];
  }
  EXPECT_EQ(titles.removeDuplicates(), 0);
}

TEST_F(ExportDialogTest, begins_with_the_views_size_everything_in_it_and_the_whole_recording) {
  ask(Of::recording);
  const PictureWanted wanted = dialog->wanted();
  EXPECT_EQ(wanted.options.size, QSize(800, 600));
  EXPECT_FALSE(wanted.options.transparent);
  EXPECT_TRUE(wanted.options.overlays);
  EXPECT_FALSE(wanted.film);
  EXPECT_EQ(wanted.span.from, 2);
  EXPECT_EQ(wanted.span.to, 6);
  EXPECT_EQ(wanted.span.rate, 5);
}

TEST_F(ExportDialogTest, what_is_set_is_wanted) {
  ask(Of::animation);
  field<QSpinBox>("picture_width").setValue(1234);
  field<QSpinBox>("picture_height").setValue(567);
  field<QSpinBox>("picture_frames").setValue(7);
  field<QCheckBox>("picture_transparent").setChecked(true);
  field<QCheckBox>("picture_overlays").setChecked(false);
  const PictureWanted wanted = dialog->wanted();
  EXPECT_EQ(wanted.options.size, QSize(1234, 567));
  EXPECT_EQ(wanted.frames, 7);
  EXPECT_TRUE(wanted.options.transparent);
  EXPECT_FALSE(wanted.options.overlays);
}

TEST_F(ExportDialogTest, no_picture_is_larger_than_can_be_drawn_and_no_span_leaves_the_recording) {
  ask(Of::recording);
  field<QSpinBox>("picture_width").setValue(1'000'000);
  field<QDoubleSpinBox>("span_from").setValue(-1);
  field<QDoubleSpinBox>("span_to").setValue(100);
  field<QDoubleSpinBox>("span_rate").setValue(0);
  const PictureWanted wanted = dialog->wanted();
  EXPECT_EQ(wanted.options.size.width(), Viewport::largest_picture);
  EXPECT_EQ(wanted.span.from, 2);
  EXPECT_EQ(wanted.span.to, 6);
  EXPECT_GT(wanted.span.rate, 0) << "no rate at all would make no end of steps";
}

TEST_F(ExportDialogTest, says_how_many_there_will_be) {
  ask(Of::recording_steps);
  EXPECT_EQ(field<QLabel>("span_count").text(), "21 in all");
  field<QDoubleSpinBox>("span_rate").setValue(10);
  EXPECT_EQ(field<QLabel>("span_count").text(), "41 in all");
  field<QDoubleSpinBox>("span_from").setValue(5);
  EXPECT_EQ(field<QLabel>("span_count").text(), "11 in all");
}

TEST_F(ExportDialogTest, a_film_can_be_had_where_there_is_an_encoder) {
  ask(Of::animation);
  auto& film = field<QCheckBox>("picture_film");
  EXPECT_EQ(film.isEnabled(), !find_ffmpeg().isEmpty());
  film.setChecked(true);
  EXPECT_EQ(dialog->wanted().film, film.isEnabled());
  film.setEnabled(false);
  EXPECT_FALSE(dialog->wanted().film);
}

}  // namespace
}  // namespace sonde::ui::test
