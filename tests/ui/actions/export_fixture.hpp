// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLMultiBlockDataReader.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/export_control.hpp"

namespace sonde::ui::test {

namespace fs = std::filesystem;

inline std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

class ExportTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    ASSERT_TRUE(wait_until([this] { return shown().wrench.force.norm() > 0; }));
    window->set_paused(true);
    settle();
    exporter().ask_file = [this](const QString&, const QString&, const QString&) { return target; };
    exporter().ask_picture = [this](ExportDialog::Of) { return std::optional(wanted); };
    wanted.options.size = {640, 480};
  }
  ExportControl& exporter() { return window->exporter(); }
  void run(const char* action, const char* to) {
    target = path(to);
    act(action);
    ASSERT_TRUE(wait_until([this] { return !exporter().busy(); }));
  }
  vtkSmartPointer<vtkMultiBlockDataSet> blocks(const fs::path& file) {
    vtkNew<vtkXMLMultiBlockDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    return vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
  }
  static vtkPolyData* block(vtkMultiBlockDataSet& all, const std::string& name) {
    for (unsigned i = 0; i < all.GetNumberOfBlocks(); ++i)
      if (all.GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) == name)
        return vtkPolyData::SafeDownCast(all.GetBlock(i));
    return nullptr;
  }
  static Vec3 middle(vtkPolyData& data) {
    double centre[3];
    data.ComputeBounds();
    data.GetCenter(centre);
    return Vec3(centre);
  }
  int parts_left() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder.path()))
      count += entry.path().filename().string().find(".part-") != std::string::npos;
    return count;
  }
  QString target;
  PictureWanted wanted;
};

}  // namespace sonde::ui::test
