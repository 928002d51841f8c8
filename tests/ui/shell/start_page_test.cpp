// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/start_page.hpp"

#include <gtest/gtest.h>

#include <QDir>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "tests/support/temp_folder.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/base/format.hpp"
#include "ui/base/resources.hpp"
#include "ui/document/recent_files.hpp"

namespace sonde::ui::test {
namespace {

/// The page over a widget of 900 × 700 pixels, with no recent file.
class StartPageTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       QString::fromStdString(home.path().string()));
    QSettings().clear();
    parent = std::make_unique<QWidget>();
    parent->resize(900, 700);
    page = new StartPage(parent.get());
    parent->show();
    page->present();
    QObject::connect(page, &StartPage::chosen,
                     [this](const QStringList& files) { chosen = files; });
  }
  QList<QToolButton*> recent() const {
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return page->findChildren<QToolButton*>("recent_file");
  }
  bool says(const QString& text) const {
    for (const QLabel* label : page->findChildren<QLabel*>())
      if (label->text() == text) return true;
    return false;
  }
  sonde::test::TempFolder home;
  std::unique_ptr<QWidget> parent;
  StartPage* page = nullptr;
  QStringList chosen;
};

TEST_F(StartPageTest, every_bundled_scene_has_a_tile_with_its_picture_that_opens_it) {
  const QStringList scenes =
      QDir(resource("scenes")).entryList({"*.sonde.json"}, QDir::Files, QDir::Name);
  ASSERT_FALSE(scenes.isEmpty());
  for (const QString& scene : scenes) {
    const QString name = scene.chopped(QStringLiteral(".sonde.json").size());
    auto* tile = page->findChild<QToolButton*>(QStringLiteral("gallery_") + name);
    ASSERT_TRUE(tile) << name.toStdString();
    EXPECT_FALSE(tile->icon().pixmap(132, 88).isNull()) << name.toStdString();
    tile->click();
    EXPECT_EQ(chosen, QStringList(resource("scenes/" + scene)));
  }
}

TEST_F(StartPageTest, its_buttons_ask_for_a_scene_or_for_meshes) {
  QString asked;
  QObject::connect(page, &StartPage::scene_wanted, [&] { asked += "scene "; });
  QObject::connect(page, &StartPage::meshes_wanted, [&] { asked += "meshes "; });
  page->findChild<QPushButton*>("start_meshes")->click();
  page->findChild<QPushButton*>("start_scene")->click();
  EXPECT_EQ(asked, "meshes scene ");
  EXPECT_TRUE(chosen.isEmpty());
}

TEST_F(StartPageTest, recent_files_are_those_of_when_it_is_presented_the_newest_first) {
  EXPECT_TRUE(recent().isEmpty());
  EXPECT_TRUE(says("Nothing yet."));
  remember_recent({"/scenes/cup.sonde.json"});
  remember_recent({"/meshes/spoon.ply", "/meshes/cup.ply"});
  page->present();
  ASSERT_EQ(recent().size(), 2);
  EXPECT_FALSE(says("Nothing yet."));
  EXPECT_EQ(recent()[0]->text(), "spoon.ply and cup.ply");
  recent()[0]->click();
  EXPECT_EQ(chosen, QStringList({"/meshes/spoon.ply", "/meshes/cup.ply"}));
  recent()[1]->click();
  EXPECT_EQ(chosen, QStringList("/scenes/cup.sonde.json"));
  page->present();
  EXPECT_EQ(recent().size(), 2) << "each once";
}

/// In a button "&" marks a key, and "&&" is the sign itself.
TEST_F(StartPageTest, a_name_stands_there_as_it_is) {
  remember_recent({"/scenes/nut&bolt.sonde.json"});
  page->present();
  ASSERT_EQ(recent().size(), 1);
  EXPECT_EQ(recent()[0]->text(), "nut&&bolt.sonde.json");
  EXPECT_EQ(recent()[0]->toolTip(), tooltip_of("/scenes/nut&bolt.sonde.json"));
}

TEST_F(StartPageTest, a_complaint_is_plain_text_with_a_way_to_look_elsewhere) {
  auto* complaint = page->findChild<QFrame*>("start_complaint");
  EXPECT_FALSE(complaint->isVisible());
  int located = 0;
  page->complain("<i>cup</i>.off: there is no such file", [&] { ++located; });
  EXPECT_TRUE(complaint->isVisible());
  auto* reason = page->findChild<QLabel*>("start_reason");
  EXPECT_EQ(reason->text(), "Nothing was opened. <i>cup</i>.off: there is no such file");
  EXPECT_EQ(reason->textFormat(), Qt::PlainText);
  page->findChild<QPushButton*>("start_locate")->click();
  EXPECT_EQ(located, 1);
  page->present();
  EXPECT_FALSE(complaint->isVisible()) << "that was before";
}

/// At the sizes of small and of large screens.
TEST_F(StartPageTest, the_tiles_use_the_width_and_the_files_opened_last_stand_beside_them) {
  for (const auto& [width, most_rows] :
       {std::pair(1152, 2), std::pair(1600, 1), std::pair(420, 4)}) {
    parent->resize(width, 900);
    ASSERT_TRUE(wait_until([&] { return page->width() == width; }));
    page->present();
    QApplication::processEvents();
    std::set<int> rows;
    int right = 0;
    for (const QToolButton* tile : page->findChildren<QToolButton*>())
      if (tile->objectName().startsWith("gallery_")) {
        const QPoint at = tile->mapTo(page, QPoint());
        rows.insert(at.y());
        right = std::max(right, at.x() + tile->width());
      }
    EXPECT_LE(int(rows.size()), most_rows) << width;
    EXPECT_LE(right, width) << width;
    for (const QLabel* label : page->findChildren<QLabel*>()) {
      if (label->text() != "Opened last") continue;
      EXPECT_GE(label->mapTo(page, QPoint()).x(), right) << width;
    }
  }
}

TEST_F(StartPageTest, covers_its_parent_at_any_size) {
  EXPECT_EQ(page->geometry(), parent->rect());
  parent->resize(500, 400);
  EXPECT_TRUE(wait_until([this] { return page->geometry() == parent->rect(); }));
  QImage seen(parent->size(), QImage::Format_RGB32);
  seen.fill(Qt::red);
  page->render(&seen);
  EXPECT_NE(seen.pixelColor(2, 397), QColor(Qt::red)) << "nothing below shines through";
}

}  // namespace
}  // namespace sonde::ui::test
