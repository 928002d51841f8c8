// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/job.hpp"

#include <gtest/gtest.h>

#include <QDialog>
#include <QProgressBar>
#include <QPushButton>
#include <chrono>
#include <thread>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

enum class End { none, done, cancelled, failed };

End end_of(const std::exception_ptr& error) {
  if (!error) return End::done;
  try {
    std::rethrow_exception(error);
  } catch (const Cancelled&) {
    return End::cancelled;
  } catch (...) {
    return End::failed;
  }
}

void slow_work(const Progress& progress) {
  for (int i = 0;; ++i) {
    if (!progress(std::min(0.01 * i, 1.0))) throw Cancelled();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

TEST_F(WindowTest, slow_work_shows_its_progress_and_can_be_cancelled) {
  Job job(window.get());
  End end = End::none;
  job.start("Slow work", slow_work, [&](std::exception_ptr error) { end = end_of(error); });
  auto* dialog = window->findChild<QDialog*>("progress_dialog");
  ASSERT_TRUE(dialog);
  EXPECT_FALSE(dialog->isVisible()) << "quick work needs none";
  auto* bar = dialog->findChild<QProgressBar*>();
  ASSERT_TRUE(bar);
  ASSERT_TRUE(wait_until([&] { return dialog->isVisible() && bar->value() > 0; }));
  dialog->findChild<QPushButton*>()->click();
  EXPECT_EQ(end, End::cancelled);
  EXPECT_FALSE(job.running());
}

TEST_F(WindowTest, newer_work_replaces_older) {
  Job job(window.get());
  End first = End::none, second = End::none;
  job.start("First", slow_work, [&](std::exception_ptr error) { first = end_of(error); });
  job.start(
      "Second", [](const Progress&) {}, [&](std::exception_ptr error) { second = end_of(error); });
  EXPECT_TRUE(wait_until([&] { return second == End::done; }));
  EXPECT_EQ(first, End::none) << "nobody waits for it any more";
}

TEST_F(WindowTest, work_that_throws_says_so) {
  Job job(window.get());
  End end = End::none;
  job.start(
      "Bad", [](const Progress&) { throw std::runtime_error("bad"); },
      [&](std::exception_ptr error) { end = end_of(error); });
  EXPECT_TRUE(wait_until([&] { return end == End::failed; }));
}

}  // namespace
}  // namespace sonde::ui::test
