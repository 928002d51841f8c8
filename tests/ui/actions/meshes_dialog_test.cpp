// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/meshes_dialog.hpp"

#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>

#include "tests/support/temp_folder.hpp"
#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

class MeshesDialogTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       QString::fromStdString(home.path().string()));
    QSettings().clear();
  }
  static bool can_open(const MeshesDialog& dialog) {
    return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open)->isEnabled();
  }
  static void fill(const MeshesDialog& dialog, const char* field, const char* file) {
    dialog.findChild<QLineEdit*>(field)->setText(file);
  }
  sonde::test::TempFolder home;
};

TEST_F(MeshesDialogTest, opens_once_both_files_are_named) {
  MeshesDialog dialog(nullptr);
  EXPECT_FALSE(can_open(dialog));
  fill(dialog, "probe_file", "/spoon.ply");
  EXPECT_FALSE(can_open(dialog));
  fill(dialog, "fixed_file", "/cup.ply");
  EXPECT_TRUE(can_open(dialog));
  EXPECT_EQ(dialog.probe(), "/spoon.ply");
  EXPECT_EQ(dialog.fixed(), "/cup.ply");
  fill(dialog, "probe_file", "");
  EXPECT_FALSE(can_open(dialog));
}

TEST_F(MeshesDialogTest, a_mesh_that_is_known_is_the_probe_until_they_are_swapped) {
  MeshesDialog dialog(nullptr, "/cup.ply");
  EXPECT_EQ(dialog.probe(), "/cup.ply");
  EXPECT_FALSE(can_open(dialog));
  fill(dialog, "fixed_file", "/spoon.ply");
  dialog.findChild<QPushButton*>("swap_meshes")->click();
  EXPECT_EQ(dialog.probe(), "/spoon.ply");
  EXPECT_EQ(dialog.fixed(), "/cup.ply");
  EXPECT_EQ(dialog.result(), 0) << "swapping is no answer";
}

TEST_F(MeshesDialogTest, the_folder_of_the_last_file_is_remembered) {
  EXPECT_EQ(last_folder(), "");
  remember_folder_of("/meshes/old/cup.ply");
  remember_folder_of("/meshes/new/spoon.ply");
  EXPECT_EQ(last_folder(), "/meshes/new");
}

/// Those that the engine reads.
TEST_F(MeshesDialogTest, every_kind_of_mesh_is_offered) {
  for (const char* ending : {"off", "obj", "ply", "stl", "glb", "gltf", "3mf", "dae"})
    EXPECT_TRUE(mesh_filter().contains(QStringLiteral("*.%1").arg(ending))) << ending;
}

}  // namespace
}  // namespace sonde::ui::test
