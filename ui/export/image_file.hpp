// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <filesystem>

namespace sonde::ui {

/// Writes a picture as PNG, whole or not at all. Throws InputError.
void write_image(const std::filesystem::path& file, const QImage& image);

/// The program that makes a film of pictures on this system; empty where there is none.
QString film_maker();

}  // namespace sonde::ui
