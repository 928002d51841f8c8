// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <future>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkPolyData;

namespace sonde::ui {

/// Surfaces of fewer triangles are drawn in full at all times: where the processor draws, and
/// where a graphics card does.
constexpr int simplify_above = 15'000, simplify_above_on_card = 500'000;

/// How finely the bodies are drawn: in full, or simplified while something moves. Simplified
/// surfaces are made in a thread of their own; until they are there, everything is drawn in full.
class Detail {
 public:
  Detail();
  ~Detail();
  Detail(const Detail&) = delete;
  Detail& operator=(const Detail&) = delete;

  /// Other bodies from now on; of the former nothing is drawn any more.
  void clear();
  /// These actors draw that surface, in full. One of at most so many triangles stays as it is.
  void add(vtkPolyData& surface, int small, const std::vector<vtkActor*>& actors);

  void draw_simplified(bool wanted);
  /// Is there anything that is drawn simplified now?
  bool simplified() const { return simplified_; }
  /// Nothing is being made any more.
  bool made() const;

 private:
  struct Actor {
    vtkSmartPointer<vtkActor> actor;
    vtkSmartPointer<vtkMapper> full, simple;
  };
  struct Coming {
    std::future<vtkSmartPointer<vtkPolyData>> surface;
    std::vector<vtkSmartPointer<vtkActor>> actors;
  };
  void take();

  std::vector<Actor> actors_;
  std::vector<Coming> coming_;
  std::vector<std::future<vtkSmartPointer<vtkPolyData>>> abandoned_;  ///< they run out
  bool simplified_ = false;
};

}  // namespace sonde::ui
