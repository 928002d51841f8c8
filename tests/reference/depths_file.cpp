// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/depths_file.hpp"

#include <algorithm>
#include <sstream>

#include "engine/base/error.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/text_file.hpp"

namespace sonde::reference {
namespace {

constexpr std::size_t most_bytes = 16 << 20;

/// The fields of a line, one after another.
class Fields {
 public:
  explicit Fields(const std::string& line) : in_(line) {}
  std::string text() {
    std::string out;
    if (!std::getline(in_, out, ',')) throw std::invalid_argument("too few columns");
    return out;
  }
  double number() {
    const std::string field = text();
    const auto value = parse_number(field);
    if (!value) throw std::invalid_argument("no number: " + field);
    return *value;
  }
  int count() { return static_cast<int>(number()); }
  Pose pose() {
    Pose X;
    for (double* x : {&X.p[0], &X.p[1], &X.p[2], &X.q.w(), &X.q.x(), &X.q.y(), &X.q.z()})
      *x = number();
    return X;
  }
  void end() {
    if (in_.peek() != std::istringstream::traits_type::eof())
      throw std::invalid_argument("too many columns");
  }

 private:
  std::istringstream in_;
};

Row row_of(const std::string& line) {
  Fields in(line);
  Row row;
  row.pair = in.text();
  row.index = in.count();
  row.kind = in.text();
  row.triangles_a = static_cast<std::size_t>(in.number());
  row.triangles_b = static_cast<std::size_t>(in.number());
  row.pose = in.pose();
  row.starts = in.count();
  for (double& depth : row.seeds) depth = in.number();
  row.best = in.number();
  in.count();  // agreed: follows from the depths
  row.hits = in.count();
  row.pdt = in.number();
  row.separated = in.pose();
  in.end();
  return row;
}

/// Puts a line together, field by field.
class Line {
 public:
  void text(const std::string& field) {
    if (!out_.empty()) out_ += ',';
    out_ += field;
  }
  void number(double x) { text(number_text(x, 17)); }
  template <class Count>
  void count(Count n) {
    text(std::to_string(n));
  }
  void pose(const Pose& X) {
    for (const double x : {X.p[0], X.p[1], X.p[2], X.q.w(), X.q.x(), X.q.y(), X.q.z()}) number(x);
  }
  std::string end() && {
    out_ += '\n';
    return std::move(out_);
  }

 private:
  std::string out_;
};

}  // namespace

bool agreed(const Row& row) {
  return std::count_if(row.seeds.begin(), row.seeds.end(),
                       [&](double depth) { return depth <= row.best * (1 + repeats_to); }) >= 2;
}

std::string name(const Row& row) {
  return row.pair + "/" + std::to_string(row.index) + " " + row.kind;
}

std::string header() {
  return "pair,case,kind,triangles_a,triangles_b,px,py,pz,qw,qx,qy,qz,starts,seed_1,seed_2,seed_3,"
         "best,agreed,hits,pdt,sx,sy,sz,sqw,sqx,sqy,sqz\n";
}

std::string to_line(const Row& row) {
  Line out;
  out.text(row.pair);
  out.count(row.index);
  out.text(row.kind);
  out.count(row.triangles_a);
  out.count(row.triangles_b);
  out.pose(row.pose);
  out.count(row.starts);
  for (const double depth : row.seeds) out.number(depth);
  out.number(row.best);
  out.count(agreed(row) ? 1 : 0);
  out.count(row.hits);
  out.number(row.pdt);
  out.pose(row.separated);
  return std::move(out).end();
}

std::vector<Row> read_rows(const std::filesystem::path& file) {
  std::vector<Row> out;
  if (!std::filesystem::exists(file)) return out;
  std::istringstream in(read_text(file, most_bytes));
  std::string line;
  for (std::size_t at = 1; std::getline(in, line); ++at) {
    if (at == 1) {
      if (line + "\n" != header())
        throw InputError::at_line(file.string(), 1, "not the header expected");
      continue;
    }
    try {
      out.push_back(row_of(line));
    } catch (const std::invalid_argument& error) {
      throw InputError::at_line(file.string(), at, error.what());
    }
  }
  return out;
}

void write_rows(const std::filesystem::path& file, const std::vector<Row>& rows) {
  std::string text = header();
  for (const Row& row : rows) text += to_line(row);
  write_whole(file, text);
}

}  // namespace sonde::reference
