// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/recording_header.hpp"

#include <zlib.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/platform/read_stream.hpp"
#include "engine/recording/recorded_tick.hpp"
#include "engine/scene/write_scene.hpp"
#include "engine/settings/json_settings.hpp"
#include "engine/text/printable.hpp"

namespace sonde {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::string_view magic = "SONDEREC";
constexpr std::size_t head_size = 20;  ///< magic, version, length, CRC-32

std::uint32_t crc_of(std::string_view text) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size()));
}

std::string now_text() {
  using namespace std::chrono;
  const auto now = floor<seconds>(system_clock::now());
  const year_month_day day(floor<days>(now));
  const hh_mm_ss time(now - floor<days>(now));
  std::array<char, 64> text{};
  const int size = std::snprintf(
      text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02dZ", static_cast<int>(day.year()),
      static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()),
      static_cast<int>(time.hours().count()), static_cast<int>(time.minutes().count()),
      static_cast<int>(time.seconds().count()));
  return {text.data(), static_cast<std::size_t>(size)};
}

ordered_json json_of(const FileMark& mark) { return {{"bytes", mark.bytes}, {"crc32", mark.crc}}; }

template <class Row>
ordered_json json_of(std::span<const Column<Row>> columns) {
  ordered_json all = ordered_json::array();
  for (const Column<Row>& column : columns)
    all.push_back({{"name", column.name}, {"unit", column.unit}, {"as", name_of(column.as)}});
  return all;
}

/// A member that an object of the header must have.
const JsonNode& member(const fs::path& file, const JsonNode& object, std::string_view key,
                       JsonNode::Kind kind) {
  const JsonNode& node = need_key(file, object, key, "the header");
  expect_kind(file, node, kind);
  return node;
}

double number(const fs::path& file, const JsonNode& object, std::string_view key) {
  return member(file, object, key, JsonNode::Kind::number).number;
}

double positive(const fs::path& file, const JsonNode& object, std::string_view key) {
  const double value = number(file, object, key);
  if (!(value > 0 && std::isfinite(value)))
    fail_at(file, need_key(file, object, key, "the header").line,
            "\"" + std::string(key) + "\" must be above 0 and finite");
  return value;
}

FileMark mark_in(const fs::path& file, const JsonNode& node) {
  constexpr double most_bytes = 1e15, most_crc = 4294967295.0;
  const double bytes = number(file, node, "bytes"), crc = number(file, node, "crc32");
  if (!(bytes >= 0 && bytes <= most_bytes && crc >= 0 && crc <= most_crc))
    fail_at(file, node.line, "no mark of a file");
  return {static_cast<std::uint64_t>(bytes), static_cast<std::uint32_t>(crc)};
}

RecordingHeader header_in(const std::string& text, const fs::path& file) {
  const JsonNode root = parse_json(file.string(), text);
  expect_kind(file, root, JsonNode::Kind::object);
  RecordingHeader header;
  header.scene = scene_in(member(file, root, "scene", JsonNode::Kind::string).text, file);
  header.scene.file.clear();  // it has no file of its own
  header.scene.name = member(file, root, "name", JsonNode::Kind::string).text;
  const JsonNode& meshes = member(file, root, "meshes", JsonNode::Kind::object);
  header.meshes.probe = mark_in(file, member(file, meshes, "probe", JsonNode::Kind::object));
  header.meshes.fixed = mark_in(file, member(file, meshes, "fixed", JsonNode::Kind::object));
  header.probe_radius = positive(file, root, "probe_radius");
  header.rate_hz = positive(file, root, "rate_hz");
  for (const JsonNode& node : root.children)
    if (node.key == "along_path") {
      expect_kind(file, node, JsonNode::Kind::boolean);
      header.along_path = node.boolean;
    }
  header.started = member(file, root, "started", JsonNode::Kind::string).text;
  return header;
}

/// Why a body's meshes differ from the recorded ones; empty if they do not.
std::string other(const SceneBody& body, const FileMark& recorded) {
  FileMark now;
  try {
    now = mark_of(body);
  } catch (const InputError& bad) {
    return bad.what();
  }
  if (now == recorded) return {};
  const bool several = body.parts.size() > 1;
  std::string reason = body.mesh.string();
  reason += several ? " and the parts beside it are not the meshes that were recorded: "
                    : " is another mesh than was recorded: ";
  if (now.bytes == recorded.bytes)
    return reason + (several ? "the content differs" : "its content differs");
  return reason + std::to_string(now.bytes) + " bytes instead of " + std::to_string(recorded.bytes);
}

}  // namespace

namespace {

/// The mark of everything marked so far followed by that file.
FileMark continued(FileMark mark, const fs::path& file) {
  const ReadStream stream = open_to_read(file);
  std::array<char, 65536> piece{};
  while (stream) {
    const std::size_t size = std::fread(piece.data(), 1, piece.size(), stream.get());
    if (size == 0) break;
    mark.bytes += size;
    mark.crc = static_cast<std::uint32_t>(
        crc32_z(mark.crc, reinterpret_cast<const Bytef*>(piece.data()), size));
  }
  if (!stream || std::ferror(stream.get()) != 0)
    throw InputError::in(file.string(), std::generic_category().message(errno));
  return mark;
}

}  // namespace

FileMark mark_of(const fs::path& file) { return continued({}, file); }

FileMark mark_of(const SceneBody& body) {
  FileMark mark;
  std::set<fs::path> taken_apart;  // a file of many components counts once, listed or not
  for (const SceneBody& part : meshes_of(body)) {
    const bool is_component = part.component != 0 || part.components;
    if (is_component && !taken_apart.insert(part.mesh).second) continue;
    mark = continued(mark, part.mesh);
  }
  return mark;
}

MeshMarks marks_of(const Scene& scene) { return {mark_of(scene.probe), mark_of(scene.fixed)}; }

RecordingHeader header_of(const Scene& scene, double probe_radius) {
  return header_of(scene, marks_of(scene), probe_radius);
}

RecordingHeader header_of(const Scene& scene, const MeshMarks& meshes, double probe_radius) {
  return {.scene = scene,
          .meshes = meshes,
          .probe_radius = probe_radius,
          .rate_hz = scene.servo.rate_hz,
          .started = now_text()};
}

std::string header_bytes(const RecordingHeader& header, const fs::path& file) {
  const ordered_json json{
      {"format", "sonde recording"},
      {"units", "SI; poses and contacts in the mesh frame of the fixed body"},
      {"name", utf8_text(header.scene.name)},  // a file's name may be no UTF-8
      {"started", header.started},
      {"rate_hz", header.rate_hz},
      {"probe_radius", header.probe_radius},
      {"along_path", header.along_path},
      {"meshes",
       {{"probe", json_of(header.meshes.probe)}, {"fixed", json_of(header.meshes.fixed)}}},
      {"scene", scene_text(header.scene, fs::absolute(file).parent_path())},
      {"ticks", json_of(tick_columns())},
      {"contacts", json_of(contact_columns())},
      {"searches", json_of(search_columns())}};
  const std::string text = json.dump(1);
  std::string out(magic);
  append_count(out, recording_version);
  append_count(out, static_cast<std::uint32_t>(text.size()));
  append_count(out, crc_of(text));
  return out + text;
}

namespace {

/// The JSON text of the header at the beginning of a file, with a verified checksum.
std::string header_text(std::string_view bytes, const fs::path& file) {
  const auto fail = [&](std::size_t byte, const std::string& reason) {
    return InputError::at_byte(file.string(), byte, reason);
  };
  if (bytes.substr(0, magic.size()) != magic) throw fail(0, "no recording begins here");
  if (bytes.size() < head_size) throw fail(bytes.size(), "the recording is cut within its header");
  std::string_view rest = bytes.substr(magic.size());
  const std::uint32_t version = take_count(rest);
  if (version != recording_version)
    throw fail(magic.size(), "a recording of version " + std::to_string(version) +
                                 "; this program reads version " +
                                 std::to_string(recording_version));
  const std::size_t size = take_count(rest);
  const std::uint32_t crc = take_count(rest);
  if (rest.size() < size) throw fail(bytes.size(), "the recording is cut within its header");
  std::string text(rest.substr(0, size));
  if (crc_of(text) != crc) throw fail(head_size, "the checksum of the header is wrong");
  return text;
}

}  // namespace

ReadHeader read_header(std::string_view bytes, const fs::path& file) {
  const std::string text = header_text(bytes, file);
  return {header_in(text, file), head_size + text.size()};
}

std::string recorded_scene_text(std::string_view bytes, const fs::path& file) {
  const JsonNode root = parse_json(file.string(), header_text(bytes, file));
  expect_kind(file, root, JsonNode::Kind::object);
  return member(file, root, "scene", JsonNode::Kind::string).text;
}

bool is_recording(const fs::path& file) {
  // Opening a pipe would wait for its writer, and take data from the next reader.
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  const ReadStream stream = open_to_read(file);
  std::array<char, magic.size()> first{};
  return stream && std::fread(first.data(), 1, first.size(), stream.get()) == first.size() &&
         std::string_view(first.data(), first.size()) == magic;
}

void check_meshes(const RecordingHeader& header, const fs::path& recording) {
  for (const auto& [body, mark] : {std::pair(header.scene.probe, header.meshes.probe),
                                   std::pair(header.scene.fixed, header.meshes.fixed)})
    if (const std::string reason = other(body, mark); !reason.empty())
      throw InputError::at_byte(recording.string(), head_size, reason);
}

}  // namespace sonde
