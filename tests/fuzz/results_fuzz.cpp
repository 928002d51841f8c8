// SPDX-License-Identifier: GPL-3.0-or-later
// What studies have written, and what is written for them, as anybody may hand it on. The first
// byte says what the rest is: `t` a study of gains, `d` one of depths (what `study.json` says about
// it, and its parts, each after a zero byte), `s` the answers of other programs, `r` the response
// of a handle.
#include "engine/base/error.hpp"
#include "engine/study/identification/response.hpp"
#include "engine/study/parts/study_parts.hpp"
#include "engine/study/trade/trade_report.hpp"
#include "engine/study/trade/trade_series.hpp"
#include "engine/study/tuning/tuning_report.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace sonde;

constexpr std::size_t poses_of_the_study = 8;

StudyFolder study_of(const char* kind, std::string_view text) {
  StudyFolder out;
  out.kind = kind;
  const auto piece = [&text] {
    const std::size_t end = std::min(text.find('\0'), text.size());
    std::string found(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    return found;
  };
  out.about = piece();
  while (!text.empty()) {
    out.names.push_back("part " + std::to_string(out.names.size()));
    out.results.emplace_back(piece());
  }
  return out;
}

void require_text(const std::vector<StudyFile>& files) {
  for (const StudyFile& file : files) fuzz::require(!file.text.empty(), "a file has text");
}

void read(char kind, std::string_view rest) {
  if (kind == 't') require_text(tuning_files("study", study_of("tune", rest)));
  if (kind == 'd') require_text(trade_files("study", study_of("trade", rest)));
  if (kind == 's') {
    const fuzz::InputFile file(rest, ".csv");
    for (const TradeAnswer& answer : read_trade_answers(file.path(), poses_of_the_study)) {
      fuzz::require(answer.pose < poses_of_the_study, "a pose of the study");
      fuzz::require(answer.depth >= 0 && answer.time_us >= 0, "a depth and a time");
    }
  }
  if (kind == 'r') {
    const fuzz::InputFile file(rest, ".csv");
    const Response response = read_response(file.path());
    const fuzz::InputFile again(response_text(response), "-again.csv");
    fuzz::require(response_text(read_response(again.path())) == response_text(response),
                  "a response survives being saved");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    read(static_cast<char>(data[0]), fuzz::text_of(data + 1, size - 1));
  } catch (const sonde::InputError&) {
  }
  return 0;
}
