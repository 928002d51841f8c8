// SPDX-License-Identifier: GPL-3.0-or-later
// What is exported of a recording, and films, read back by others' readers.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>

#include "tests/ui/actions/export_fixture.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/base/progress_dialog.hpp"
#include "ui/export/image_file.hpp"

namespace sonde::ui::test {
namespace {

/// What is kept of a probe that was moved while the servo ran: two poses, one after the other.
class ExportRecordingTest : public ExportTest {
 protected:
  void SetUp() override {
    ExportTest::SetUp();
    window->set_paused(false);
    before = window->session()->device_pose();
    wait_ticks(400);
    after = before;
    after.p.x() += 0.01;
    window->set_device_pose(after);
    wait_ticks(400);
    window->set_paused(true);
    settle();
    wanted.options.size = {320, 240};
    wanted.span = {ticks().first_time(), ticks().last_time(), 10};
  }
  const TickLog& ticks() { return *window->history().recorder().ticks(); }
  void wait_ticks(std::uint64_t count) {
    const std::uint64_t end = ticks().end() + count;
    ASSERT_TRUE(wait_until([&] { return ticks().end() >= end; }));
  }
  Pose before, after;
};

TEST_F(ExportRecordingTest, its_table_has_every_tick) {
  run("export_recording_tables", "all.csv");
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  const QStringList lines =
      QString::fromStdString(text_of(folder / "all.csv")).split('\n', Qt::SkipEmptyParts);
  ASSERT_EQ(lines.size(), static_cast<int>(1 + ticks().end() - ticks().begin()));
  const QStringList names = lines[0].split(',');
  const auto value = [&](int row, const char* name) {
    return lines[row].split(',')[names.indexOf(name)].toDouble();
  };
  EXPECT_EQ(value(1, "px [m]"), before.p.x());
  EXPECT_EQ(value(lines.size() - 1, "px [m]"), after.p.x());
  const Snapshot middle = ticks().at(ticks().begin() + 300);
  EXPECT_EQ(value(301, "t [s]"), middle.time);
  EXPECT_EQ(value(301, "depth [m]"), middle.separation.depth);
  EXPECT_FLOAT_EQ(static_cast<float>(value(301, "fx [N]")),
                  static_cast<float>(middle.wrench.force.x()))
      << "a recording keeps a force to seven digits";
  EXPECT_TRUE(fs::exists(folder / "all.contacts.csv"));
}

TEST_F(ExportRecordingTest, vtks_reader_finds_the_probe_where_it_was) {
  run("export_recording_series", "series");
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  const QJsonArray files = QJsonDocument::fromJson(QByteArray::fromStdString(
                                                       text_of(folder / "series/sonde.vtm.series")))
                               .object()
                               .value("files")
                               .toArray();
  ASSERT_GE(files.size(), 8);
  const Vec3 half(0.05, 0.05, 0.05);
  for (const int i : {0, files.size() / 2, files.size() - 1}) {
    const QJsonObject file = files[i].toObject();
    const Snapshot tick = ticks().at(ticks().find(file.value("time").toDouble()));
    EXPECT_EQ(tick.time, file.value("time").toDouble());
    const auto all = blocks(folder / ("series/" + file.value("name").toString().toStdString()));
    EXPECT_LT((middle(*block(*all, "probe")) - tick.separation.device * half).norm(), 1e-6);
    EXPECT_LT((middle(*block(*all, "ghost")) - tick.separation.separated * half).norm(), 1e-6);
    EXPECT_EQ(block(*all, "contacts")->GetNumberOfPoints(), tick.separation.clusters.size);
  }
}

TEST_F(ExportRecordingTest, its_pictures_show_what_moved) {
  run("export_recording_pictures", "frames");
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  const int count = static_cast<int>(wanted.span.times().size());
  const auto image = [&](int i) {
    return QImage(
        path(QStringLiteral("frames/frame_%1.png").arg(i, 4, 10, QLatin1Char('0')).toUtf8()));
  };
  EXPECT_EQ(image(0).size(), QSize(320, 240));
  EXPECT_GT(pixels_between(image(0), image(count - 1)), 100);
  EXPECT_LT(pixels_between(image(count - 2), image(count - 1)),
            pixels_between(image(0), image(count - 1)) / 2)
      << "at the end it rests, but for the time that the banner says";
  EXPECT_EQ(qAlpha(image(0).pixel(2, 2)), 255) << "the first one too";
  EXPECT_TRUE(image(count).isNull());
}

/// By the system's ffmpeg; ffprobe, which comes with it, counts the frames.
TEST_F(ExportRecordingTest, its_film_has_every_picture) {
  const QString probe = QStandardPaths::findExecutable("ffprobe");
  if (find_ffmpeg().isEmpty() || probe.isEmpty())
    FAIL() << "ffmpeg and ffprobe are not installed: packaging/deps does that";
  wanted.film = true;
  run("export_recording_pictures", "film");
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  QProcess count;
  count.start(probe,
              {"-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
               "stream=nb_read_frames,width,height", "-of", "csv=p=0", path("film/recording.mp4")});
  ASSERT_TRUE(count.waitForFinished());
  EXPECT_EQ(count.readAllStandardOutput().trimmed().toStdString(),
            "320,240," + std::to_string(wanted.span.times().size()));
}

/// A stand-in for ffmpeg, the first in the path, that keeps what it is told.
class FilmTest : public ExportTest {
 protected:
  void install(const std::string& script) {
    fs::create_directory(folder / "bin");
    folder.write("bin/ffmpeg", "#!/bin/sh\n" + script);
    fs::permissions(folder / "bin/ffmpeg", fs::perms::owner_all);
    path_before_ = qgetenv("PATH");
    qputenv("PATH", QByteArray::fromStdString((folder / "bin").string()) + ':' + path_before_);
    wanted.film = true;
    wanted.frames = 3;
    wanted.options.size = {320, 240};
  }
  void TearDown() override {
    if (!path_before_.isEmpty()) qputenv("PATH", path_before_);
    ExportTest::TearDown();
  }

 private:
  QByteArray path_before_;
};

TEST_F(FilmTest, the_encoder_gets_the_pictures_in_their_order_and_rate) {
  install("echo \"$@\" > told; ls frame_*.png | wc -l > pictures; touch separation.mp4\n");
  run("export_animation", "film");
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  const std::string told = text_of(folder / "film/told");
  EXPECT_NE(told.find("-framerate 25 -i frame_%04d.png"), told.npos) << told;
  EXPECT_NE(told.find("separation.mp4"), told.npos) << told;
  EXPECT_EQ(std::stoi(text_of(folder / "film/pictures")), 3);
  EXPECT_TRUE(fs::exists(folder / "film/separation.mp4"));
}

TEST_F(FilmTest, an_encoder_that_fails_is_quoted_and_leaves_no_folder) {
  install("echo 'no such encoder' >&2; exit 1\n");
  run("export_animation", "film");
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_TRUE(complaints[0].contains("no such encoder")) << complaints[0].toStdString();
  EXPECT_FALSE(fs::exists(folder / "film"));
  EXPECT_EQ(parts_left(), 0);
}

TEST_F(ExportRecordingTest, given_up_it_leaves_no_folder) {
  wanted.span.rate = 200;
  target = path("frames");
  act("export_recording_pictures");
  ProgressDialog* progress = nullptr;
  ASSERT_TRUE(wait_until([&] {
    progress = window->findChild<ProgressDialog*>();
    return progress && progress->isVisible();
  }));
  progress->reject();
  EXPECT_FALSE(exporter().busy());
  EXPECT_FALSE(fs::exists(folder / "frames"));
  EXPECT_EQ(parts_left(), 0);
  EXPECT_TRUE(complaints.empty());
}

TEST_F(ExportRecordingTest, what_cannot_be_written_is_named) {
  for (const char* action :
       {"export_recording_pictures", "export_recording_tables", "export_recording_series"}) {
    complaints.clear();
    run(action, "no/such/folder/file");
    ASSERT_TRUE(wait_until([this] { return complaints.size() == 1; })) << action;
    EXPECT_TRUE(complaints[0].contains("no/such/folder")) << complaints[0].toStdString();
  }
  EXPECT_EQ(parts_left(), 0);
}

}  // namespace
}  // namespace sonde::ui::test
