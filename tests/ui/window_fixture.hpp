// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QImage>
#include <QMouseEvent>
#include <QOpenGLWidget>
#include <QPalette>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>

#include "tests/support/temp_folder.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui::test {

/// On a machine that does much else.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int patience_ms = 120'000;
#else
inline constexpr int patience_ms = 30'000;
#endif

/// Tells when a window paints itself and hands its picture to the display, and when a canvas of
/// OpenGL takes another size: Qt and VTK draw it anew within that event.
class TestApplication : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* to, QEvent* event) override {
    const bool paints = event->type() == QEvent::UpdateRequest || event->type() == QEvent::Expose;
    if (paints) return told(painting, to, event);
    const bool resizes = event->type() == QEvent::Resize && qobject_cast<QOpenGLWidget*>(to);
    return resizes ? told(resizing, to, event) : QApplication::notify(to, event);
  }
  std::function<void(bool begins)> painting, resizing;

 private:
  bool told(const std::function<void(bool)>& tell, QObject* to, QEvent* event) {
    if (tell) tell(true);
    const bool handled = QApplication::notify(to, event);
    if (tell) tell(false);
    return handled;
  }
};

/// As the program is unless another theme is chosen: dark.
inline void darken() { QApplication::setPalette(QPalette(QColor(50, 57, 66), QColor(36, 41, 48))); }

/// The one application of the test program. It lives until the end: Qt wants no second one.
inline void need_application() {
  static int count = 1;
  static char name[] = "test_ui";
  static char* arguments[] = {name, nullptr};
  if (QApplication::instance()) return;
  QSurfaceFormat::setDefaultFormat(Viewport::surface_format());
  new TestApplication(count, arguments);
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setOrganizationName("sonde-test");
  darken();
}

/// Runs the event loop until something holds; false if it never does.
inline bool wait_until(const std::function<bool()>& holds) {
  QElapsedTimer clock;
  clock.start();
  while (!holds()) {
    if (clock.elapsed() > patience_ms) return false;
    QApplication::processEvents(QEventLoop::AllEvents, 10);
    QThread::usleep(500);  // leaves the processor to who is waited for, and to other tests
  }
  return true;
}

inline void wait(int ms) {
  QElapsedTimer clock;
  clock.start();
  wait_until([&] { return clock.elapsed() >= ms; });
}

/// Pixels that differ visibly between two pictures of one size.
inline int pixels_between(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return -1;
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      count += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) +
                   std::abs(qBlue(p) - qBlue(q)) >
               30;
    }
  return count;
}

/// A window on show, with its questions and complaints kept instead of asked. The scene at hand is
/// a cube of 100 mm that overlaps another by 10 mm in x.
class WindowTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* display = std::getenv("DISPLAY");
    ASSERT_TRUE(display && *display) << "these tests open windows: set DISPLAY (Xvfb will do)";
    need_application();
    // Profiles and settings of devices too: none of the person's who runs the tests.
    keep_settings_in(folder.path());
    qputenv("XDG_DATA_HOME", QByteArray::fromStdString((folder / "data").string()));
    window = std::make_unique<MainWindow>();
    window->prompts().report_error = [this](const QString& text) { complaints.push_back(text); };
    window->prompts().ask_bodies = [this](const MeshPair& pair, const PairSetup&) {
      guess = guess_unit(pair);
      return answered_unit ? std::optional(same_unit(pair, *answered_unit)) : std::nullopt;
    };
    window->prompts().ask_paths = [this](const QString&, const QStringList& paths) {
      paths_asked_for << paths;
      return consent;
    };
    window->prompts().ask_leaving = [this](const QString&) {
      ++asked_to_leave;
      return leaving;
    };
    QObject::connect(window.get(), &MainWindow::opened, [this] { ++opened; });
    QObject::connect(window.get(), &MainWindow::open_failed, [this] { ++failed; });
    folder.write("cube.off", cube(0.1));
    folder.write("large.off", cube(100));
    folder.write("open.off", cube(100, 11));
    scene = folder.write("cubes.sonde.json", R"({"unit": "m",
        "probe": {"mesh": "cube.off", "pose": [0.09, 0.02, 0.013, 1, 0, 0, 0]},
        "fixed": {"mesh": "cube.off", "pose": [0, 0, 0, 1, 0, 0, 0]},
        "coupling": {"mode": "object", "k": 500}})");
    window->resize(1280, 800);
    window->show();
    find<QDockWidget>("coupling_panel")->show();
    ASSERT_TRUE(wait_until([this] { return window->isVisible(); }));
  }

  /// Settings are those of this folder from now on.
  static void keep_settings_in(const std::filesystem::path& home) {
    qputenv("XDG_CONFIG_HOME", QByteArray::fromStdString(home.string()));
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       QString::fromStdString(home.string()));
  }

  /// A cube as OFF text, its lower corner at the origin; fewer than 12 triangles leave it open.
  static std::string cube(double side, int triangles = 12) {
    const int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                              {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    std::string text = "OFF\n8 " + std::to_string(triangles) + " 0\n";
    for (int i = 0; i < 8; ++i) {
      for (int axis = 0; axis < 3; ++axis)
        text += std::to_string((i >> axis & 1) ? side : 0.0) + ' ';
      text += '\n';
    }
    for (int i = 0; i < triangles; ++i)
      text += "3 " + std::to_string(faces[i][0]) + ' ' + std::to_string(faces[i][1]) + ' ' +
              std::to_string(faces[i][2]) + '\n';
    return text;
  }

  void open(const QStringList& files, std::optional<double> unit = std::nullopt) {
    const int before = opened + failed;
    window->open(files, unit);
    ASSERT_TRUE(wait_until([&] { return opened + failed > before; })) << "neither opened nor not";
    if (window->session()) {
      ASSERT_TRUE(wait_until([&] { return window->shown().has_value(); }));
    }
  }
  void open_cubes() {
    open({QString::fromStdString(scene.string())});
    ASSERT_EQ(failed, 0) << (complaints.empty() ? "" : complaints[0].toStdString());
    ASSERT_TRUE(wait_until([this] { return shown().separation.status == Status::penetrating; }));
  }
  QString path(const char* name) const { return QString::fromStdString((folder / name).string()); }
  const Snapshot& shown() const { return *window->shown(); }
  Vec3 com() const {
    return window->session()->device_pose() * window->session()->probe().mass.com;
  }

  /// What has this name in the window.
  template <class T>
  T* find(const char* name) const {
    T* found = window->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  /// Triggers a command of the menus.
  void act(const char* name) {
    auto* action = find<QAction>(name);
    ASSERT_TRUE(action);
    action->trigger();
  }
  /// Shortcuts want an active window.
  void activate() {
    window->activateWindow();
    ASSERT_TRUE(wait_until([this] { return window->isActiveWindow(); }));
  }
  /// A key for the view.
  void key(Qt::Key key, Qt::KeyboardModifiers keys = Qt::NoModifier) {
    window->viewport().canvas()->setFocus();
    QTest::keyClick(window->viewport().canvas(), key, keys);
  }
  /// Types over what a field holds: a QLineEdit, or a spin box.
  void type(const char* field, const QString& text) {
    auto* edit = find<QWidget>(field);
    ASSERT_TRUE(edit);
    edit->setFocus();
    ASSERT_TRUE(QMetaObject::invokeMethod(edit, "selectAll"));
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
  }

  /// A drag as a hand makes it: press, moves with the button held, release.
  void drag(Qt::MouseButton button, QPointF from, QPointF by,
            Qt::KeyboardModifiers keys = Qt::NoModifier) {
    send(QEvent::MouseButtonPress, from, button, button, keys);
    for (int i = 1; i <= 5; ++i)
      send(QEvent::MouseMove, from + by * (i / 5.0), Qt::NoButton, button, keys);
    send(QEvent::MouseButtonRelease, from + by, button, Qt::NoButton, keys);
  }
  void send(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held,
            Qt::KeyboardModifiers keys) {
    QMouseEvent event(type, at, button, held, keys);
    QApplication::sendEvent(window->viewport().canvas(), &event);
  }
  /// Until all is laid out and drawn: some turns of a clock like the window's without a picture.
  void settle() {
    std::size_t frames = window->frames();
    int quiet = 0;
    QTimer clock;
    clock.setTimerType(Qt::PreciseTimer);
    QObject::connect(&clock, &QTimer::timeout, [&] {
      quiet = window->frames() == frames ? quiet + 1 : 0;
      frames = window->frames();
    });
    clock.start(16);
    EXPECT_TRUE(wait_until([&] { return quiet >= 4; })) << "it never comes to rest";
  }
  QImage picture() {
    window->viewport().invalidate();
    const std::size_t frames = window->frames();
    wait_until([&] { return window->frames() > frames; });
    return window->viewport().picture();
  }

  sonde::test::TempFolder folder;
  std::filesystem::path scene;
  std::unique_ptr<MainWindow> window;
  std::vector<QString> complaints;
  std::optional<double> answered_unit;
  Consent consent = Consent::kept;  // to what scenes name outside of their folders
  QStringList paths_asked_for;
  Leaving leaving = Leaving::discard;  ///< the answer
  int asked_to_leave = 0;
  std::string guess;
  int opened = 0, failed = 0;
};

}  // namespace sonde::ui::test
