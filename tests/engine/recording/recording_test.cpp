// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/recording.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cmath>
#include <limits>

#include "engine/recording/recording_writer.hpp"
#include "tests/engine/recording/made_up_ticks.hpp"

namespace sonde::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class RecordingFile : public RecordingTest {
 protected:
  /// Why a file with these bytes cannot be read at all; empty where it can, which is then in
  /// `read`.
  std::string complaint(const std::string& bytes) {
    const auto file = folder.write("damaged.sonderec", bytes);
    read.reset();
    try {
      read = read_recording(file);
    } catch (const InputError& bad) {
      EXPECT_THAT(bad.what(), StartsWith(file.string() + ":"));
      return std::string(bad.what()).substr(file.string().size() + 1);
    }
    return {};
  }
  std::unique_ptr<Recording> read;
};

TEST_F(RecordingFile, holds_what_was_written) {
  const std::vector<Snapshot> ticks = made_up_ticks(1300);
  const auto file = recording("whole.sonderec", ticks);
  const auto r = read_recording(file);
  EXPECT_EQ(r->cut, "");
  EXPECT_EQ(r->readable, r->bytes);
  EXPECT_EQ(r->header.scene.name, "two");
  EXPECT_EQ(r->header.scene.unit, 1e-3);
  EXPECT_EQ(r->header.scene.fixed.scale, 2);
  EXPECT_TRUE(std::filesystem::equivalent(r->header.scene.probe.mesh, folder / "probe.off"));
  EXPECT_EQ(r->header.probe_radius, made_up_radius);
  EXPECT_EQ(r->header.rate_hz, 1000);
  ASSERT_EQ(r->ticks.end(), ticks.size());
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    ASSERT_EQ(r->ticks.at(i).time, ticks[i].time);
    ASSERT_EQ(r->ticks.at(i).separation.device.q.coeffs(), ticks[i].separation.device.q.coeffs());
  }
  check_meshes(r->header, file);
}

TEST_F(RecordingFile, the_paths_of_its_scene_out_of_a_folder_are_listed_and_not_read) {
  const auto file = recording("two.sonderec", made_up_ticks(2));
  EXPECT_THAT(recorded_paths_out_of(folder.path(), file), testing::IsEmpty());
  std::filesystem::create_directory(folder / "other");
  std::filesystem::remove(folder / "probe.off");
  const auto named = recorded_paths_out_of(folder / "other", file);
  ASSERT_FALSE(named.empty());
  EXPECT_EQ(named[0].lexically_normal(), (folder / "probe.off").lexically_normal());
  folder.write("none.sonderec", "SONDEREC");
  EXPECT_THROW(recorded_paths_out_of(folder.path(), folder / "none.sonderec"), InputError);
}

TEST_F(RecordingFile, cut_at_any_byte_it_is_read_up_to_the_last_whole_block) {
  TickLog log(made_up_radius, 1000);
  const std::vector<Snapshot> ticks = made_up_ticks(8);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    log.add(ticks[i]);
    if (i % 2 == 1) log.seal();  // small blocks
  }
  write_recording(folder / "whole.sonderec", header_of(scene, made_up_radius), log);
  const std::string whole = text_of(folder / "whole.sonderec");
  const std::size_t header = read_header(whole, "x").size;
  std::uint64_t before = 0;
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    SCOPED_TRACE(size);
    const std::string reason = complaint(whole.substr(0, size));
    if (size < header) {
      EXPECT_THAT(reason, HasSubstr("byte "));
      EXPECT_EQ(read, nullptr);
      continue;
    }
    ASSERT_NE(read, nullptr) << reason;
    EXPECT_EQ(read->cut.empty(), size == whole.size()) << read->cut;
    EXPECT_LE(read->readable, size);
    EXPECT_EQ(read->ticks.end() % 2, 0u);
    EXPECT_GE(read->ticks.end(), before) << "a longer file holds no less";
    before = read->ticks.end();
    if (before > 0) {
      EXPECT_EQ(read->ticks.at(before - 1).time, ticks[before - 1].time);
    }
  }
  EXPECT_EQ(before, 8u);
}

TEST_F(RecordingFile, any_bit_that_is_another_is_noticed) {
  TickLog log(made_up_radius, 1000);
  for (const Snapshot& tick : made_up_ticks(6)) log.add(tick);
  log.seal();
  write_recording(folder / "whole.sonderec", header_of(scene, made_up_radius), log);
  const std::string whole = text_of(folder / "whole.sonderec");
  for (std::size_t bit = 0; bit < 8 * whole.size(); bit += 41) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    const std::string reason = complaint(damaged);
    const bool noticed = !reason.empty() || !read->cut.empty();
    EXPECT_TRUE(noticed) << "bit " << bit;
  }
}

TEST_F(RecordingFile, of_a_newer_version_it_says_so) {
  std::string bytes = text_of(recording("whole.sonderec", made_up_ticks(3)));
  bytes[8] = 2;
  EXPECT_THAT(complaint(bytes), HasSubstr("byte 8: a recording of version 2; this program reads"));
}

TEST_F(RecordingFile, what_is_none_is_refused) {
  EXPECT_THAT(complaint("OFF\n"), HasSubstr("byte 0: no recording begins here"));
  EXPECT_THAT(complaint(""), HasSubstr("no recording"));
  EXPECT_FALSE(is_recording(folder / "damaged.sonderec"));
  EXPECT_TRUE(is_recording(recording("whole.sonderec", made_up_ticks(3))));
  EXPECT_THROW(read_recording(folder.path()), InputError);
  EXPECT_THROW(read_recording(folder / "nowhere"), InputError);
}

TEST_F(RecordingFile, a_pipe_is_none_and_is_not_opened) {
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  // Nobody writes to it: who opens it for reading waits for ever.
  EXPECT_FALSE(is_recording(folder / "pipe"));
}

TEST_F(RecordingFile, a_header_with_numbers_that_cannot_be_is_refused) {
  const TickLog none(made_up_radius, 1000);
  RecordingHeader header = header_of(scene, made_up_radius);
  for (const double bad : {0.0, -1.0}) {
    header.probe_radius = bad;
    EXPECT_THAT(complaint(recording_bytes(folder / "x", header, none)), HasSubstr("probe_radius"));
    header.probe_radius = made_up_radius;
    header.rate_hz = bad;
    EXPECT_THAT(complaint(recording_bytes(folder / "x", header, none)), HasSubstr("rate_hz"));
    header.rate_hz = 1000;
  }
}

TEST_F(RecordingFile, a_name_that_is_no_utf_8_is_kept_as_it_can_be_typed) {
  RecordingHeader header = header_of(scene, made_up_radius);
  header.scene.name = "p\xe4g";
  const std::vector<Snapshot> ticks = made_up_ticks(2);
  EXPECT_EQ(complaint(header_bytes(header, folder / "x") + tick_block(ticks) + end_block(2)), "");
  EXPECT_EQ(read->header.scene.name, "p\\xe4g");
}

TEST_F(RecordingFile, times_that_fall_or_are_none_end_it_at_their_block) {
  const auto with_times = [&](double first, double second) {
    std::vector<Snapshot> ticks = made_up_ticks(2);
    ticks[0].time = first;
    ticks[1].time = second;
    const RecordingHeader header = header_of(scene, made_up_radius);
    const std::string start = header_bytes(header, folder / "x");
    EXPECT_EQ(complaint(start + tick_block(ticks) + end_block(2)), "");
    EXPECT_EQ(read->ticks.end(), 0u);
    EXPECT_EQ(read->readable, start.size());
    EXPECT_THAT(read->cut, HasSubstr("the times of a block are not finite, or fall"));
  };
  with_times(1, 0.5);
  with_times(0, std::nan(""));
  with_times(-std::numeric_limits<double>::infinity(), 0);
}

TEST_F(RecordingFile, a_block_that_goes_back_in_time_ends_it) {
  const std::vector<Snapshot> ticks = made_up_ticks(4);
  const std::string start = header_bytes(header_of(scene, made_up_radius), folder / "x");
  const std::span<const Snapshot> all(ticks);
  EXPECT_EQ(complaint(start + tick_block(all.last(2)) + tick_block(all.first(2))), "");
  EXPECT_EQ(read->ticks.end(), 2u);
  EXPECT_THAT(read->cut, HasSubstr("begins before the one ahead of it ends"));
}

TEST_F(RecordingFile, times_that_fall_within_a_block_name_file_and_byte) {
  std::vector<Snapshot> ticks = made_up_ticks(3);
  ticks[1].time = std::nan("");
  const std::string start = header_bytes(header_of(scene, made_up_radius), folder / "x");
  EXPECT_EQ(complaint(start + tick_block(ticks) + end_block(3)), "");
  try {
    read->ticks.at(0);
    FAIL() << "nothing was thrown";
  } catch (const InputError& bad) {
    EXPECT_THAT(bad.what(), HasSubstr("damaged.sonderec: byte " + std::to_string(start.size()) +
                                      ": the times of a block fall"));
  }
}

TEST_F(RecordingFile, of_other_meshes_it_names_the_mesh_and_both_files) {
  const auto file = recording("whole.sonderec", made_up_ticks(3));
  const auto complaint_of_meshes = [&]() -> std::string {
    try {
      check_meshes(read_recording(file)->header, file);
      return {};
    } catch (const InputError& bad) {
      return bad.what();
    }
  };
  EXPECT_EQ(complaint_of_meshes(), "");
  std::string mesh = text_of(folder / "probe.off");
  mesh[mesh.find("1 0 0")] = '2';
  folder.write("probe.off", mesh);
  EXPECT_THAT(complaint_of_meshes(), StartsWith(file.string() + ": byte 20: "));
  EXPECT_THAT(complaint_of_meshes(), HasSubstr("probe.off is another mesh than was recorded"));
  folder.write("probe.off", mesh + "\n");
  EXPECT_THAT(complaint_of_meshes(), HasSubstr("bytes instead of"));
  std::filesystem::remove(folder / "probe.off");
  EXPECT_THAT(complaint_of_meshes(), HasSubstr("probe.off: No such file"));
}

TEST_F(RecordingFile, what_it_holds_stays_readable_when_its_name_goes) {
  const std::vector<Snapshot> ticks = made_up_ticks(3000);
  const auto r = read_recording(recording("gone.sonderec", ticks));
  std::filesystem::remove(folder / "gone.sonderec");
  EXPECT_EQ(r->ticks.at(2999).time, ticks[2999].time);
}

}  // namespace
}  // namespace sonde::test
