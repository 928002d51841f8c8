// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <filesystem>

#include "engine/base/error.hpp"

namespace sonde::ui {

/// Writes an image to a PNG file, whole or not at all. Throws InputError if that fails,
/// and Cancelled, before anything is written, if `progress` returned false. For any thread.
void write_image(const std::filesystem::path& file, const QImage& image,
                 const Progress& progress = {});

/// The path of ffmpeg, which makes a film of a folder of pictures. Empty if it is not installed.
QString find_ffmpeg();

}  // namespace sonde::ui
