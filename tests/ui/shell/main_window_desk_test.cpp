// SPDX-License-Identifier: GPL-3.0-or-later
// The window's docks: how much room the view has, that they fold away, and that nothing overlaps
// or is cut off at any size.

#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/elided_label.hpp"
#include "ui/shell/start_page.hpp"
#include "ui/views/hint_view.hpp"

namespace sonde::ui::test {
namespace {

class DeskLayout : public WindowTest {
 protected:
  void TearDown() override {
    darken();
    WindowTest::TearDown();
  }
  /// As at the first start.
  void first_window(const QSize& size) {
    keep_settings_in(folder / ("first" + std::to_string(size.width())));
    window = std::make_unique<MainWindow>();
    QObject::connect(window.get(), &MainWindow::opened, [this] { ++opened; });
    window->resize(size);
    window->show();
    open({QString::fromStdString(scene.string())});
    settle();
  }
  /// A cube of which each triangle has corners of its own, which do not quite meet.
  static std::string torn_cube(double side) {
    const int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                              {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    std::string points, triangles;
    int corners = 0;
    for (const auto& face : faces) {
      triangles += '3';
      for (const int corner : face) {
        for (int axis = 0; axis < 3; ++axis)
          points += std::to_string(((corner >> axis & 1) ? side : 0.0) +
                                   1e-6 * (corners * (axis + 1) % 7)) +
                    ' ';
        points += '\n';
        triangles += ' ' + std::to_string(corners++);
      }
      triangles += '\n';
    }
    return "OFF\n36 12 0\n" + points + triangles;
  }
  double share_of_view() const {
    const QSize view = window->viewport().size(), all = window->size();
    return double(view.width()) * view.height() / (double(all.width()) * all.height());
  }
  /// The window's parts that are on show, in its coordinates.
  std::vector<std::pair<std::string, QRect>> parts() const {
    std::vector<const QWidget*> widgets{window->menuBar(), window->statusBar(),
                                        window->centralWidget()};
    for (const QToolBar* bar : window->findChildren<QToolBar*>()) widgets.push_back(bar);
    for (const QDockWidget* dock : window->findChildren<QDockWidget*>()) widgets.push_back(dock);
    std::vector<std::pair<std::string, QRect>> out;
    for (const QWidget* widget : widgets)
      if (widget->isVisible())
        out.emplace_back(widget->objectName().toStdString(),
                         QRect(widget->mapTo(window.get(), QPoint()), widget->size()));
    return out;
  }
  void expect_disjoint() const {
    const auto all = parts();
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_TRUE(window->rect().contains(all[i].second)) << all[i].first;
      for (std::size_t k = i + 1; k < all.size(); ++k)
        EXPECT_FALSE(all[i].second.intersects(all[k].second))
            << all[i].first << " on " << all[k].first;
    }
    const std::vector<QRectF> plates = hints().boxes();
    for (std::size_t i = 0; i < plates.size(); ++i) {
      EXPECT_TRUE(QRectF(hints().rect()).contains(plates[i])) << "plate " << i;
      for (std::size_t k = i + 1; k < plates.size(); ++k)
        EXPECT_FALSE(plates[i].intersects(plates[k])) << "plates " << i << ", " << k;
    }
  }
  /// Words have the room that they need, and lie in their dock, or in what scrolls there.
  static void expect_whole(const QDockWidget& dock) {
    for (const QScrollArea* scroll : dock.findChildren<QScrollArea*>())
      if (scroll->isVisible() && scroll->widget()) {
        EXPECT_LE(scroll->widget()->minimumSizeHint().width(), scroll->viewport()->width())
            << dock.objectName().toStdString() << " is cut off at its right";
      }
    for (const QWidget* widget : dock.findChildren<QWidget*>()) {
      const auto* label = qobject_cast<const QLabel*>(widget);
      const auto* button = qobject_cast<const QAbstractButton*>(widget);
      if (!widget->isVisible() || (!label && !button)) continue;
      const QString words = label ? label->text() : button->text();
      if (words.isEmpty() || (label && label->minimumSizeHint().width() <= 1)) continue;  // elided
      const int need = label ? label->minimumSizeHint().width() : button->minimumSizeHint().width();
      EXPECT_GE(widget->width(), need)
          << dock.objectName().toStdString() << ": " << words.toStdString();
    }
  }
  /// Around both bodies on the screen.
  QRectF bodies() const {
    QRectF box;
    const auto add = [&](const Body& body, const Pose& X) {
      for (const Vec3& x : body.soup.vertices) {
        const QPointF at = window->viewport().on_screen(X * x);
        box = box.isNull() ? QRectF(at, QSizeF(1e-9, 1e-9)) : box.united({at, QSizeF(1e-9, 1e-9)});
      }
    };
    add(window->session()->fixed(), Pose());
    add(window->session()->probe(), window->session()->device_pose());
    return box;
  }
  /// Whether they are whole, and about the middle of what is free of overlays.
  bool in_the_middle() const {
    const QRectF box = bodies();
    return std::ranges::any_of(hints().clear_areas(), [&](const QRectF& area) {
      return area.adjusted(-2, -2, 2, 2).contains(box) &&
             std::abs(area.center().x() - box.center().x()) < 0.25 * area.width() &&
             std::abs(area.center().y() - box.center().y()) < 0.25 * area.height();
    });
  }
  static std::string words(const QRectF& box) {
    return std::to_string(box.left()) + ' ' + std::to_string(box.top()) + ' ' +
           std::to_string(box.right()) + ' ' + std::to_string(box.bottom());
  }
  const HintView& hints() const { return *window->findChild<HintView*>("hint_view"); }
};

TEST_F(DeskLayout, at_the_first_start_the_view_is_the_largest_thing) {
  for (const QSize size : {QSize(1152, 720), QSize(1280, 800), QSize(1440, 900)}) {
    first_window(size);
    ASSERT_EQ(window->size(), size);
    EXPECT_GE(share_of_view(), 0.6) << size.width();
    EXPECT_TRUE(find<QDockWidget>("readout_panel")->isVisible());
  }
}

/// What was mended of both bodies is said beside the tools, and costs the view nothing until it is
/// unfolded.
TEST_F(DeskLayout, with_own_meshes_that_were_mended_the_view_is_as_large) {
  folder.write("a rather long name of a cover (revision 12).off", torn_cube(70));
  folder.write("plate.off", torn_cube(100));
  for (const QSize size : {QSize(1152, 720), QSize(1280, 800), QSize(1440, 900)}) {
    SCOPED_TRACE(size.width());
    first_window(size);
    window->prompts().ask_bodies = [](const MeshPair& pair, const PairSetup&) {
      return std::optional(same_unit(pair, 1e-3));
    };
    open({path("a rather long name of a cover (revision 12).off"), path("plate.off")});
    settle();
    ASSERT_EQ(window->size(), size);
    EXPECT_GE(share_of_view(), 0.6);
    for (const char* words : {"mended_probe_notice", "mended_fixed_notice"}) {
      const auto* label = find<ElidedLabel>(words);
      EXPECT_TRUE(label->isVisible());
      EXPECT_EQ(label->shown(), "20 corners joined") << "it is not cut off";
    }
    expect_disjoint();
    const int tall = window->viewport().height();
    find<QToolButton>("mended_unfold")->click();
    settle();
    EXPECT_LT(window->viewport().height(), tall);
    EXPECT_EQ(find<ElidedLabel>("mended_fixed")->text(), "plate: 20 corners joined");
    expect_disjoint();
    find<QToolButton>("mended_unfold")->click();
    settle();
    EXPECT_EQ(window->viewport().height(), tall);
  }
}

TEST_F(DeskLayout, a_tab_opens_its_dock_in_place_of_another_and_folds_it_away) {
  first_window({1280, 800});
  const double before = share_of_view();
  auto* readout = find<QDockWidget>("readout_panel");
  auto* seeing = find<QDockWidget>("seeing_panel");
  find<QToolButton>("tab_seeing_panel")->click();
  EXPECT_TRUE(seeing->isVisible());
  EXPECT_FALSE(readout->isVisible());
  EXPECT_FALSE(find<QToolButton>("tab_readout_panel")->isChecked());
  find<QToolButton>("tab_seeing_panel")->click();
  EXPECT_FALSE(seeing->isVisible());
  settle();
  EXPECT_GT(share_of_view(), before + 0.1) << "the view has the room";
  find<QToolButton>("tab_readout_panel")->click();
  settle();
  const int wide = readout->width();
  find<QToolButton>("tab_parts_panel")->click();
  settle();
  EXPECT_TRUE(readout->isVisible()) << "at another side";
  EXPECT_EQ(readout->width(), wide);
  act("fold_docks");
  EXPECT_FALSE(readout->isVisible());
  EXPECT_FALSE(find<QDockWidget>("parts_panel")->isVisible());
  act("fold_docks");
  EXPECT_TRUE(readout->isVisible());
  EXPECT_TRUE(find<QDockWidget>("parts_panel")->isVisible());
}

/// A dock that opens at one side takes its room from the view.
TEST_F(DeskLayout, what_is_open_at_the_other_side_is_not_cut_off) {
  for (const char* name : {"coupling_panel", "pose_panel", "device_panel", "parts_panel",
                           "way_in_panel", "clash_panel", "accuracy_panel"}) {
    SCOPED_TRACE(name);
    first_window({1152, 720});  // each as the first that opens
    const auto* readout = find<QDockWidget>("readout_panel");
    const auto* dock = find<QDockWidget>(name);
    const int wide = readout->width();
    find<QToolButton>((std::string("tab_") + name).c_str())->click();
    settle();
    ASSERT_TRUE(dock->isVisible() && readout->isVisible());
    EXPECT_EQ(readout->width(), wide) << "beside one of " << dock->width();
    expect_whole(*dock);
    expect_whole(*readout);
  }
}

TEST_F(DeskLayout, the_start_page_stands_alone_and_the_docks_come_back) {
  first_window({1280, 800});
  find<QToolButton>("tab_pose_panel")->click();
  act("new");
  ASSERT_TRUE(window->findChild<StartPage*>("start_page")->isVisible());
  for (const QDockWidget* dock : window->findChildren<QDockWidget*>())
    EXPECT_FALSE(dock->isVisible()) << dock->objectName().toStdString();
  open_cubes();
  for (const char* dock : {"pose_panel", "readout_panel", "timeline_panel"})
    EXPECT_TRUE(find<QDockWidget>(dock)->isVisible()) << dock;
  act("new");
  window->close();  // from the start page
  window = std::make_unique<MainWindow>();
  QObject::connect(window.get(), &MainWindow::opened, [this] { ++opened; });
  window->show();
  open_cubes();
  EXPECT_TRUE(find<QDockWidget>("pose_panel")->isVisible()) << "as it was left";
}

TEST_F(DeskLayout, no_dock_stands_round_a_question_about_what_is_being_opened) {
  first_window({1280, 800});
  int visible = -1;
  window->prompts().ask_bodies = [&](const MeshPair& pair, const PairSetup&) {
    visible = 0;
    for (const QDockWidget* dock : window->findChildren<QDockWidget*>())
      visible += dock->isVisible();
    return std::optional(same_unit(pair, 1));
  };
  window->clear_desk();
  open({path("cube.off"), path("large.off")});
  EXPECT_EQ(visible, 0);
  EXPECT_TRUE(find<QDockWidget>("readout_panel")->isVisible());
}

TEST_F(DeskLayout, nothing_overlaps_or_is_cut_off_at_any_size) {
  open_cubes();
  for (const char* theme : {"theme_dark", "theme_light"})
    for (const QSize size : {QSize(1152, 720), QSize(1280, 800), QSize(1600, 1000)}) {
      act(theme);
      window->resize(size);
      for (QDockWidget* dock : window->docks_of_sides()) {
        SCOPED_TRACE(theme + std::to_string(size.width()) + dock->objectName().toStdString());
        dock->show();
        settle();
        ASSERT_EQ(window->size(), size) << "a dock wants more room than there is";
        expect_disjoint();
        for (const QDockWidget* each : window->docks_of_sides())
          if (each->isVisible()) expect_whole(*each);
      }
    }
}

TEST_F(DeskLayout, hint_and_legend_go_after_the_first_drag_and_come_back_by_a_key) {
  open_cubes();
  const std::size_t before = hints().boxes().size();
  ASSERT_TRUE(window->viewport().shown(Layer::hint));
  const QPointF at = window->viewport().on_screen(com());
  drag(Qt::LeftButton, at, {30, 0});
  ASSERT_TRUE(wait_until([this] { return !window->viewport().shown(Layer::hint); }));
  EXPECT_EQ(hints().boxes().size(), before - 2);
  // The bodies are fitted into the room that this leaves.
  const CameraPlace faded = window->viewport().place();
  window->viewport().fit();
  EXPECT_LT((window->viewport().place().position - faded.position).norm(),
            1e-3 * (faded.position - faded.target).norm());
  EXPECT_FALSE(find<QAction>("show_hint")->isChecked());
  act("show_hint");
  EXPECT_TRUE(window->viewport().shown(Layer::hint));
  EXPECT_EQ(hints().boxes().size(), before);
  drag(Qt::LeftButton, window->viewport().on_screen(com()), {-30, 0});
  settle();
  EXPECT_TRUE(window->viewport().shown(Layer::hint)) << "who wants them keeps them";
}

TEST_F(DeskLayout, a_grid_lies_on_the_ground_on_wish) {
  open_cubes();
  window->set_paused(true);
  const QImage without = picture();
  act("show_grid");
  const QImage with = picture();
  EXPECT_GT(pixels_between(without, with), 500);
  act("show_grid");
  EXPECT_LT(pixels_between(without, picture()), 20);
}

TEST_F(DeskLayout, a_dock_that_folds_or_unfolds_covers_no_body) {
  first_window({1152, 720});
  find<QToolButton>("tab_parts_panel")->click();
  find<QToolButton>("tab_readout_panel")->setChecked(true);
  for (const char* const how : {"as it opened", "turned"}) {
    SCOPED_TRACE(how);
    for (int times = 0; times < 2; ++times) {
      act("fold_docks");
      settle();
      EXPECT_TRUE(in_the_middle()) << words(bodies());
      act("fold_docks");
      settle();
      EXPECT_TRUE(in_the_middle()) << words(bodies());
    }
    window->viewport().camera().orbit(0.5, 0.2);
    window->viewport().fit();
    window->viewport().camera().orbit(0.02, 0.0);
  }
  // Who has gone near sees the same place as near.
  window->viewport().camera().zoom(4);
  const CameraPlace near = window->viewport().place();
  act("fold_docks");
  wait(100);
  EXPECT_EQ(window->viewport().place().position, near.position);
  EXPECT_EQ(window->viewport().place().target, near.target);
}

TEST_F(DeskLayout, both_bodies_open_whole_and_in_the_middle_of_what_is_free) {
  for (const char* name : {"peg-in-hole", "spoon-in-cup", "nut-on-bolt"}) {
    window->resize(1152, 720);
    consent = Consent::once;
    open({QStringLiteral(SONDE_RESOURCES "/scenes/%1.sonde.json").arg(name)});
    EXPECT_TRUE(in_the_middle()) << name << ' ' << words(bodies());
  }
}

}  // namespace
}  // namespace sonde::ui::test
