// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/image_file.hpp"

#include <QBuffer>
#include <QStandardPaths>
#include <string_view>

#include "engine/base/error.hpp"
#include "engine/text/output_file.hpp"

namespace sonde::ui {

void write_image(const std::filesystem::path& file, const QImage& image, const Progress& progress) {
  if (image.isNull()) throw InputError::in(file.string(), "there is no picture of that size");
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!image.save(&buffer, "PNG")) throw InputError::in(file.string(), "no memory for the picture");
  if (progress && !progress(1)) throw Cancelled();
  write_whole(file, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

QString find_ffmpeg() { return QStandardPaths::findExecutable(QStringLiteral("ffmpeg")); }

}  // namespace sonde::ui
