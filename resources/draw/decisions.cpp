// SPDX-License-Identifier: GPL-3.0-or-later
// sonde-decisions FOLDER SHEET.png CHART.svg: what the meshes of a folder are taken for. The sheet
// shows each that has an open edge or was mended, with the words of the decision; the chart, how
// wide the widest openings are.
#include <vtkActor.h>
#include <vtkAutoInit.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/study/charts/svg_chart.hpp"
#include "ui/views/surface.hpp"

VTK_MODULE_INIT(vtkRenderingOpenGL2)  // without it nothing draws

namespace {

using namespace sonde;

constexpr int side = 110, caption = 40, columns = 10;  // px
constexpr int oversampled = 2;

struct Decided {
  std::string name;
  std::shared_ptr<const Body> body;
  bool in_part() const { return body->solid && body->repairs.solid_parts < body->repairs.parts; }
  /// Of the parts that are solids, and of the others.
  double closed() const { return body->solid ? body->repairs.widest_cap : 0; }
  double open() const { return body->repairs.widest_mouth; }
};

std::vector<Decided> decide(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<Decided> out;
  for (const auto& file : files) try {
      Decided one{file.stem().string(), load_body(file.string(), Model::automatic)};
      if (one.body->repairs.any() || !one.body->solid) out.push_back(std::move(one));
    } catch (const InputError&) {
      continue;  // no mesh
    }
  return out;
}

class Studio {
 public:
  Studio() {
    window_->SetOffScreenRendering(true);
    window_->SetMultiSamples(0);
    window_->SetSize(side * oversampled, side * oversampled);
    window_->AddRenderer(renderer_);
    renderer_->SetBackground(1, 1, 1);
  }

  QImage draw(const Body& body) {
    renderer_->RemoveAllViewProps();
    add(body.soup, body.solid ? QColor(140, 165, 200) : QColor(222, 170, 90), 0);
    if (!body.caps.triangles.empty()) add(body.caps, QColor(200, 60, 120), -4);
    vtkCamera& camera = *renderer_->GetActiveCamera();
    camera.SetFocalPoint(0, 0, 0);
    camera.SetPosition(0.7, 0.55, 1);
    camera.SetViewUp(0, 1, 0);
    renderer_->ResetCamera();
    camera.Zoom(1.35);
    window_->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    const int most = side * oversampled - 1;
    window_->GetPixelData(0, 0, most, most, false, pixels);
    const QImage image(pixels->GetPointer(0), most + 1, most + 1, 3 * (most + 1),
                       QImage::Format_RGB888);
    return image.mirrored().scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  }

 private:
  void add(const Soup& soup, const QColor& colour, double nearer) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(ui::make_surface(soup));
    mapper->ScalarVisibilityOff();
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, nearer);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
    vtkNew<vtkProperty> behind;
    behind->SetColor(0.35 * colour.redF(), 0.35 * colour.greenF(), 0.35 * colour.blueF());
    actor->SetBackfaceProperty(behind);
    renderer_->AddActor(actor);
  }

  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
};

std::string words_of(const Decided& one) {
  const std::string what =
      one.in_part() ? "solid in part" : (one.body->solid ? "solid" : "surface");
  const double mouth = one.body->solid ? one.closed() : one.open();
  if (mouth == 0) return what;
  char text[64];
  std::snprintf(text, sizeof text, ", %.3g %%", 100 * mouth);
  return what + text;
}

void draw_sheet(const std::vector<Decided>& all, const QString& file) {
  const int rows = (static_cast<int>(all.size()) + columns - 1) / columns;
  QImage sheet(columns * side, rows * (side + caption), QImage::Format_RGB888);
  sheet.fill(Qt::white);
  QPainter painter(&sheet);
  Studio studio;
  for (int k = 0; k < static_cast<int>(all.size()); ++k) {
    const Decided& one = all[static_cast<std::size_t>(k)];
    const QPoint at(k % columns * side, k / columns * (side + caption));
    painter.drawImage(at, studio.draw(*one.body));
    QFont font = painter.font();
    font.setPixelSize(10);
    painter.setFont(font);
    const QString name = painter.fontMetrics().elidedText(QString::fromStdString(one.name),
                                                          Qt::ElideMiddle, side - 6);
    painter.drawText(QRect(at + QPoint(0, side), QSize(side, 14)), Qt::AlignCenter, name);
    painter.drawText(QRect(at + QPoint(0, side + 14), QSize(side, 14)), Qt::AlignCenter,
                     QString::fromStdString(words_of(one)));
  }
  painter.end();
  if (!sheet.convertToFormat(QImage::Format_Indexed8).save(file))
    throw std::runtime_error("cannot be written: " + file.toStdString());
}

/// Bars of a tenth of a decade, from 0.1 % to 100 %; solids below, surfaces on top of them.
void draw_chart(const std::vector<Decided>& all, const std::string& file) {
  constexpr double step = 0.1;
  std::map<int, std::pair<int, int>> bars;
  const auto bar_of = [](double mouth) {
    return static_cast<int>(std::floor(std::log10(std::max(100 * mouth, 0.1001)) / step));
  };
  for (const Decided& one : all) {
    if (one.closed() > 0) ++bars[bar_of(one.closed())].first;
    if (one.open() > 0) ++bars[bar_of(one.open())].second;
  }
  ChartPanel panel;
  panel.x = {"widest opening, % of what is seen from all around", true, 0.1, 100};
  panel.y = {"meshes", false, 0};
  panel.kinds = {{"taken as a solid", "#8ca5c8"}, {"taken as a surface", "#deaa5a"}};
  double most = 0;
  for (const auto& [bar, both] : bars) {
    const double from = std::pow(10, step * bar), to = std::pow(10, step * (bar + 1));
    const double solids = both.first, all_of_both = both.first + both.second;
    if (solids > 0) panel.cells.push_back({from, to, 0, solids, 0});
    if (all_of_both > solids) panel.cells.push_back({from, to, solids, all_of_both, 1});
    most = std::max(most, all_of_both);
  }
  panel.y.to = most + 1;
  panel.series = {{"threshold, 2.5 %", {2.5, 2.5}, {0, most + 1}, ChartSeries::Form::dashed}};
  std::ofstream(file) << to_svg(SvgChart{"Openings of foreign meshes", {panel}});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4 || argv[1][0] == '-') {
    std::fprintf(stderr, "usage: sonde-decisions FOLDER SHEET.png CHART.svg\n");
    return 2;
  }
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  try {
    const std::vector<Decided> all = decide(argv[1]);
    draw_sheet(all, QString::fromLocal8Bit(argv[2]));
    draw_chart(all, argv[3]);
  } catch (const std::exception& why) {
    std::fprintf(stderr, "sonde-decisions: %s\n", why.what());
    return 1;
  }
}
