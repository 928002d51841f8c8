// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/recording_writer.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "engine/recording/recording.hpp"
#include "tests/engine/recording/made_up_ticks.hpp"

namespace sonde::test {
namespace {

using testing::HasSubstr;

class Writer : public RecordingTest {
 protected:
  /// A log whose blocks go to the writer.
  static TickLog log_to(RecordingWriter& writer) {
    TickLog log(made_up_radius, 1000);
    log.sealed = [&writer](const std::shared_ptr<const std::string>& bytes) {
      writer.add([bytes] { return *bytes; });
    };
    return log;
  }
};

TEST_F(Writer, writes_as_the_ticks_come) {
  const std::vector<Snapshot> ticks = made_up_ticks(2000);
  RecordingWriter writer(folder / "a.sonderec", header_of(scene, made_up_radius));
  TickLog log = log_to(writer);
  for (const Snapshot& tick : ticks) log.add(tick);
  log.add(made_up_search(5));
  log.seal();
  writer.finish();
  EXPECT_EQ(writer.failure(), std::nullopt);
  const auto r = read_recording(folder / "a.sonderec");
  EXPECT_EQ(r->cut, "");
  EXPECT_EQ(r->bytes, writer.bytes());
  EXPECT_EQ(r->ticks.end(), ticks.size());
  EXPECT_EQ(r->ticks.at(1999).separation.device.p, ticks[1999].separation.device.p);
  ASSERT_EQ(r->ticks.searches().size(), 1u);
  EXPECT_EQ(r->ticks.searches()[0].result.time_us, 5);
}

TEST_F(Writer, begins_with_what_was_kept_before) {
  const std::vector<Snapshot> ticks = made_up_ticks(3000);
  TickLog log(made_up_radius, 1000, {.ticks = 1500});
  for (std::size_t i = 0; i < 2000; ++i) log.add(ticks[i]);
  log.add(made_up_search(1));
  log.seal();
  const std::uint64_t first = log.begin();
  ASSERT_GT(first, 0u);
  RecordingWriter writer(folder / "a.sonderec", header_of(scene, made_up_radius));
  for (BlockBytes& block : log.all()) writer.add(std::move(block));
  log.sealed = [&writer](const std::shared_ptr<const std::string>& bytes) {
    writer.add([bytes] { return *bytes; });
  };
  for (std::size_t i = 2000; i < 3000; ++i) log.add(ticks[i]);
  log.seal();
  writer.finish();
  const auto r = read_recording(folder / "a.sonderec");
  EXPECT_EQ(r->cut, "");
  ASSERT_EQ(r->ticks.end(), 3000 - first);
  for (std::uint64_t i = 0; i < r->ticks.end(); i += 11)
    ASSERT_EQ(r->ticks.at(i).time, ticks[i + first].time);
  EXPECT_EQ(r->ticks.searches().size(), 1u);
}

TEST_F(Writer, a_killed_program_leaves_all_whole_blocks) {
  const pid_t child = ::fork();
  if (child == 0) {
    RecordingWriter writer(folder / "a.sonderec", header_of(scene, made_up_radius));
    TickLog log = log_to(writer);
    for (std::uint64_t run = 0;; ++run)
      for (const Snapshot& tick : made_up_ticks(512, run)) {
        log.add(tick);
        if (writer.bytes() > 1'000'000) ::raise(SIGKILL);
      }
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  const auto r = read_recording(folder / "a.sonderec");
  EXPECT_THAT(r->cut, HasSubstr("it ends"));
  EXPECT_GE(r->readable, 1'000'000u);
  EXPECT_EQ(r->ticks.end() % TickLog::block_ticks, 0u);
  EXPECT_NO_THROW(r->ticks.at(r->ticks.end() - 1));
}

TEST_F(Writer, a_recording_that_is_open_stays_readable_while_it_is_replaced) {
  const std::vector<Snapshot> ticks = made_up_ticks(1500);
  const auto old = read_recording(recording("a.sonderec", ticks));
  RecordingWriter writer(folder / "a.sonderec", header_of(scene, made_up_radius));
  writer.finish();
  EXPECT_EQ(old->ticks.at(1400).time, ticks[1400].time);
  EXPECT_EQ(read_recording(folder / "a.sonderec")->ticks.end(), 0u);
}

TEST_F(Writer, a_full_disk_is_told_of) {
  RecordingWriter writer("/dev/full", header_of(scene, made_up_radius));
  writer.finish();
  EXPECT_THAT(writer.failure().value_or(""), HasSubstr("/dev/full: cannot be written: No space"));
}

TEST_F(Writer, a_folder_that_is_not_there_is_told_of) {
  EXPECT_THROW(RecordingWriter(folder / "nowhere/a.sonderec", header_of(scene, made_up_radius)),
               InputError);
}

TEST_F(Writer, it_closes_in_its_own_thread) {
  RecordingWriter writer(folder / "a.sonderec", header_of(scene, made_up_radius));
  TickLog log = log_to(writer);
  for (const Snapshot& tick : made_up_ticks(1000)) log.add(tick);
  log.seal();
  EXPECT_FALSE(writer.closed());
  writer.close();
  for (int i = 0; i < 10'000 && !writer.closed(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ASSERT_TRUE(writer.closed());
  EXPECT_EQ(read_recording(folder / "a.sonderec")->cut, "");
}

TEST_F(Writer, every_part_of_a_body_is_marked) {
  folder.write("other.off", test::text_of(scene.fixed.mesh));
  SceneBody part = scene.fixed;
  scene.fixed.parts = {part, part};
  scene.fixed.parts[1].mesh = folder / "other.off";
  scene.fixed.parts[1].name = "other";
  EXPECT_EQ(marks_of(scene).fixed.bytes, 2 * mark_of(scene.fixed.mesh).bytes);
  { RecordingWriter writer(folder / "a.sonderec", header_of(scene, made_up_radius)); }
  const auto r = read_recording(folder / "a.sonderec");
  EXPECT_NO_THROW(check_meshes(r->header, folder / "a.sonderec"));
  folder.write("other.off", "another");
  EXPECT_THROW(check_meshes(r->header, folder / "a.sonderec"), InputError);
}

/// The mesh that was read is the recorded one, whatever lies on the disk by now.
TEST_F(Writer, meshes_are_those_that_were_read) {
  const MeshMarks read = marks_of(scene);
  folder.write("fixed.off", "another");
  { RecordingWriter writer(folder / "a.sonderec", header_of(scene, read, made_up_radius)); }
  const auto r = read_recording(folder / "a.sonderec");
  EXPECT_EQ(r->header.meshes.fixed, read.fixed);
  EXPECT_THROW(check_meshes(r->header, folder / "a.sonderec"), InputError);
}

}  // namespace
}  // namespace sonde::test
