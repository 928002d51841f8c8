// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/scene/scene.hpp"

namespace sonde {

/// Identifies a mesh file.
struct FileMark {
  std::uint64_t bytes = 0;
  std::uint32_t crc = 0;  ///< CRC-32 of all of it
  bool operator==(const FileMark&) const = default;
};
/// Reads all of the file. Throws InputError.
FileMark mark_of(const std::filesystem::path& file);
/// The mark of a body's mesh, or of the meshes of all its parts in sequence.
FileMark mark_of(const SceneBody& body);

/// Identifies the meshes of a scene, as they were when they were read.
struct MeshMarks {
  FileMark probe, fixed;
};
MeshMarks marks_of(const Scene& scene);

/// The facts of a recording before its first tick.
struct RecordingHeader {
  Scene scene;  ///< at its beginning; paths as in a scene file beside the recording
  MeshMarks meshes;
  double probe_radius = 0;  ///< m, from which follows which contacts form a cluster
  double rate_hz = 0;       ///< requested from the servo
  std::string started;      ///< UTC, ISO 8601
  bool along_path = false;  ///< TickLog::along_path
};

/// The header of a recording that begins now, for meshes that were read before.
RecordingHeader header_of(const Scene& scene, const MeshMarks& meshes, double probe_radius);
/// The same for meshes that are read now.
RecordingHeader header_of(const Scene& scene, double probe_radius);

constexpr std::uint32_t recording_version = 1;

/// The first bytes of a file in that folder: "SONDEREC", the version, the number of bytes that
/// follow and their CRC-32, each of 4 bytes, and JSON that names every column with its unit. Throws
/// InputError if the scene cannot be written as text.
std::string header_bytes(const RecordingHeader& header, const std::filesystem::path& file);

/// The header at the beginning of a file, and its size in bytes. Throws InputError naming the file,
/// the byte and the reason: not a recording, a newer version, truncated, or damaged.
struct ReadHeader {
  RecordingHeader header;
  std::size_t size = 0;
};
ReadHeader read_header(std::string_view bytes, const std::filesystem::path& file);

/// The scene of the header as text; none of its paths has been followed. Throws as read_header
/// does.
std::string recorded_scene_text(std::string_view bytes, const std::filesystem::path& file);

/// Whether the file begins as a recording does; false if it cannot be read.
bool is_recording(const std::filesystem::path& file);

/// Throws InputError, naming the recording and the mesh, if a mesh of the scene is missing or
/// differs from the recorded one.
void check_meshes(const RecordingHeader& header, const std::filesystem::path& recording);

}  // namespace sonde
