// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/contacts_panel.hpp"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTreeWidget>

#include "tests/support/shapes.hpp"
#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

enum Cell { id_at, part_at_cell, force_at, share_at, position_at, normal_at, gap_at, joined_at };

/// Two contacts whose normals are z, of 1 and 3 mm: a spring of 1000 N/m gives 1 and 3 N.
Separation two_contacts() {
  Separation out;
  out.status = Status::penetrating;
  out.depth = 0.004;
  ContactCluster small, large;
  small.id = 4;
  small.rows = 1;
  small.contact.multiplier = 0.001;
  large.id = 7;
  large.rows = 5;
  large.contact.multiplier = 0.003;
  large.contact.on_fixed = Vec3(0.01, -0.002, 0.05);
  large.contact.gap = 0.00002;
  out.clusters.items[0] = small;
  out.clusters.items[1] = large;
  out.clusters.size = 2;
  return out;
}
const Wrench four_newton{.force = Vec3(0, 0, 4)};

class ContactsPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    panel = std::make_unique<ContactsPanel>();
    QObject::connect(panel.get(), &ContactsPanel::chosen_changed,
                     [this](std::uint64_t id) { told.push_back(id); });
    const auto cube = sonde::test::body(sonde::test::box({0.04, 0.04, 0.04}));
    panel->take(Pair(cube, cube));
  }
  QTreeWidget& rows() const { return *panel->findChild<QTreeWidget*>("contact_rows"); }
  QString cell(int row, int column) const { return rows().topLevelItem(row)->text(column); }

  std::unique_ptr<ContactsPanel> panel;
  std::vector<std::uint64_t> told;
};

TEST_F(ContactsPanelTest, the_largest_share_comes_first_and_the_forces_add_up) {
  panel->show_contacts(two_contacts(), four_newton);
  ASSERT_EQ(rows().topLevelItemCount(), 2);
  EXPECT_EQ(cell(0, id_at), "7");
  EXPECT_EQ(cell(0, force_at), "3.00 N");
  EXPECT_EQ(cell(0, share_at), "75 %");
  EXPECT_EQ(cell(0, position_at), "10.000, -2.000, 50.000 mm");
  EXPECT_EQ(cell(0, normal_at), "0, 0, 1.00");
  EXPECT_EQ(cell(0, gap_at), "0.020 mm");
  EXPECT_EQ(cell(0, joined_at), "5");
  EXPECT_EQ(cell(1, id_at), "4");
  EXPECT_EQ(cell(1, force_at), "1.00 N");
  EXPECT_EQ(cell(1, share_at), "25 %");
  EXPECT_TRUE(rows().isColumnHidden(part_at_cell)) << "the fixed body is one mesh";
}

TEST_F(ContactsPanelTest, out_of_contact_there_is_no_row) {
  panel->show_contacts(two_contacts(), four_newton);
  Separation free = two_contacts();
  free.status = Status::separated;
  panel->show_contacts(free, {});
  EXPECT_EQ(rows().topLevelItemCount(), 0);
  EXPECT_EQ(panel->findChild<QLabel*>("contact_summary")->text(), "No contact.");
}

TEST_F(ContactsPanelTest, a_clicked_row_is_told_and_stays_chosen_while_the_contact_comes_and_goes) {
  panel->show_contacts(two_contacts(), four_newton);
  rows().topLevelItem(1)->setSelected(true);
  EXPECT_EQ(told, std::vector<std::uint64_t>{4});
  Separation without = two_contacts();
  without.clusters.items[0] = without.clusters.items[1];
  without.clusters.size = 1;
  panel->show_contacts(without, four_newton);
  EXPECT_TRUE(rows().selectedItems().isEmpty());
  panel->show_contacts(two_contacts(), four_newton);
  ASSERT_EQ(rows().selectedItems().size(), 1);
  EXPECT_EQ(rows().selectedItems()[0]->text(id_at), "4");
  EXPECT_EQ(told.size(), 1u) << "nobody clicked";
}

TEST_F(ContactsPanelTest, what_the_view_chooses_marks_its_row_without_being_told_back) {
  panel->show_contacts(two_contacts(), four_newton);
  panel->choose(7);
  EXPECT_TRUE(rows().topLevelItem(0)->isSelected());
  panel->choose(0);
  EXPECT_TRUE(rows().selectedItems().isEmpty());
  EXPECT_EQ(panel->chosen(), 0u);
  EXPECT_TRUE(told.empty());
}

}  // namespace
}  // namespace sonde::ui::test
