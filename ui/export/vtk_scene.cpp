// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/vtk_scene.hpp"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

#include <QByteArray>
#include <QXmlStreamWriter>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/base/error.hpp"
#include "engine/base/progress.hpp"
#include "engine/penetration/contact/contact_clusters.hpp"
#include "engine/text/output_file.hpp"
#include "ui/export/new_folder.hpp"

namespace sonde::ui {
namespace {

namespace fs = std::filesystem;

vtkSmartPointer<vtkDoubleArray> array(const char* name, int components) {
  auto made = vtkSmartPointer<vtkDoubleArray>::New();
  made->SetName(name);
  made->SetNumberOfComponents(components);
  return made;
}

void add_number(vtkPolyData& data, const char* name, double value) {
  const auto one = array(name, 1);
  one->InsertNextValue(value);
  data.GetFieldData()->AddArray(one);
}

void write(const fs::path& file, vtkPolyData& data) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(&data);
  if (writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError) return;
  throw InputError::in(file.string(),
                       std::string("cannot be written: ") +
                           vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
}

struct Block {
  const char* name;
  std::string file;
};

/// A multiblock file of pieces that are written apart, so that several may share one.
std::string multiblock(std::span<const Block> blocks) {
  QByteArray text;
  QXmlStreamWriter xml(&text);
  xml.setAutoFormatting(true);
  xml.writeStartDocument();
  xml.writeStartElement(QStringLiteral("VTKFile"));
  xml.writeAttribute(QStringLiteral("type"), QStringLiteral("vtkMultiBlockDataSet"));
  xml.writeAttribute(QStringLiteral("version"), QStringLiteral("1.0"));
  xml.writeStartElement(QStringLiteral("vtkMultiBlockDataSet"));
  for (int index = 0; const Block& block : blocks) {
    xml.writeEmptyElement(QStringLiteral("DataSet"));
    xml.writeAttribute(QStringLiteral("index"), QString::number(index++));
    xml.writeAttribute(QStringLiteral("name"), QLatin1String(block.name));
    xml.writeAttribute(QStringLiteral("file"), QString::fromStdString(block.file));
  }
  xml.writeEndDocument();
  return text.toStdString();
}

void write_instant(const fs::path& folder, const std::string& ending, const Surfaces& surfaces,
                   const ExportedInstant& instant) {
  const Block blocks[] = {{"fixed", "fixed.vtp"},
                          {"probe", "probe" + ending + ".vtp"},
                          {"ghost", "ghost" + ending + ".vtp"},
                          {"contacts", "contacts" + ending + ".vtp"},
                          {"wrench", "wrench" + ending + ".vtp"}};
  const auto probe = surface_at(*surfaces.probe, instant.probe);
  add_number(*probe, "depth [m]", instant.separation.depth);
  add_number(*probe, "time [s]", instant.time);
  write(folder / blocks[1].file, *probe);
  write(folder / blocks[2].file, *surface_at(*surfaces.probe, instant.separation.separated));
  write(folder / blocks[3].file, *contact_points(instant));
  write(folder / blocks[4].file, *wrench_point(instant, surfaces.com));
  write_whole(folder / ("sonde" + ending + ".vtm"), multiblock(blocks));
}

std::string ending_of(std::size_t step) {
  char text[32];
  std::snprintf(text, sizeof text, "_%04zu", step);
  return text;
}

}  // namespace

vtkSmartPointer<vtkPolyData> surface_at(vtkPolyData& surface, const Pose& pose) {
  vtkNew<vtkMatrix4x4> matrix;
  const Mat3 R = pose.q.toRotationMatrix();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, R(row, column));
    matrix->SetElement(row, 3, pose.p[row]);
  }
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetInputData(&surface);
  moved->SetTransform(transform);
  moved->Update();
  return moved->GetOutput();
}

vtkSmartPointer<vtkPolyData> contact_points(const ExportedInstant& instant) {
  const auto normal = array("normal", 3), on_probe = array("on probe [m]", 3);
  const auto gap = array("gap [m]", 1), multiplier = array("multiplier [m]", 1);
  const auto share = array("share of force", 1);
  vtkNew<vtkTypeInt64Array> cluster;
  cluster->SetName("cluster");
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  if (instant.separation.status == Status::penetrating)
    for (const ContactCluster& c : instant.separation.clusters) {
      const Contact& contact = c.contact;
      const vtkIdType at = points->InsertNextPoint(contact.on_fixed.data());
      vertices->InsertNextCell(1, &at);
      normal->InsertNextTuple(contact.normal.data());
      on_probe->InsertNextTuple(contact.on_probe.data());
      gap->InsertNextValue(contact.gap);
      multiplier->InsertNextValue(contact.multiplier);
      share->InsertNextValue(share_of_force(contact, instant.separation.clusters));
      cluster->InsertNextValue(static_cast<vtkTypeInt64>(c.id));
    }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  for (vtkAbstractArray* one : std::initializer_list<vtkAbstractArray*>{
           normal, on_probe, gap, multiplier, share, cluster.Get()})
    data->GetPointData()->AddArray(one);
  return data;
}

vtkSmartPointer<vtkPolyData> wrench_point(const ExportedInstant& instant, const Vec3& com) {
  const auto force = array("force [N]", 3), torque = array("torque [N m]", 3);
  force->InsertNextTuple(instant.wrench.force.data());
  torque->InsertNextTuple(instant.wrench.torque.data());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const Vec3 centre = instant.separation.device * com;
  const vtkIdType at = points->InsertNextPoint(centre.data());
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(1, &at);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(force);
  data->GetPointData()->AddArray(torque);
  return data;
}

void write_vtk(const fs::path& folder, const Surfaces& surfaces,
               std::span<const ExportedInstant> instants,
               const std::function<bool(double)>& progress) {
  NewFolder filling(folder);
  write(filling.path() / "fixed.vtp", *surfaces.fixed);
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < instants.size(); ++i) {
    report(progress, double(i) / double(instants.size()));
    const std::string ending = instants.size() > 1 ? ending_of(i) : std::string();
    write_instant(filling.path(), ending, surfaces, instants[i]);
    files.push_back({{"name", "sonde" + ending + ".vtm"}, {"time", instants[i].time}});
  }
  if (instants.size() > 1) {
    const nlohmann::ordered_json series{{"file-series-version", "1.0"}, {"files", files}};
    write_whole(filling.path() / "sonde.vtm.series", series.dump(2) + "\n");
  }
  report(progress, 1);
  filling.commit();
}

}  // namespace sonde::ui
