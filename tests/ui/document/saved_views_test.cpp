// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/saved_views.hpp"

#include <gtest/gtest.h>

#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>

namespace sonde::ui::test {
namespace {

/// In millimetres, its fixed body turned by 90° about z and moved by 0.1 m in x.
Scene turned_scene() {
  Scene scene;
  scene.unit = 1e-3;
  scene.fixed.pose = {Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ())), Vec3(0.1, 0, 0)};
  return scene;
}

std::string one_view(const char* position, const char* target, const char* up) {
  return std::string(R"({"saved": [{"name": "a", "camera_position": )") + position +
         R"(, "camera_target": )" + target + R"(, "camera_up": )" + up + "}]}";
}

TEST(SavedViews, are_read_in_metres_in_the_frame_of_the_fixed_body) {
  Scene scene = turned_scene();
  scene.view = one_view("[100, 200, 0]", "[100, 0, 0]", "[0, 0, 1]");
  const std::vector<SavedView> views = saved_views(scene);
  ASSERT_EQ(views.size(), 1u);
  EXPECT_EQ(views[0].name, "a");
  // 200 mm along the world's y from the body's origin, which is the body's own x.
  EXPECT_LT((views[0].place.position - Vec3(0.2, 0, 0)).norm(), 1e-12);
  EXPECT_LT(views[0].place.target.norm(), 1e-12);
  EXPECT_LT((views[0].place.up - Vec3::UnitZ()).norm(), 1e-12) << "a direction has no unit";
}

TEST(SavedViews, are_the_same_after_they_were_written) {
  Scene scene = turned_scene();
  const std::vector<SavedView> views{
      {"front “left”", {Vec3(0.1, 0.2, 0.3), Vec3(0, 0.01, 0), Vec3(0, 0.6, 0.8)}},
      {"", {Vec3(-1, 0, 0), Vec3(0, 0, 0), Vec3(0, 1, 0)}}};
  scene.view = view_with(scene, views);
  const std::vector<SavedView> again = saved_views(scene);
  ASSERT_EQ(again.size(), views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(again[i].name, views[i].name);
    EXPECT_LT((again[i].place.position - views[i].place.position).norm(), 1e-12);
    EXPECT_LT((again[i].place.target - views[i].place.target).norm(), 1e-12);
    EXPECT_LT((again[i].place.up - views[i].place.up).norm(), 1e-12);
  }
}

TEST(SavedViews, are_written_in_the_unit_of_the_scene) {
  Scene scene;
  scene.unit = 1e-3;
  scene.view = view_with(scene, {{"a", {Vec3(0.25, 0, 0), Vec3::Zero(), Vec3::UnitZ()}}});
  EXPECT_NE(scene.view.find(R"("camera_position":[250,0,0])"), std::string::npos) << scene.view;
}

/// Eyes that look along "up", in no direction, or from nowhere, show nothing.
TEST(SavedViews, that_cannot_be_looked_from_are_left_out) {
  Scene scene;
  const char *zero = "[0, 0, 0]", *x = "[1, 0, 0]", *z = "[0, 0, 1]";
  scene.view = one_view(x, zero, z);
  EXPECT_EQ(saved_views(scene).size(), 1u);
  for (const std::string& view :
       {one_view(x, x, z), one_view(z, zero, z), one_view(x, zero, zero),
        one_view("[1, 0]", zero, z), one_view(x, "\"here\"", z), one_view(x, zero, "null"),
        std::string(R"({"saved": [3, null, {"name": "b"}]})"), std::string(R"({"saved": 7})"),
        std::string("{}")}) {
    scene.view = view;
    EXPECT_TRUE(saved_views(scene).empty()) << view;
  }
}

TEST(SavedViews, leave_all_else_of_the_view_as_it_is) {
  Scene scene;
  scene.view = R"({"camera_up": [0, 1, 0], "saved": [{"name": "old"}], "up": "z"})";
  const auto object = [](const std::string& text) {
    return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
  };
  QJsonObject rest = object(scene.view);
  rest.remove("saved");
  QJsonObject with =
      object(view_with(scene, {{"new", {Vec3::UnitX(), Vec3::Zero(), Vec3::UnitZ()}}}));
  EXPECT_TRUE(with.contains("saved"));
  with.remove("saved");
  EXPECT_EQ(with, rest);
  EXPECT_EQ(object(view_with(scene, {})), rest) << "without any, nothing says so";
}

}  // namespace
}  // namespace sonde::ui::test
