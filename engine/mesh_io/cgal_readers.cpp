// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/cgal_readers.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <clocale>
#include <istream>
#include <locale>
#include <new>
#include <streambuf>

namespace sonde {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

/// A string as a stream, handed out piece by piece so that each piece reports progress. Once
/// cancelled it ends.
class CountingBuffer : public std::streambuf {
 public:
  CountingBuffer(const std::string& text, const Progress& progress)
      : begin_(const_cast<char*>(text.data())),  // streambuf asks for char*, but only reads
        end_(begin_ + text.size()),
        progress_(progress) {
    show(begin_);
  }
  bool cancelled() const { return cancelled_; }

 protected:
  int_type underflow() override {
    if (cancelled_ || gptr() == end_) return traits_type::eof();
    const double done = static_cast<double>(gptr() - begin_) / static_cast<double>(end_ - begin_);
    cancelled_ = progress_ && !progress_(done);
    if (cancelled_) return traits_type::eof();
    show(gptr());
    return traits_type::to_int_type(*gptr());
  }

  pos_type seekpos(pos_type to, std::ios_base::openmode) override {
    const off_type offset = to;
    if (offset < 0 || offset > end_ - begin_) return pos_type(off_type(-1));
    show(begin_ + offset);
    return to;
  }

  pos_type seekoff(off_type by, std::ios_base::seekdir from, std::ios_base::openmode m) override {
    const off_type base = from == std::ios_base::beg   ? 0
                          : from == std::ios_base::cur ? gptr() - begin_
                                                       : end_ - begin_;
    return seekpos(pos_type(base + by), m);
  }

 private:
  void show(char* at) { setg(begin_, at, at + std::min<std::ptrdiff_t>(piece, end_ - at)); }

  static constexpr std::ptrdiff_t piece = 1 << 18;
  char *begin_, *end_;
  const Progress& progress_;
  bool cancelled_ = false;
};

/// CGAL reads lines through string streams of its own, which take the global C++ locale. Where a
/// program has set one that is not the classic one, it has to stand aside meanwhile, and C's with
/// it, for they are set together.
class ClassicLocale {
 public:
  ClassicLocale() : old_c_(std::setlocale(LC_ALL, nullptr)) {
    if (old_ != std::locale::classic()) std::locale::global(std::locale::classic());
  }
  ~ClassicLocale() {
    if (old_ == std::locale::classic()) return;
    std::locale::global(old_);
    std::setlocale(LC_ALL, old_c_.c_str());
  }
  ClassicLocale(const ClassicLocale&) = delete;
  ClassicLocale& operator=(const ClassicLocale&) = delete;

 private:
  std::locale old_;
  std::string old_c_;
};

bool parse(MeshFormat format, std::istream& stream, std::vector<Point>& points,
           std::vector<std::vector<std::size_t>>& polygons) {
  const auto quiet = CGAL::parameters::verbose(false);
  switch (format) {
    case MeshFormat::off:
      return CGAL::IO::read_OFF(stream, points, polygons, quiet);
    case MeshFormat::obj:
      return CGAL::IO::read_OBJ(stream, points, polygons, quiet);
    case MeshFormat::ply:
      return CGAL::IO::read_PLY(stream, points, polygons, quiet);
    case MeshFormat::stl:
      return CGAL::IO::read_STL(stream, points, polygons, quiet);
  }
  return false;
}

}  // namespace

bool parse_with_cgal(MeshFormat format, const std::string& text, PolygonSoup& soup,
                     const Progress& progress) {
  const ClassicLocale classic;
  CountingBuffer buffer(text, progress);
  std::istream stream(&buffer);
  std::vector<Point> points;
  bool good = false;
  try {
    good = parse(format, stream, points, soup.polygons);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {  // a failed check inside CGAL
    good = false;
  }
  if (buffer.cancelled()) throw Cancelled();
  soup.points.reserve(points.size());
  for (const Point& p : points) soup.points.emplace_back(p.x(), p.y(), p.z());
  return good;
}

}  // namespace sonde
