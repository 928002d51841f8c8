// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/image_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QStandardPaths>
#include <filesystem>
#include <string>

#include "tests/support/temp_folder.hpp"

namespace sonde::ui::test {
namespace {

/// Every pixel another, some of them not opaque.
QImage small_picture() {
  QImage image(7, 5, QImage::Format_ARGB32);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      image.setPixel(x, y, qRgba(30 * x, 40 * y, 200, x == 0 ? 0 : 255));
  return image;
}

std::string complaint_writing(const std::filesystem::path& file, const QImage& image) {
  try {
    write_image(file, image);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(WriteImage, a_png_has_every_pixel_whatever_its_name_ends_in) {
  const sonde::test::TempFolder folder;
  const QImage image = small_picture();
  for (const char* name : {"a.png", "b.jpg", "c"}) {
    write_image(folder / name, image);
    const QByteArray path = QByteArray::fromStdString((folder / name).string());
    const QImage read(QString::fromUtf8(path), "PNG");
    EXPECT_EQ(read.convertToFormat(QImage::Format_ARGB32), image) << name;
  }
  EXPECT_EQ(folder.file_count(), 3u) << "and nothing beside them";
}

TEST(WriteImage, takes_the_place_of_an_older_one) {
  const sonde::test::TempFolder folder;
  folder.write("a.png", std::string(100'000, 'x'));
  write_image(folder / "a.png", small_picture());
  EXPECT_EQ(QImage(QString::fromStdString((folder / "a.png").string())).width(), 7);
}

TEST(WriteImage, no_picture_is_refused_and_the_old_file_stays) {
  const sonde::test::TempFolder folder;
  const auto file = folder.write("a.png", "old");
  const std::string complaint = complaint_writing(file, QImage());
  EXPECT_THAT(complaint, testing::StartsWith(file.string() + ": "));
  EXPECT_THAT(complaint, testing::HasSubstr("no picture"));
  EXPECT_EQ(sonde::test::text_of(file), "old");
}

TEST(WriteImage, cancelled_leaves_the_old_file_and_nothing_else) {
  const sonde::test::TempFolder folder;
  const auto file = folder.write("a.png", "old");
  EXPECT_THROW(write_image(file, small_picture(), [](double) { return false; }), Cancelled);
  EXPECT_EQ(sonde::test::text_of(file), "old");
  EXPECT_EQ(folder.file_count(), 1u);
  write_image(file, small_picture(), [](double) { return true; });
  EXPECT_NE(sonde::test::text_of(file), "old");
}

TEST(WriteImage, where_none_can_be_written_the_file_is_named) {
  const sonde::test::TempFolder folder;
  folder.write("file", "text");
  std::filesystem::create_directory(folder / "folder");
  for (const char* name : {"nowhere/a.png", "file/a.png", "folder"}) {
    const std::filesystem::path file = folder.path() / name;
    EXPECT_THAT(complaint_writing(file, small_picture()), testing::StartsWith(file.string() + ":"));
  }
  EXPECT_EQ(folder.file_count(), 2u);
}

/// Puts one folder in the place of the search path.
class SearchPath {
 public:
  explicit SearchPath(const std::filesystem::path& folder) {
    qputenv("PATH", QByteArray::fromStdString(folder.string()));
  }
  ~SearchPath() { qputenv("PATH", before_); }
  SearchPath(const SearchPath&) = delete;
  SearchPath& operator=(const SearchPath&) = delete;

 private:
  QByteArray before_ = qgetenv("PATH");
};

TEST(FindFfmpeg, is_empty_where_it_is_not_installed_and_its_path_where_it_is) {
  const sonde::test::TempFolder folder;
  const SearchPath path(folder.path());
  EXPECT_EQ(find_ffmpeg(), "");
  const auto program = folder.write("ffmpeg", "#!/bin/sh\n");
  EXPECT_EQ(find_ffmpeg(), "") << "a file that is no program";
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  EXPECT_EQ(find_ffmpeg(), QString::fromStdString(program.string()));
}

}  // namespace
}  // namespace sonde::ui::test
