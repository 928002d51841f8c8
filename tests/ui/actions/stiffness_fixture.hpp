// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

#include "tests/ui/canned_study.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/actions/stiffness_control.hpp"
#include "ui/panels/stiffness_panel.hpp"

namespace sonde::ui::test {

/// A window with the scene of two cubes, its stiffness dock on top, and studies to load.
class StiffnessTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    write_canned_study(folder / "tuned", folder / "cube.off", folder / "cube.off");
    write_canned_study(folder / "fitting", folder / "cube.off", folder / "cube.off", "sigma.7",
                       "conforming");
    window->stiffness().panel().show();
  }
  StiffnessControl& stiffness() { return window->stiffness(); }
  /// Ends with the tuning read, or with a complaint.
  void load(const char* name) {
    const auto before = complaints.size();
    const auto* old = stiffness().tuning() ? &stiffness().tuning()->folder : nullptr;
    const std::string was = old ? old->string() : "";
    stiffness().load(path(name));
    ASSERT_TRUE(wait_until([&] {
      return complaints.size() > before ||
             (stiffness().tuning() && stiffness().tuning()->folder.string() != was);
    }));
  }
  double k() const { return window->session()->coupling().k; }
  QString text(const char* label) { return find<QLabel>(label)->text(); }
};

}  // namespace sonde::ui::test
