// SPDX-License-Identifier: GPL-3.0-or-later
// sonde-gallery FOLDER: draws the picture of each scene in the folder, NAME.png beside
// NAME.sonde.json, for the start page: the probe half way along its path.

#include <vtkPolyData.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <clocale>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "ui/views/stage.hpp"
#include "ui/views/viewport.hpp"

namespace {

using namespace sonde;
using namespace sonde::ui;

constexpr int width = 300, height = 200, oversampled = 4;  // edges come out smooth

void settle(int ms) {
  QElapsedTimer clock;
  clock.start();
  while (clock.elapsed() < ms) QApplication::processEvents(QEventLoop::AllEvents, 10);
}

/// The part that shows something, with a margin, in the shape of the picture. Above everything on
/// the left edge there is background alone.
QRect lit_part(const QImage& image) {
  QRect lit;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (image.pixel(x, y) != image.pixel(0, y)) lit |= QRect(x, y, 1, 1);
  QSize size = lit.size() * 1.15;
  size = QSize(width, height).scaled(size, Qt::KeepAspectRatioByExpanding);
  QRect part(QPoint(), size);
  part.moveCenter(lit.center());
  return part;
}

bool draw(Viewport& view, const std::filesystem::path& file) {
  Opened opened = open_scene(file);
  if (!opened.trajectory.empty())
    opened.here = opened.trajectory[opened.trajectory.size() / 2].pose;
  const Stage stage = make_stage(std::move(opened));
  view.show_stage(stage);
  settle(300);
  const Snapshot* snapshot = stage.session->latest();
  if (!snapshot) return false;
  view.draw(*snapshot, 1);
  view.fit();
  view.draw(*snapshot, 1);
  const QImage whole = view.picture();
  const QRect part = lit_part(whole) & whole.rect();
  const QImage picture =
      whole.copy(part).scaled(width, height, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  std::string name = file.filename().string();
  name.resize(name.size() - std::string(".sonde.json").size());
  return picture.save(QString::fromStdString((file.parent_path() / (name + ".png")).string()));
}

int draw_all(const std::filesystem::path& folder) {
  Viewport view;
  view.resize(width * oversampled, height * oversampled);
  for (const Layer layer : {Layer::screw, Layer::contacts, Layer::wrench, Layer::hint})
    view.set_shown(layer, false);
  view.show();
  settle(300);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.path().string().ends_with(".sonde.json") || draw(view, entry.path())) continue;
    std::fprintf(stderr, "sonde-gallery: %s: nothing was drawn\n", entry.path().c_str());
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: sonde-gallery FOLDER\n");
    return 2;
  }
  QSurfaceFormat::setDefaultFormat(Viewport::surface_format());
  const QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  try {
    return draw_all(argv[1]);
  } catch (const std::exception& why) {
    std::fprintf(stderr, "sonde-gallery: %s\n", why.what());
    return 1;
  }
}
