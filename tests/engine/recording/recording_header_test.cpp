// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/recording_header.hpp"

#include <gmock/gmock.h>

#include <regex>
#include <string>

#include "engine/base/error.hpp"
#include "tests/engine/recording/made_up_ticks.hpp"

namespace sonde::test {
namespace {

using testing::HasSubstr;

class RecordingHead : public RecordingTest {
 protected:
  std::string bytes_of(const RecordingHeader& header) const {
    return header_bytes(header, folder / "made-up.sonderec");
  }
  std::string refusal(const std::string& bytes) const {
    try {
      read_header(bytes, folder / "made-up.sonderec");
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
};

// Reference: the check value of CRC-32 (ISO-HDLC) in the catalogue of parametrised CRCs.
TEST_F(RecordingHead, a_file_is_marked_by_its_size_and_crc_32) {
  EXPECT_EQ(mark_of(folder.write("check", "123456789")), (FileMark{9, 0xCBF43926}));
  EXPECT_EQ(mark_of(folder.write("empty", "")), (FileMark{0, 0}));
  // Longer than one piece of reading.
  const std::string half(40'000, 'x'), other(40'000, 'y');
  EXPECT_NE(mark_of(folder.write("a", half + other)), mark_of(folder.write("b", other + half)));
  EXPECT_NE(mark_of(folder / "a"), mark_of(folder.write("c", other + other)));
  EXPECT_EQ(mark_of(folder / "a").bytes, 80'000u);
  EXPECT_THROW(mark_of(folder / "missing"), InputError);
  const MeshMarks marks = marks_of(scene);
  EXPECT_EQ(marks.probe, mark_of(folder / "probe.off"));
  EXPECT_EQ(marks.fixed, mark_of(folder / "fixed.off"));
}

TEST_F(RecordingHead, what_was_written_is_read) {
  RecordingHeader header = header_of(scene, 0.125);
  EXPECT_TRUE(
      std::regex_match(header.started, std::regex("20\\d\\d-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ")));
  EXPECT_EQ(header.rate_hz, scene.servo.rate_hz);
  EXPECT_FALSE(header.along_path);
  header.along_path = true;
  header.started = "2001-02-03T04:05:06Z";
  header.rate_hz = 750.5;
  const std::string bytes = bytes_of(header);
  const ReadHeader read = read_header(bytes + "more", folder / "made-up.sonderec");
  EXPECT_EQ(read.size, bytes.size());
  EXPECT_EQ(read.header.started, header.started);
  EXPECT_EQ(read.header.rate_hz, 750.5);
  EXPECT_EQ(read.header.probe_radius, 0.125);
  EXPECT_TRUE(read.header.along_path);
  EXPECT_EQ(read.header.scene.name, scene.name);
  EXPECT_EQ(read.header.meshes.probe, header.meshes.probe);
  EXPECT_EQ(read.header.meshes.fixed, header.meshes.fixed);
  EXPECT_NE(read.header.meshes.probe, read.header.meshes.fixed);
  EXPECT_TRUE(std::filesystem::equivalent(read.header.scene.probe.mesh, folder / "probe.off"));
  EXPECT_EQ(read.header.scene.fixed.scale, 2);
  const std::string text = recorded_scene_text(bytes, folder / "made-up.sonderec");
  EXPECT_THAT(text, HasSubstr("\"probe.off\""));  // beside the recording
  EXPECT_THAT(text, testing::Not(HasSubstr(folder.path().string())));
}

// Reference: the layout that recording_header.hpp states, little-endian as all counts.
TEST_F(RecordingHead, begins_with_the_magic_word_the_version_the_size_and_the_checksum) {
  const std::string bytes = bytes_of(header_of(scene, 0.125));
  ASSERT_GT(bytes.size(), 20u);
  EXPECT_EQ(bytes.substr(0, 8), "SONDEREC");
  const auto count_at = [&](std::size_t at) {
    std::uint32_t out = 0;
    for (std::size_t i = 4; i-- > 0;) out = 256 * out + static_cast<unsigned char>(bytes[at + i]);
    return out;
  };
  EXPECT_EQ(count_at(8), recording_version);
  EXPECT_EQ(count_at(12), bytes.size() - 20);
  EXPECT_EQ(count_at(16), mark_of(folder.write("json", bytes.substr(20))).crc);
  EXPECT_EQ(bytes[20], '{');
}

TEST_F(RecordingHead, what_is_cut_damaged_or_newer_is_refused_by_its_byte) {
  const std::string bytes = bytes_of(header_of(scene, 0.125));
  EXPECT_EQ(refusal(bytes), "accepted");
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}})
    EXPECT_THAT(refusal(bytes.substr(0, size)), HasSubstr("no recording begins here"));
  for (const std::size_t size : {std::size_t{8}, std::size_t{19}, bytes.size() - 1})
    EXPECT_THAT(refusal(bytes.substr(0, size)), HasSubstr("cut within its header")) << size;
  std::string newer = bytes, damaged = bytes;
  newer[8] = 2;
  EXPECT_THAT(refusal(newer), HasSubstr("a recording of version 2"));
  damaged.back() ^= 1;
  EXPECT_THAT(refusal(damaged), HasSubstr("the checksum of the header is wrong"));
}

TEST_F(RecordingHead, a_recording_is_known_by_its_first_bytes) {
  const std::string bytes = bytes_of(header_of(scene, 0.125));
  EXPECT_TRUE(is_recording(folder.write("a", bytes)));
  EXPECT_TRUE(is_recording(folder.write("b", bytes.substr(0, 8))));
  EXPECT_FALSE(is_recording(folder.write("c", bytes.substr(0, 7))));
  EXPECT_FALSE(is_recording(folder.write("d", "x" + bytes)));
  EXPECT_FALSE(is_recording(folder / "missing"));
  EXPECT_FALSE(is_recording(folder.path()));
}

TEST_F(RecordingHead, other_meshes_than_the_recorded_ones_are_named) {
  const RecordingHeader header = header_of(scene, 0.125);
  const auto check = [&]() -> std::string {
    try {
      check_meshes(header, folder / "made-up.sonderec");
    } catch (const InputError& error) {
      return error.what();
    }
    return "the same";
  };
  EXPECT_EQ(check(), "the same");
  const std::string text = text_of(folder / "fixed.off");
  std::string changed = text;
  changed.back() = ' ';
  folder.write("fixed.off", changed);
  EXPECT_THAT(check(), testing::AllOf(HasSubstr("made-up.sonderec"), HasSubstr("fixed.off"),
                                      HasSubstr("its content differs")));
  folder.write("fixed.off", text + "\n");
  EXPECT_THAT(check(), HasSubstr(std::to_string(text.size() + 1) + " bytes instead of " +
                                 std::to_string(text.size())));
  std::filesystem::remove(folder / "fixed.off");
  EXPECT_THAT(check(), HasSubstr("fixed.off"));
  folder.write("fixed.off", text);
  folder.write("probe.off", "");
  EXPECT_THAT(check(), HasSubstr("probe.off"));
}

}  // namespace
}  // namespace sonde::test
