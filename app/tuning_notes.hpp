// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "app/study_run.hpp"
#include "engine/study/tuning/tuning.hpp"

namespace sonde::app {

/// What sonde tune says on stderr of its result while it works: a first look in seconds, what the
/// finished parts allow as it changes, and the recommendation in words at the end.
class TuningNotes {
 public:
  TuningNotes(std::shared_ptr<const TuningPlan> plan, const StudyOptions& options)
      : plan_(std::move(plan)), options_(options) {}

  /// Of the plan, unless finished parts in the folder know better already.
  void tell_first_look() const;
  /// A part is finished.
  void look_again(ProgressLine& progress);
  /// The study is joined; nothing where other shares are missing.
  void conclude() const;

 private:
  std::shared_ptr<const TuningPlan> plan_;
  const StudyOptions& options_;
  std::string last_;
};

}  // namespace sonde::app
