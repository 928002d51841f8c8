// SPDX-License-Identifier: GPL-3.0-or-later
// sonde-gallery FOLDER: draws the picture of each scene in the folder, NAME.png beside
// NAME.sonde.json, for the start page: the probe where its path leads deepest inside.

#include <vtkPolyData.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <algorithm>
#include <clocale>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "ui/base/theme.hpp"
#include "ui/document/instant.hpp"
#include "ui/views/drawn_session.hpp"
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

/// Leads the probe along its path, to where the centres of mass are closest together.
void lead_inside(Session& session, const std::vector<TimedPose>& path) {
  const Vec3 probe = session.probe().mass.com, fixed = session.fixed().mass.com;
  const auto distance = [&](const TimedPose& at) { return (at.pose * probe - fixed).norm(); };
  const auto innermost = std::ranges::min_element(path, {}, distance);
  constexpr std::ptrdiff_t step = 5;
  for (auto at = path.begin(); at < innermost; at += std::min(step, innermost - at)) {
    session.set_device_pose(at->pose);
    settle(2);
  }
}

bool draw(Viewport& view, const std::filesystem::path& file) {
  const LoadedScene loaded = open_scene(file);
  const DrawnSession drawn = draw_session(loaded);
  view.show_bodies(drawn.bodies);
  lead_inside(*drawn.session, loaded.trajectory);
  settle(300);
  const Snapshot* snapshot = drawn.session->latest();
  if (!snapshot) return false;
  const Instant now{*snapshot, {}};
  view.draw(now, 1);
  view.fit();
  view.draw(now, 1);
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
  if (argc != 2 || argv[1][0] == '-') {
    std::fprintf(stderr, "usage: sonde-gallery FOLDER\n");
    return 2;
  }
  QSurfaceFormat::setDefaultFormat(Viewport::surface_format());
  QApplication application(argc, argv);
  apply_theme(application, Theme::dark);
  std::setlocale(LC_NUMERIC, "C");
  try {
    return draw_all(argv[1]);
  } catch (const std::exception& why) {
    std::fprintf(stderr, "sonde-gallery: %s\n", why.what());
    return 1;
  }
}
