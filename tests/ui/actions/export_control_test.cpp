// SPDX-License-Identifier: GPL-3.0-or-later
// What is exported of an instant, read back by others' readers: VTK's of its own files, Qt's of
// pictures and JSON, by the actions of the window.

#include <vtkFieldData.h>
#include <vtkPointData.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "tests/ui/actions/export_fixture.hpp"
#include "ui/base/progress_dialog.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

TEST_F(ExportTest, a_picture_has_the_size_asked_for_and_the_window_keeps_its_own) {
  const QImage before = picture();
  wanted.options.size = {2000, 900};
  run("export_picture", "large.png");
  const QImage image(path("large.png"));
  EXPECT_EQ(image.size(), QSize(2000, 900));
  EXPECT_LT(pixels_between(before, picture()), 20) << "the window's picture is as it was";
  EXPECT_TRUE(complaints.empty());
}

/// The middle of the fixed body is opaque, the corner is not there; text and arrows come and go.
TEST_F(ExportTest, a_picture_may_have_no_background_and_no_overlays) {
  wanted.options.transparent = true;
  wanted.options.overlays = false;
  run("export_picture", "bare.png");
  const QImage bare(path("bare.png"));
  ASSERT_TRUE(bare.hasAlphaChannel());
  EXPECT_EQ(qAlpha(bare.pixel(2, 2)), 0);
  int opaque = 0, between = 0;
  for (int y = 0; y < bare.height(); ++y)
    for (int x = 0; x < bare.width(); ++x) {
      const int alpha = qAlpha(bare.pixel(x, y));
      opaque += alpha == 255;
      between += alpha > 0 && alpha < 255;
    }
  EXPECT_GT(opaque, 10'000);
  EXPECT_EQ(between, 0) << "without overlays there is no ghost";
  wanted.options.overlays = true;
  run("export_picture", "full.png");
  EXPECT_GT(pixels_between(bare, QImage(path("full.png"))), 5000);
  wanted.options.transparent = false;
  run("export_picture", "solid.png");
  EXPECT_EQ(qAlpha(QImage(path("solid.png")).pixel(2, 2)), 255);
}

TEST_F(ExportTest, what_cannot_be_written_is_named_and_leaves_nothing) {
  for (const char* action :
       {"export_picture", "export_tables", "export_vtk", "export_gltf", "export_animation"}) {
    complaints.clear();
    run(action, "no/such/folder/file.png");
    ASSERT_TRUE(wait_until([this] { return complaints.size() == 1; })) << action;
    EXPECT_TRUE(complaints[0].contains("no/such/folder")) << complaints[0].toStdString();
  }
  EXPECT_EQ(parts_left(), 0);
}

TEST_F(ExportTest, a_folder_that_is_there_stays_as_it_is) {
  fs::create_directory(folder / "taken");
  folder.write("taken/mine.txt", "mine");
  run("export_vtk", "taken");
  ASSERT_TRUE(wait_until([this] { return complaints.size() == 1; }));
  EXPECT_TRUE(complaints[0].contains("there already"));
  EXPECT_EQ(text_of(folder / "taken/mine.txt"), "mine");
}

TEST_F(ExportTest, vtks_reader_finds_the_bodies_contacts_and_wrench) {
  run("export_vtk", "vtk");
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  const auto all = blocks(folder / "vtk/sonde.vtm");
  ASSERT_EQ(all->GetNumberOfBlocks(), 5u);
  const Separation& s = shown().separation;
  const Vec3 half(0.05, 0.05, 0.05);
  EXPECT_LT((middle(*block(*all, "fixed")) - half).norm(), 1e-6);
  EXPECT_LT((middle(*block(*all, "probe")) - s.device * half).norm(), 1e-6);
  EXPECT_LT((middle(*block(*all, "ghost")) - s.separated * half).norm(), 1e-6);
  EXPECT_EQ(block(*all, "probe")->GetNumberOfCells(), 12);
  EXPECT_DOUBLE_EQ(block(*all, "probe")->GetFieldData()->GetArray("depth [m]")->GetTuple1(0),
                   s.depth);
  vtkPolyData* contacts = block(*all, "contacts");
  ASSERT_EQ(contacts->GetNumberOfPoints(), s.clusters.size);
  for (int i = 0; i < s.clusters.size; ++i) {
    const ContactCluster& c = s.clusters[i];
    EXPECT_EQ(Vec3(contacts->GetPoint(i)), c.contact.on_fixed);
    const auto number = [&](const char* name) {
      return contacts->GetPointData()->GetArray(name)->GetTuple1(i);
    };
    EXPECT_EQ(number("gap [m]"), c.contact.gap);
    EXPECT_EQ(number("multiplier [m]"), c.contact.multiplier);
    EXPECT_EQ(Vec3(contacts->GetPointData()->GetArray("normal")->GetTuple3(i)), c.contact.normal);
  }
  vtkPolyData* wrench = block(*all, "wrench");
  EXPECT_EQ(Vec3(wrench->GetPointData()->GetArray("force [N]")->GetTuple3(0)),
            shown().wrench.force);
}

TEST_F(ExportTest, a_series_leads_from_the_device_pose_to_the_separated_one) {
  run("export_series", "series");
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  const QJsonObject series =
      QJsonDocument::fromJson(
          QByteArray::fromStdString(text_of(folder / "series/sonde.vtm.series")))
          .object();
  const QJsonArray files = series.value("files").toArray();
  ASSERT_EQ(files.size(), 26);
  EXPECT_EQ(files[0].toObject().value("time").toDouble(), 0);
  EXPECT_EQ(files[25].toObject().value("time").toDouble(), 1);
  const auto probe_at = [&](int i) {
    const auto all =
        blocks(folder / ("series/" + files[i].toObject().value("name").toString().toStdString()));
    EXPECT_TRUE(block(*all, "fixed")) << "the one file that all share";
    return middle(*block(*all, "probe"));
  };
  const Vec3 half(0.05, 0.05, 0.05);
  const Separation& s = shown().separation;
  EXPECT_LT((probe_at(0) - s.device * half).norm(), 1e-6);
  EXPECT_LT((probe_at(25) - s.separated * half).norm(), 1e-6);
  EXPECT_GT((probe_at(12) - probe_at(0)).norm(), 0.1 * s.translation);
}

/// The numbers are those on show; a column's name has its unit.
TEST_F(ExportTest, tables_say_their_units) {
  run("export_tables", "numbers.csv");
  ASSERT_TRUE(complaints.empty());
  std::istringstream lines(text_of(folder / "numbers.csv"));
  std::string header, row;
  std::getline(lines, header);
  std::getline(lines, row);
  const QStringList names = QString::fromStdString(header).split(',');
  const QStringList values = QString::fromStdString(row).split(',');
  ASSERT_EQ(names.size(), values.size());
  const auto value = [&](const char* name) { return values[names.indexOf(name)].toDouble(); };
  EXPECT_EQ(value("depth [m]"), shown().separation.depth);
  EXPECT_EQ(value("fx [N]"), shown().wrench.force.x());
  EXPECT_EQ(value("sz [m]"), shown().separation.separated.p.z());
  const std::string contacts = text_of(folder / "numbers.contacts.csv");
  EXPECT_EQ(std::count(contacts.begin(), contacts.end(), '\n'),
            1 + shown().separation.clusters.size);
}

/// The table of contacts is beside the one that was chosen: nobody has been asked about it.
TEST_F(ExportTest, a_table_beside_the_chosen_one_is_not_replaced_unasked) {
  for (const char* action : {"export_tables", "export_recording_tables"}) {
    SCOPED_TRACE(action);
    folder.write("numbers.contacts.csv", "mine");
    QString asked;
    bool answer = false;
    window->prompts().ask_replace = [&](const QString& file) {
      asked = file;
      return answer;
    };
    run(action, "numbers.csv");
    EXPECT_EQ(asked, path("numbers.contacts.csv"));
    EXPECT_EQ(text_of(folder / "numbers.contacts.csv"), "mine");
    EXPECT_FALSE(fs::exists(folder / "numbers.csv")) << "both or neither";
    answer = true;
    run(action, "numbers.csv");
    EXPECT_TRUE(text_of(folder / "numbers.contacts.csv").starts_with("t [s],contact"));
    EXPECT_TRUE(fs::exists(folder / "numbers.csv"));
    fs::remove(folder / "numbers.csv");
    EXPECT_EQ(parts_left(), 0);
  }
}

TEST_F(ExportTest, a_cancelled_export_leaves_no_file) {
  for (const char* action :
       {"export_gltf", "export_picture", "export_recording_tables", "export_vtk"}) {
    SCOPED_TRACE(action);
    target = path("cancelled");
    // Those of before go with the event loop.
    const auto before = window->findChildren<ProgressDialog*>();
    act(action);
    ProgressDialog* progress = nullptr;
    for (ProgressDialog* dialog : window->findChildren<ProgressDialog*>())
      if (!before.contains(dialog)) progress = dialog;
    ASSERT_TRUE(progress);
    progress->reject();
    EXPECT_FALSE(exporter().busy());
    wait(300);
    EXPECT_FALSE(fs::exists(folder / "cancelled"));
    EXPECT_FALSE(fs::exists(folder / "cancelled.contacts.csv"));
    EXPECT_EQ(parts_left(), 0);
    EXPECT_TRUE(complaints.empty());
  }
}

TEST_F(ExportTest, a_second_export_does_not_end_the_first) {
  target = path("first.gltf");
  act("export_gltf");
  target = path("second");
  act("export_vtk");
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_TRUE(complaints[0].contains("An export is going on")) << complaints[0].toStdString();
  ASSERT_TRUE(wait_until([this] { return !exporter().busy(); }));
  EXPECT_TRUE(fs::exists(folder / "first.gltf"));
  EXPECT_FALSE(fs::exists(folder / "second"));
}

TEST_F(ExportTest, gltf_holds_every_triangle_of_the_bodies) {
  run("export_gltf", "scene.gltf");
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  const QJsonObject root =
      QJsonDocument::fromJson(QByteArray::fromStdString(text_of(folder / "scene.gltf"))).object();
  EXPECT_EQ(root.value("asset").toObject().value("version").toString(), "2.0");
  const QJsonArray meshes = root.value("meshes").toArray();
  const QJsonArray accessors = root.value("accessors").toArray();
  // Fixed, probe and ghost, then arrows: 12 triangles each make 36 indices.
  ASSERT_GE(meshes.size(), 4);
  for (int i = 0; i < 3; ++i) {
    const QJsonObject part = meshes[i].toObject().value("primitives").toArray()[0].toObject();
    EXPECT_EQ(accessors[part.value("indices").toInt()].toObject().value("count").toInt(), 36);
  }
  EXPECT_TRUE(
      root.value("buffers").toArray()[0].toObject().value("uri").toString().startsWith("data:"));
}

TEST_F(ExportTest, the_separation_is_a_row_of_pictures_that_move) {
  wanted.frames = 5;
  wanted.options.size = {320, 240};
  run("export_animation", "frames");
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  std::vector<QImage> images;
  for (int i = 0; i < 5; ++i)
    images.emplace_back(path(QStringLiteral("frames/frame_000%1.png").arg(i).toUtf8()));
  for (const QImage& image : images) EXPECT_EQ(image.size(), QSize(320, 240));
  EXPECT_GT(pixels_between(images[0], images[4]), 100);
  EXPECT_EQ(parts_left(), 0);
}

}  // namespace
}  // namespace sonde::ui::test
