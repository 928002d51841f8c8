// SPDX-License-Identifier: GPL-3.0-or-later
// Without libFuzzer:
//     fuzz_NAME [--changes N] FILE_OR_FOLDER...
// runs a fuzz target over the files, each once; then over N random changes of them, the same ones
// each time. This is for targets that libFuzzer's own build makes slow.
#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Input = std::vector<std::uint8_t>;
constexpr std::size_t most_bytes = 4096;

Input current;  // what is being run, for the handler below

void run(const Input& input) {
  current = input;
  LLVMFuzzerTestOneInput(current.data(), current.size());
}

/// What ends the program is kept, in the folder that it was started in.
void keep_current(int signal) {
  const char* name = "ended-by.input";
  std::ofstream(name, std::ios::binary)
      .write(reinterpret_cast<const char*>(current.data()),
             static_cast<std::streamsize>(current.size()));
  std::fprintf(stderr, "the input is in %s\n", name);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

std::vector<std::filesystem::path> files_of(const std::vector<const char*>& arguments) {
  std::vector<std::filesystem::path> files;
  for (const char* argument : arguments) {
    if (!std::filesystem::is_directory(argument)) {
      files.emplace_back(argument);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(argument))
      if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// A few bytes others, gone or repeated, or the end of another input; now and then all at random.
Input changed(const std::vector<Input>& inputs, std::mt19937_64& random) {
  const auto below = [&random](std::size_t n) {
    return static_cast<std::size_t>(random() % std::max<std::size_t>(n, 1));
  };
  Input out = inputs[below(inputs.size())];
  if (below(8) == 0) {
    out.resize(1 + below(256));
    for (std::uint8_t& byte : out) byte = static_cast<std::uint8_t>(random());
  }
  for (std::size_t times = 1 + below(8); times > 0 && !out.empty(); --times) {
    const std::size_t at = below(out.size());
    const auto place = out.begin() + static_cast<std::ptrdiff_t>(at);
    const auto some =
        static_cast<std::ptrdiff_t>(1 + below(std::min<std::size_t>(out.size() - at, 8)));
    switch (below(5)) {
      case 0:
        *place = static_cast<std::uint8_t>(random());
        break;
      case 1:
        *place = static_cast<std::uint8_t>(*place ^ (1U << below(8)));
        break;
      case 2:
        out.erase(place, place + some);
        break;
      case 3: {
        const Input repeated(place, place + some);
        out.insert(place, repeated.begin(), repeated.end());
        break;
      }
      default: {
        const Input& other = inputs[below(inputs.size())];
        out.erase(place, out.end());
        const std::size_t from = std::min(at, other.size());
        out.insert(out.end(), other.begin() + static_cast<std::ptrdiff_t>(from), other.end());
      }
    }
  }
  out.resize(std::min(out.size(), most_bytes));
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<const char*> arguments(argv + 1, argv + argc);
  long changes = 0;
  if (arguments.size() > 1 && std::strcmp(arguments[0], "--changes") == 0) {
    changes = std::strtol(arguments[1], nullptr, 10);
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE}) std::signal(signal, keep_current);
  std::vector<Input> inputs;
  for (const auto& file : files_of(arguments)) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
      std::printf("%s: cannot be read\n", file.c_str());
      return 1;
    }
    std::printf("%s\n", file.c_str());
    std::fflush(stdout);  // the last line names the file that crashes
    inputs.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    run(inputs.back());
  }
  std::printf("%zu inputs\n", inputs.size());
  if (inputs.empty()) return 1;
  std::mt19937_64 random(1);
  for (long k = 0; k < changes; ++k) run(changed(inputs, random));
  if (changes > 0) std::printf("%ld changes of them\n", changes);
  return 0;
}
