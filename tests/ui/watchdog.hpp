// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <QApplication>
#include <QEvent>
#include <QPointer>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/platform/processor_time.hpp"
#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {

/// How long the event loop of the window's thread leaves an event waiting. A thread posts one,
/// waits until it is handled, and posts the next. What the thread had to wait for a processor that
/// others had (the kernel's own count) is taken off, and so is the time that VTK draws in, which is
/// counted apart. To be made and asked in the window's thread.
class Watchdog {
 public:
  struct Stall {
    double ms = 0;         ///< that the thread was busy or waited, but for what is below
    double drawing = 0;    ///< ms in VTK's own drawing
    double elsewhere = 0;  ///< ms without a processor, or waiting for the X server
    std::string during;
  };

  Watchdog() {
    task_ = std::to_string(syscall(SYS_gettid));
    ear_.heard = [this] { handled_ = true; };
    application().painting = [this](bool begins) { painted(begins); };
    application().resizing = [this](bool begins) { resized(begins); };
    thread_ = std::thread([this] { run(); });
  }
  ~Watchdog() {
    stopping_ = true;
    thread_.join();
    application().painting = application().resizing = nullptr;
    for (auto& [window, seen] : seen_)
      if (seen.widget) window->RemoveObserver(seen.command);
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// Names what follows. Whatever draws by now is listened to.
  void during(const std::string& what) {
    listen();
    const std::lock_guard lock(mutex_);
    during_ = what;
  }

  /// The longest of each name, in their order.
  std::vector<Stall> longest() const {
    const std::lock_guard lock(mutex_);
    return worst_;
  }
  /// ms of the longest picture that VTK drew.
  double longest_picture() const { return longest_picture_; }

 private:
  using Clock = std::chrono::steady_clock;
  static double ms_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  }

  static TestApplication& application() { return static_cast<TestApplication&>(*qApp); }
  static double processor_ms() { return 1e-3 * processor_time_us(); }

  struct Ear : QObject {
    std::function<void()> heard;
    bool event(QEvent* e) override {
      if (e->type() != QEvent::User) return QObject::event(e);
      heard();
      return true;
    }
  };
  struct Seen {
    QPointer<QWidget> widget;
    vtkSmartPointer<vtkCallbackCommand> command;
  };

  /// ms that the window's thread was ready to run and did not.
  double waited() const {
    std::ifstream in("/proc/self/task/" + task_ + "/schedstat");
    double ran = 0, waited = 0;
    in >> ran >> waited;
    return waited * 1e-6;
  }

  void run() {
    while (!stopping_) {
      const auto begin = Clock::now();
      const double waited_before = waited() + shown_, drawn_before = drawn_;
      handled_ = false;
      QApplication::postEvent(&ear_, new QEvent(QEvent::User), Qt::HighEventPriority);
      while (!handled_ && !stopping_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (stopping_) return;
      Stall stall;
      stall.elsewhere = waited() + shown_ - waited_before;
      stall.drawing = drawn_ - drawn_before;
      stall.ms = std::max(ms_since(begin) - stall.elsewhere - stall.drawing, 0.0);
      const std::lock_guard lock(mutex_);
      stall.during = during_;
      if (worst_.empty() || worst_.back().during != during_)
        worst_.push_back(stall);
      else if (worst_.back().ms < stall.ms)
        worst_.back() = stall;
    }
  }

  void listen() {
    for (QWidget* widget : QApplication::allWidgets())
      if (auto* canvas = dynamic_cast<QVTKOpenGLNativeWidget*>(widget)) {
        vtkRenderWindow* window = canvas->renderWindow();
        if (!window || seen_.count(window)) continue;
        auto command = vtkSmartPointer<vtkCallbackCommand>::New();
        command->SetClientData(this);
        command->SetCallback([](vtkObject* caller, unsigned long event, void* self, void*) {
          static_cast<Watchdog*>(self)->drew(static_cast<vtkRenderWindow&>(*caller), event);
        });
        window->AddObserver(vtkCommand::StartEvent, command);
        window->AddObserver(vtkCommand::EndEvent, command);
        seen_[window] = {canvas, command};
      }
  }

  void drew(vtkRenderWindow& window, unsigned long event) {
    if (event == vtkCommand::StartEvent) {
      picture_ = Clock::now();
      picture_waited_ = waited();
      return;
    }
    window.WaitForCompletion();  // OpenGL draws when it must, not when it is told
    const double ms = ms_since(picture_) - (waited() - picture_waited_);
    drawn_ = drawn_ + ms;
    longest_picture_ = std::max(longest_picture_, ms);
  }

  void painted(bool begins) {
    if (begins) {
      paint_ = {Clock::now(), processor_ms(), waited(), drawn_};
      return;
    }
    if (drawn_ > paint_.drawn) return;  // of that all is taken off
    const double asleep =
        ms_since(paint_.begin) - (processor_ms() - paint_.processor) - (waited() - paint_.waited);
    shown_ = shown_ + std::max(asleep, 0.0);
  }

  /// Around VTK's own picture, what OpenGL does for a canvas of another size: memory, and, drawing
  /// by processor, the programs that it translates.
  void resized(bool begins) {
    if (begins) {
      resize_ = {Clock::now(), 0, waited(), drawn_};
      return;
    }
    const double ms = ms_since(resize_.begin) - (waited() - resize_.waited);
    drawn_ = std::max(double(drawn_), resize_.drawn + ms);
  }

  struct Paint {
    Clock::time_point begin;
    double processor = 0, waited = 0, drawn = 0;
  } paint_, resize_;
  std::string task_;
  Ear ear_;
  std::atomic<bool> handled_{false}, stopping_{false};
  std::atomic<double> drawn_{0}, shown_{0};
  double longest_picture_ = 0, picture_waited_ = 0;
  Clock::time_point picture_;
  mutable std::mutex mutex_;
  std::string during_ = "before";
  std::vector<Stall> worst_;
  std::map<vtkRenderWindow*, Seen> seen_;
  std::thread thread_;
};

}  // namespace sonde::ui::test
