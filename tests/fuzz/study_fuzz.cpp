// SPDX-License-Identifier: GPL-3.0-or-later
// Any text as the folder of a study: up to the first zero byte study.json, then the part "a".
#include "engine/base/error.hpp"
#include "engine/study/parts/study_parts.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

namespace fs = std::filesystem;

/// A folder of its own; gone with the object.
struct Folder {
  const fs::path path =
      fs::temp_directory_path() / ("sonde-fuzz-study-" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path / "parts"); }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  void write(const char* name, std::string_view text) const {
    std::ofstream(path / name, std::ios::binary)
        .write(text.data(), static_cast<std::streamsize>(text.size()));
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sonde;
  const std::string_view text = fuzz::text_of(data, size);
  const std::size_t end = std::min(text.find('\0'), text.size());
  static const Folder folder;  // one for all: making folders takes longer than reading them
  folder.write("study.json", text.substr(0, end));
  folder.write("parts/a.json", text.substr(std::min(end + 1, text.size())));
  try {
    const StudyFolder study = read_study(folder.path);
    fuzz::require(study.names.size() == study.results.size(), "a result or none for each part");
    fuzz::require(study.complete() || !study.names.empty(), "no parts are complete");
  } catch (const InputError&) {
  }
  return 0;
}
