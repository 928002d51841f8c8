// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tuning_notes.hpp"

#include <algorithm>
#include <iostream>

#include "engine/study/tuning/tuning_study.hpp"
#include "engine/study/tuning/tuning_words.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {

void TuningNotes::tell_first_look() const {
  const GainAxis axis = plan_->axis;
  if (tuning_so_far(options_.out, read_study(options_.out), axis)) return;
  std::cerr << "sonde: first look, in large steps: "
            << gains_in_words(read_tuning("", plan_->first_look)) << "; the study goes on\n";
}

void TuningNotes::look_again(ProgressLine& progress) {
  const StudyFolder study = read_study(options_.out);
  if (study.complete()) return;
  const auto results = tuning_so_far(options_.out, study, plan_->axis);
  if (!results) return;
  const std::string words = gains_in_words(*results);
  if (words == last_) return;
  last_ = words;
  progress.clear();
  const auto done = std::ranges::count_if(study.results, [](const auto& r) { return !!r; });
  std::cerr << "sonde: " << done << " of " << study.names.size() << " parts: at most " << words
            << "\n";
}

void TuningNotes::conclude() const {
  const StudyFolder study = read_study(options_.out);
  if (!study.complete()) return;
  for (const std::string& sentence : recommendation_in_words(read_tuning(options_.out, study)))
    std::cerr << "sonde: " << printable(sentence) << "\n";
}

}  // namespace sonde::app
