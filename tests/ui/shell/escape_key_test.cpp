// SPDX-License-Identifier: GPL-3.0-or-later
// Esc closes what is open and leaves the force, with each dialog and list of the program open.
// While a hand at a device with motors feels the force, that goes first. The key comes from another
// client of the X server, as from a keyboard.

#include <gtest/gtest.h>
#include <xcb/xcb.h>

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTimer>
#include <QWindow>
#include <chrono>
#include <cstdlib>
#include <ostream>
#include <thread>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/job.hpp"
#include "ui/devices/device_control.hpp"
#include "ui/panels/typed_value.hpp"
#include "ui/views/hint_view.hpp"

namespace sonde::ui::test {
namespace {

/// Something that is open above the window, and how it is opened. `open` may return only once it
/// has been closed.
struct Opening {
  const char* name;
  std::function<void(MainWindow&)> open;
};

void PrintTo(const Opening& opening, std::ostream* out) { *out << opening.name; }

std::function<void(MainWindow&)> by_action(const char* action) {
  return [action](MainWindow& window) { window.findChild<QAction*>(action)->trigger(); };
}

/// The question as the program asks it, whatever the fixture has put in its place.
template <class Ask>
std::function<void(MainWindow&)> by_prompt(Ask ask) {
  return [ask](MainWindow& window) {
    const Prompts prompts = dialogs(window);
    ask(prompts);
  };
}

const Opening openings[] = {
    {"error", by_prompt([](const Prompts& p) { p.report_error("bad.off:3: no number"); })},
    {"bodies", by_prompt([](const Prompts& p) { p.ask_bodies(MeshPair{}, PairSetup{}); })},
    {"leaving", by_prompt([](const Prompts& p) { p.ask_leaving("cubes"); })},
    {"save", by_prompt([](const Prompts& p) { p.ask_save("cubes.sonde.json"); })},
    {"reload", by_prompt([](const Prompts& p) { p.ask_reload("cubes.sonde.json"); })},
    {"overwrite", by_prompt([](const Prompts& p) { p.ask_overwrite("cubes.sonde.json"); })},
    {"paths", by_prompt([](const Prompts& p) { p.ask_paths("cubes", {"/elsewhere/cube.off"}); })},
    {"recover", by_prompt([](const Prompts& p) { p.ask_recover("cubes"); })},
    {"replace", by_prompt([](const Prompts& p) { p.ask_replace("cubes.contacts.csv"); })},
    {"record", by_prompt([](const Prompts& p) { p.ask_record(); })},
    {"recording", by_prompt([](const Prompts& p) { p.ask_recording(); })},
    {"role", by_prompt([](const Prompts& p) { p.ask_role("cube.off", 1); })},
    {"scene", by_prompt([](const Prompts& p) { p.ask_scene(); })},
    {"meshes", by_prompt([](const Prompts& p) { p.ask_meshes({}); })},
    {"path", by_prompt([](const Prompts& p) { p.ask_path(); })},
    {"picture", by_prompt([](const Prompts& p) { p.ask_picture(); })},
    {"tuning", by_prompt([](const Prompts& p) { p.ask_tuning(); })},
    {"tuning_folder", by_prompt([](const Prompts& p) { p.ask_tuning_folder(); })},
    {"export_picture", by_action("export_picture")},
    {"export_animation", by_action("export_animation")},
    {"export_vtk", by_action("export_vtk")},
    {"export_recording_pictures", by_action("export_recording_pictures")},
    {"find_command", by_action("find_command")},
    {"keys", by_action("keys")},
    {"about", by_action("about")},
    {"manual",
     [](MainWindow& window) {
       window.findChild<QAction*>("manual")->trigger();
       wait_until([&] { return !window.findChild<QDialog*>("manual")->isVisible(); });
     }},
    {"menu",
     [](MainWindow& window) {
       QMenu& menu = *window.menuBar()->actions()[0]->menu();
       menu.popup(window.mapToGlobal({10, 30}));
       wait_until([&] { return !menu.isVisible(); });
     }},
    {"list",
     [](MainWindow& window) {
       auto* list = window.findChild<QComboBox*>("holder");
       window.show_device_dock();
       list->showPopup();
       wait_until([&] { return !list->view()->isVisible(); });
     }},
    {"progress",
     [](MainWindow& window) {
       Job job(&window);
       bool ended = false;
       job.start(
           "Long work",
           [](const Progress& progress) {
             while (progress(0.3)) std::this_thread::sleep_for(std::chrono::milliseconds(2));
             throw Cancelled();
           },
           [&](std::exception_ptr) { ended = true; });
       wait_until([&] { return ended; });
     }},
};

/// Presses Esc while a window has the focus. Qt sees it once events are processed.
void press_escape(const QWindow& window) {
  xcb_connection_t* server = xcb_connect(nullptr, nullptr);
  xcb_key_press_event_t key{};
  key.detail = 9;  // with the drivers of X.Org
  key.event = static_cast<xcb_window_t>(window.winId());
  key.root = xcb_setup_roots_iterator(xcb_get_setup(server)).data->root;
  key.same_screen = 1;
  for (const auto& [type, mask] : {std::pair{XCB_KEY_PRESS, XCB_EVENT_MASK_KEY_PRESS},
                                   std::pair{XCB_KEY_RELEASE, XCB_EVENT_MASK_KEY_RELEASE}}) {
    key.response_type = static_cast<std::uint8_t>(type);
    xcb_send_event(server, 1, key.event, static_cast<std::uint32_t>(mask),
                   reinterpret_cast<const char*>(&key));
  }
  std::free(xcb_get_input_focus_reply(server, xcb_get_input_focus(server), nullptr));  // arrived
  xcb_disconnect(server);
}

QWidget* topmost() {
  if (QWidget* popup = QApplication::activePopupWidget()) return popup;
  if (QWidget* modal = QApplication::activeModalWidget()) return modal;
  for (QWidget* other : QApplication::topLevelWidgets())
    if (other->objectName() == "manual" && other->isVisible()) return other;
  return nullptr;
}

class EscapeTest : public WindowTest, public testing::WithParamInterface<Opening> {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (!HasFatalFailure()) open_cubes();
  }
  /// Waits, inside whatever event loop runs, until something is open; then acts.
  void once_open(const std::function<void(QWidget&)>& act) {
    timer.disconnect();
    timer.start(5);
    QObject::connect(&timer, &QTimer::timeout, [this, act] {
      QWidget* top = topmost();
      if (!top || !top->isVisible() || !top->windowHandle()) return;
      // Shortcuts work in the active window alone; there is no window manager to make it that.
      if (!top->isActiveWindow() && !QApplication::activePopupWidget())
        return top->activateWindow();
      timer.stop();
      act(*top);
    });
  }
  QTimer timer;
};

TEST_P(EscapeTest, closes_what_is_open_and_leaves_the_force) {
  bool closed = false;
  once_open([&](QWidget& top) {
    press_escape(*top.windowHandle());
    closed = wait_until([] { return !topmost(); });
    while (topmost()) topmost()->close();
  });
  GetParam().open(*window);
  EXPECT_TRUE(closed);
  EXPECT_TRUE(window->session()->force_on());
  // Nothing is open any more: the next one stops it, and the view says so.
  press_escape(*window->windowHandle());
  EXPECT_TRUE(wait_until([this] { return !window->session()->force_on(); }));
  EXPECT_TRUE(wait_until([this] { return shown().wrench.force.norm() == 0; }));
  EXPECT_TRUE(wait_until([this] {
    return window->findChild<HintView*>("hint_view")->banner().startsWith("Force stopped");
  }));
}

TEST_P(EscapeTest, closes_with_the_focus_on_the_window_below) {
  bool closed = false;
  once_open([&](QWidget& top) {
    const bool blocks = top.objectName() != "manual";
    press_escape(*(blocks ? *window : top).windowHandle());
    closed = wait_until([] { return !topmost(); });
    while (topmost()) topmost()->close();
  });
  GetParam().open(*window);
  EXPECT_TRUE(closed);
  EXPECT_TRUE(window->session()->force_on());
}

TEST_P(EscapeTest, cuts_a_force_that_is_felt_first_and_then_closes) {
  window->set_felt(true);
  std::vector<bool> was_open;  // each time the force was cut
  const auto cut = QObject::connect(window.get(), &MainWindow::force_changed,
                                    [&] { was_open.push_back(topmost() != nullptr); });
  bool closed = false;
  QSize size;
  once_open([&](QWidget& top) {
    size = top.frameGeometry().size();
    press_escape(*top.windowHandle());
    closed = wait_until([] { return !topmost(); });
    while (topmost()) topmost()->close();
  });
  GetParam().open(*window);
  QObject::disconnect(cut);
  EXPECT_TRUE(closed) << "Esc does what it always did";
  EXPECT_LE(size.width(), 1280);  // a small screen
  EXPECT_LE(size.height(), 800);
  ASSERT_FALSE(was_open.empty());
  EXPECT_TRUE(was_open.front()) << "but the force goes first";
  EXPECT_FALSE(window->session()->force_on());
  EXPECT_TRUE(wait_until([this] { return shown().wrench.force.norm() == 0; }));
}

/// Without a window manager, or where the focus follows the mouse, the window has the focus under a
/// dialog that blocks it.
TEST_P(EscapeTest, cuts_a_force_that_is_felt_with_the_focus_on_the_window_below) {
  window->set_felt(true);
  bool cut = false;
  once_open([&](QWidget&) {
    press_escape(*window->windowHandle());
    cut = wait_until([this] { return !window->session()->force_on(); });
    while (topmost()) topmost()->close();
  });
  GetParam().open(*window);
  EXPECT_TRUE(cut);
}

INSTANTIATE_TEST_SUITE_P(Each, EscapeTest, testing::ValuesIn(openings),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(WindowTest, escape_before_anything_is_open_holds_for_what_opens) {
  window->open({QString::fromStdString(scene.string())});
  press_escape(*window->windowHandle());
  ASSERT_TRUE(wait_until([this] { return opened == 1; }));
  EXPECT_FALSE(window->session()->force_on());
  EXPECT_FALSE(window->findChild<QAction*>("force")->isChecked());
}

TEST_F(EscapeTest, works_while_meshes_are_browsed_for) {
  auto browsed = false;
  window->set_felt(true);
  once_open([&](QWidget& meshes) {
    once_open([&](QWidget& browser) {
      press_escape(*browser.windowHandle());
      browsed = wait_until([&] { return !browser.isVisible(); });
      EXPECT_FALSE(window->session()->force_on());
    });
    meshes.findChild<QPushButton*>("probe_file_browse")->click();
    meshes.close();
  });
  dialogs(*window).ask_meshes({});
  EXPECT_TRUE(browsed);
}

TEST_F(EscapeTest, escape_takes_the_force_away_wherever_it_is_pressed) {
  auto* toggle = find<QAction>("force");
  const auto force = [this] { return shown().wrench.force.norm(); };
  for (QWidget* where :
       {static_cast<QWidget*>(find<TypedValue>("k_value")),
        static_cast<QWidget*>(find<QComboBox>("holder")), window->viewport().canvas()}) {
    ASSERT_TRUE(wait_until([&] { return force() > 0; }));
    QTest::keyClick(where, Qt::Key_Escape);
    EXPECT_FALSE(toggle->isChecked());
    EXPECT_TRUE(wait_until([&] { return force() == 0; }));
    auto* status = find<QLabel>("what_happens");
    EXPECT_TRUE(wait_until([&] { return status->text().contains("stopped"); }));
    toggle->trigger();
  }
  EXPECT_TRUE(wait_until([&] { return force() > 0; }));
}

TEST_F(EscapeTest, escape_while_a_scene_comes_with_a_complaint_is_seen) {
  folder.write("path.csv", "t,px,py,pz,qw,qx,qy,qz\n0,0.3,0,0,1,0,0,0\n");
  folder.write("path.sonde.json", R"({"probe": {"mesh": "cube.off"}, "fixed": {"mesh": "cube.off"},
      "trajectory": "path.csv"})");
  open({path("path.sonde.json")});
  window->devices().choose(PathSource{});
  window->prompts().report_error = [this](const QString& text) {
    complaints.push_back(text);
    QTest::keyClick(window->viewport().canvas(), Qt::Key_Escape);
  };
  open_cubes();
  ASSERT_EQ(complaints.size(), 1u) << "it has no path";
  EXPECT_FALSE(window->session()->force_on());
  EXPECT_FALSE(find<QAction>("force")->isChecked());
}

}  // namespace
}  // namespace sonde::ui::test
