// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QLineEdit>
#include <QTest>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/document/pose_text.hpp"
#include "ui/panels/typed_value.hpp"

namespace sonde::ui::test {

/// A window with the scene of two cubes as its document.
class DocumentTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    window->activateWindow();
    ASSERT_TRUE(wait_until([this] { return window->isActiveWindow(); }));
  }
  void act(const char* name) {
    auto* action = window->findChild<QAction*>(name);
    ASSERT_TRUE(action) << name;
    action->trigger();
  }
  void key(Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
    window->viewport().canvas()->setFocus();
    QTest::keyClick(window->viewport().canvas(), key, with);
  }
  Document& document() { return window->documents().document(); }
  Pose pose() { return window->session()->device_pose(); }
  testing::AssertionResult comes_to(const Pose& wanted) {
    const bool there = wait_until([&] {
      return (pose().p - wanted.p).norm() < 1e-12 && pose().q.angularDistance(wanted.q) < 1e-12 &&
             window->shown() && (shown().separation.device.p - wanted.p).norm() < 1e-12;
    });
    if (there) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "it is at " << pose_text(pose()) << "and was to be at " << pose_text(wanted);
  }
  void type(const char* field, const QString& text) {
    auto* edit = window->findChild<QLineEdit*>(field);
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
  }
  void set_k(const QString& value) {
    auto* typed = window->findChild<TypedValue*>("k_value");
    typed->setFocus();
    typed->selectAll();
    QTest::keyClicks(typed, value);
    QTest::keyClick(typed, Qt::Key_Return);
  }
};

}  // namespace sonde::ui::test
