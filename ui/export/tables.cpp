// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/tables.hpp"

#include <initializer_list>

#include "engine/base/progress.hpp"
#include "engine/penetration/contact/contact_clusters.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/output_file.hpp"

namespace sonde::ui {
namespace {

void add(std::string& line, double value) {
  if (!line.empty()) line += ',';
  line += number_text(value);
}
void add(std::string& line, const Vec3& x) {
  for (const double value : x) add(line, value);
}
void add(std::string& line, const Pose& pose) {
  add(line, pose.p);
  for (const double value : {pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z()}) add(line, value);
}

/// Empty where nothing was searched from that pose, or nothing found.
void add_number(std::string& line, const std::optional<double>& value) {
  line += ',';
  if (value) line += number_text(*value);
}

void add_searched(std::string& line, const std::optional<BackgroundResult>& searched) {
  const auto depth = [&](const std::optional<FoundSeparation> BackgroundResult::*way) {
    return searched && (*searched).*way ? std::optional(((*searched).*way)->depth) : std::nullopt;
  };
  add_number(line, depth(&BackgroundResult::nearest));
  add_number(line, depth(&BackgroundResult::pdt));
  add_number(line, searched ? searched->lower_bound : std::nullopt);
}

}  // namespace

std::string instants_csv(std::span<const ExportedInstant> instants) {
  std::string text =
      "t [s],px [m],py [m],pz [m],qw,qx,qy,qz,sx [m],sy [m],sz [m],sqw,sqx,sqy,sqz,"
      "depth [m],sigma [m^2],translation [m],rotation [m],fx [N],fy [N],fz [N],"
      "tx [N m],ty [N m],tz [N m],contacts,status,nearest [m],pdt [m],lower bound [m],clearance "
      "[m]\n";
  for (const ExportedInstant& m : instants) {
    std::string line;
    add(line, m.time);
    add(line, m.probe);
    add(line, m.separation.separated);
    for (const double value :
         {m.separation.depth, m.separation.sigma, m.separation.translation, m.separation.rotation})
      add(line, value);
    add(line, m.wrench.force);
    add(line, m.wrench.torque);
    add(line, m.separation.clusters.size);
    line += std::string(",") + name_of(m.separation.status);
    add_searched(line, m.searched);
    add_number(line, m.clearance);
    text += line + '\n';
  }
  return text;
}

std::string contacts_csv(std::span<const ExportedInstant> instants) {
  std::string text =
      "t [s],contact,share,multiplier [m],gap [m],ax [m],ay [m],az [m],bx [m],by [m],bz [m],"
      "nx,ny,nz,rows\n";
  for (const ExportedInstant& m : instants)
    for (const ContactCluster& c : m.separation.clusters) {
      std::string line;
      add(line, m.time);
      line += ',' + std::to_string(c.id);
      add(line, share_of_force(c.contact, m.separation.clusters));
      add(line, c.contact.multiplier);
      add(line, c.contact.gap);
      add(line, c.contact.on_probe);
      add(line, c.contact.on_fixed);
      add(line, c.contact.normal);
      add(line, c.rows);
      text += line + '\n';
    }
  return text;
}

std::filesystem::path contacts_file_of(const std::filesystem::path& file) {
  std::filesystem::path contacts = file;
  return contacts.replace_extension(".contacts.csv");
}

void write_tables(const std::filesystem::path& file, std::string_view instants,
                  std::string_view contacts, const std::function<bool(double)>& progress) {
  PendingFile first(file, instants), second(contacts_file_of(file), contacts);
  report(progress, 1);
  first.commit();
  second.commit();
}

}  // namespace sonde::ui
