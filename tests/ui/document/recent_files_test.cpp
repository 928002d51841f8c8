// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recent_files.hpp"

#include <gtest/gtest.h>

#include <QDir>
#include <QSettings>

#include "tests/support/temp_folder.hpp"
#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

/// With settings of its own, which hold nothing yet.
class RecentFiles : public testing::Test {
 protected:
  RecentFiles() {
    need_application();
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       QString::fromStdString(home_.path().string()));
    QSettings().clear();
  }

 private:
  sonde::test::TempFolder home_;
};

TEST_F(RecentFiles, are_none_at_first) { EXPECT_TRUE(recent_files().empty()); }

TEST_F(RecentFiles, come_newest_first_and_a_pair_of_meshes_stays_one_entry) {
  remember_recent({"/scenes/cup.sonde.json"});
  remember_recent({"/meshes/spoon.ply", "/meshes/cup.ply"});
  const std::vector<QStringList> files = recent_files();
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0], QStringList({"/meshes/spoon.ply", "/meshes/cup.ply"}));
  EXPECT_EQ(files[1], QStringList({"/scenes/cup.sonde.json"}));
}

TEST_F(RecentFiles, opened_again_one_moves_to_the_front_and_is_there_once) {
  for (const char* file : {"/a.sonde.json", "/b.sonde.json", "/a.sonde.json"})
    remember_recent({file});
  const std::vector<QStringList> files = recent_files();
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0], QStringList("/a.sonde.json"));
  EXPECT_EQ(files[1], QStringList("/b.sonde.json"));
}

TEST_F(RecentFiles, probe_and_fixed_body_exchanged_are_another_pair) {
  remember_recent({"/spoon.ply", "/cup.ply"});
  remember_recent({"/cup.ply", "/spoon.ply"});
  EXPECT_EQ(recent_files().size(), 2u);
}

TEST_F(RecentFiles, are_ten_at_most_and_the_oldest_goes) {
  for (int i = 0; i < 13; ++i) remember_recent({QStringLiteral("/scene-%1.sonde.json").arg(i)});
  const std::vector<QStringList> files = recent_files();
  ASSERT_EQ(files.size(), 10u);
  EXPECT_EQ(files.front(), QStringList("/scene-12.sonde.json"));
  EXPECT_EQ(files.back(), QStringList("/scene-3.sonde.json"));
}

/// A program that is started in another folder finds them too.
TEST_F(RecentFiles, are_kept_with_their_whole_path_in_the_settings) {
  remember_recent({"cup.sonde.json"});
  const QString whole = QDir::current().absoluteFilePath("cup.sonde.json");
  ASSERT_EQ(recent_files().size(), 1u);
  EXPECT_EQ(recent_files()[0], QStringList(whole));
  QSettings().sync();
  const QSettings read_anew(QSettings().fileName(), QSettings::IniFormat);
  EXPECT_EQ(read_anew.value("recent").toStringList(), QStringList(whole));
}

TEST_F(RecentFiles, are_named_without_their_folders) {
  EXPECT_EQ(recent_name({"/scenes/cup.sonde.json"}), "cup.sonde.json");
  EXPECT_EQ(recent_name({"/meshes/spoon.ply", "/other/cup.ply"}), "spoon.ply and cup.ply");
}

}  // namespace
}  // namespace sonde::ui::test
