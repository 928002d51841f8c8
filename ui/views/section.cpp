// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/section.hpp"

#include <vtkCellArray.h>
#include <vtkContourTriangulator.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace sonde::ui {
namespace {

/// The points in which edges are cut, each once, so that lines meet in them.
class CutPoints {
 public:
  CutPoints(const Soup& soup, const std::vector<double>& heights, vtkPoints& points)
      : soup_(soup), heights_(heights), points_(points) {}

  vtkIdType on_edge(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [known, is_new] =
        ids_.try_emplace(std::uint64_t{low} << 32 | high, points_.GetNumberOfPoints());
    if (is_new) {
      const double part = heights_[low] / (heights_[low] - heights_[high]);
      const Vec3 x = soup_.vertices[low] + part * (soup_.vertices[high] - soup_.vertices[low]);
      points_.InsertNextPoint(x.data());
    }
    return known->second;
  }

 private:
  const Soup& soup_;
  const std::vector<double>& heights_;
  vtkPoints& points_;
  std::unordered_map<std::uint64_t, vtkIdType> ids_;
};

}  // namespace

SectionFace section_of(const Soup& soup, const Vec3& point, const Vec3& normal) {
  std::vector<double> heights(soup.vertices.size());
  std::ranges::transform(soup.vertices, heights.begin(),
                         [&](const Vec3& x) { return (x - point).dot(normal); });
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  CutPoints cut(soup, heights, *points);
  for (const Triangle& t : soup.triangles) {
    // A corner in the plane counts as above it: so each closed surface is cut in closed lines.
    const std::array<bool, 3> below{heights[t[0]] < 0, heights[t[1]] < 0, heights[t[2]] < 0};
    if (below[0] == below[1] && below[1] == below[2]) continue;
    std::array<vtkIdType, 2> ends{};  // from where the triangle goes up to where it goes down
    for (std::size_t k = 0; k < 3; ++k)
      if (const std::size_t n = (k + 1) % 3; below.at(k) != below.at(n))
        ends.at(below.at(k) ? 0 : 1) = cut.on_edge(t[k], t[n]);
    lines->InsertNextCell({ends[0], ends[1]});
  }
  SectionFace out{vtkSmartPointer<vtkPolyData>::New(), vtkSmartPointer<vtkPolyData>::New()};
  out.outline->SetPoints(points);
  out.outline->SetLines(lines);
  if (lines->GetNumberOfCells() == 0) return out;
  vtkNew<vtkContourTriangulator> fill;
  fill->SetInputData(out.outline);
  fill->Update();
  out.filled->ShallowCopy(fill->GetOutput());
  out.filled->SetLines(nullptr);
  return out;
}

}  // namespace sonde::ui
