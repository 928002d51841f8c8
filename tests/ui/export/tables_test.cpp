// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "engine/base/error.hpp"
#include "tests/support/csv.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/ui/export/made_up_instant.hpp"

namespace sonde::ui::test {
namespace {

using sonde::test::Csv;
using sonde::test::TempFolder;

TEST(InstantsCsv, has_every_number_of_an_instant_to_the_bit) {
  const ExportedInstant all[] = {made_up_instant(), made_up_free_instant()};
  const Csv table(instants_csv(all));
  ASSERT_EQ(table.rows.size(), 2u);
  const ExportedInstant& m = all[0];
  const Separation& s = m.separation;
  const std::pair<const char*, double> wanted[] = {{"t [s]", 1.25},
                                                   {"px [m]", m.probe.p.x()},
                                                   {"py [m]", m.probe.p.y()},
                                                   {"pz [m]", m.probe.p.z()},
                                                   {"qw", m.probe.q.w()},
                                                   {"qx", m.probe.q.x()},
                                                   {"qy", m.probe.q.y()},
                                                   {"qz", m.probe.q.z()},
                                                   {"sx [m]", s.separated.p.x()},
                                                   {"sz [m]", s.separated.p.z()},
                                                   {"sqw", s.separated.q.w()},
                                                   {"sqz", s.separated.q.z()},
                                                   {"depth [m]", s.depth},
                                                   {"sigma [m^2]", s.sigma},
                                                   {"translation [m]", s.translation},
                                                   {"rotation [m]", s.rotation},
                                                   {"fx [N]", 1},
                                                   {"fy [N]", -2},
                                                   {"fz [N]", 3.5},
                                                   {"tx [N m]", 0.01},
                                                   {"ty [N m]", 0.02},
                                                   {"tz [N m]", -0.03},
                                                   {"contacts", 2}};
  for (const auto& [name, value] : wanted) EXPECT_EQ(table.number(0, name), value) << name;
  EXPECT_EQ(table.text(0, "status"), "penetrating");
  EXPECT_EQ(table.text(1, "status"), "separated");
  EXPECT_EQ(table.number(1, "pz [m]"), 0.5);
}

TEST(InstantsCsv, leaves_empty_what_was_not_searched_or_not_found) {
  ExportedInstant some = made_up_instant();
  some.searched = BackgroundResult{};
  some.searched->nearest = FoundSeparation{.depth = 0.018, .separated = {}};
  some.searched->lower_bound = 0.015;
  some.clearance = -0.021;
  const ExportedInstant all[] = {made_up_instant(), some};
  const Csv table(instants_csv(all));
  for (const char* name : {"nearest [m]", "pdt [m]", "lower bound [m]", "clearance [m]"})
    EXPECT_EQ(table.text(0, name), "") << name;
  EXPECT_EQ(table.number(1, "nearest [m]"), 0.018);
  EXPECT_EQ(table.text(1, "pdt [m]"), "") << "that search failed";
  EXPECT_EQ(table.number(1, "lower bound [m]"), 0.015);
  EXPECT_EQ(table.number(1, "clearance [m]"), -0.021);
}

TEST(InstantsCsv, every_row_has_as_many_fields_as_the_header) {
  const ExportedInstant all[] = {made_up_instant(), made_up_free_instant()};
  for (const std::string& text : {instants_csv(all), contacts_csv(all)}) {
    const Csv table(text);
    for (const auto& row : table.rows)
      EXPECT_EQ(row.size(), sonde::test::split(table.header, ',').size()) << text;
  }
  EXPECT_TRUE(Csv(instants_csv({})).rows.empty()) << "of nothing the header alone";
  EXPECT_EQ(Csv(instants_csv({})).header, Csv(instants_csv(all)).header);
}

TEST(ContactsCsv, has_a_row_for_each_cluster_at_each_instant) {
  ExportedInstant later = made_up_instant();
  later.time = 2;
  const ExportedInstant all[] = {made_up_instant(), made_up_free_instant(), later};
  const Csv table(contacts_csv(all));
  ASSERT_EQ(table.rows.size(), 4u) << "a free probe has none";
  EXPECT_EQ(table.number(0, "t [s]"), 1.25);
  EXPECT_EQ(table.number(3, "t [s]"), 2);
  EXPECT_EQ(table.text(0, "contact"), "7");
  EXPECT_EQ(table.text(1, "contact"), "11");
  EXPECT_DOUBLE_EQ(table.number(0, "share"), 0.75);
  EXPECT_DOUBLE_EQ(table.number(1, "share"), 0.25);
  const Contact& contact = all[0].separation.clusters[0].contact;
  const std::pair<const char*, double> wanted[] = {{"multiplier [m]", contact.multiplier},
                                                   {"gap [m]", contact.gap},
                                                   {"az [m]", contact.on_probe.z()},
                                                   {"bx [m]", contact.on_fixed.x()},
                                                   {"bz [m]", contact.on_fixed.z()},
                                                   {"nx", 0.6},
                                                   {"ny", 0},
                                                   {"nz", 0.8},
                                                   {"rows", 4}};
  for (const auto& [name, value] : wanted) EXPECT_EQ(table.number(0, name), value) << name;
}

TEST(ContactsFile, lies_beside_the_table_of_instants) {
  EXPECT_EQ(contacts_file_of("/out/run.csv"), "/out/run.contacts.csv");
  EXPECT_EQ(contacts_file_of("/out.d/run"), "/out.d/run.contacts.csv");
  EXPECT_NE(contacts_file_of("/out/run.contacts.csv"), "/out/run.contacts.csv")
      << "one does not take the other's place";
}

TEST(WriteTables, writes_both) {
  const TempFolder folder;
  write_tables(folder / "run.csv", "instants\n", "contacts\n");
  EXPECT_EQ(sonde::test::text_of(folder / "run.csv"), "instants\n");
  EXPECT_EQ(sonde::test::text_of(folder / "run.contacts.csv"), "contacts\n");
  EXPECT_EQ(folder.file_count(), 2u);
}

TEST(WriteTables, cancelled_leaves_both_as_they_were) {
  const TempFolder folder;
  folder.write("run.csv", "old");
  EXPECT_THROW(write_tables(folder / "run.csv", "a", "b", [](double) { return false; }), Cancelled);
  EXPECT_EQ(sonde::test::text_of(folder / "run.csv"), "old");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(WriteTables, where_one_cannot_be_written_neither_is_and_it_is_named) {
  const TempFolder folder;
  folder.write("run.csv", "old");
  std::filesystem::create_directory(folder / "run.contacts.csv");
  try {
    write_tables(folder / "run.csv", "a", "b");
    ADD_FAILURE() << "a folder was in the way";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith((folder / "run.contacts.csv").string() + ":"));
  }
  EXPECT_EQ(sonde::test::text_of(folder / "run.csv"), "old");
  EXPECT_EQ(folder.file_count(), 2u) << "and nothing is left of it";
  EXPECT_THROW(write_tables(folder / "nowhere" / "run.csv", "a", "b"), InputError);
}

}  // namespace
}  // namespace sonde::ui::test
