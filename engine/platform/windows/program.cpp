// SPDX-License-Identifier: GPL-3.0-or-later
// What the C library makes of the command line is in the user's code page, which most letters of
// other scripts are not in; it writes a line's end as two bytes.
#include "engine/platform/program.hpp"

#include <windows.h>
// After windows.h, which it needs.
#include <fcntl.h>
#include <io.h>
#include <shellapi.h>

#include <memory>

namespace sonde {
namespace {

/// Pairs of 16-bit units that are no character become U+FFFD.
std::string utf8(const wchar_t* wide) {
  const int size = WideCharToMultiByte(CP_UTF8, 0, wide, -1, nullptr, 0, nullptr, nullptr);
  std::string text(static_cast<std::size_t>(size > 0 ? size : 1), '\0');
  WideCharToMultiByte(CP_UTF8, 0, wide, -1, text.data(), size, nullptr, nullptr);
  text.pop_back();  // the null at its end
  return text;
}

}  // namespace

std::vector<std::string> begin_program(int count, const char* const* arguments) {
  for (const int stream : {0, 1, 2}) _setmode(stream, _O_BINARY);
  SetConsoleOutputCP(CP_UTF8);
  int wide_count = 0;
  const std::unique_ptr<wchar_t*, decltype(&LocalFree)> wide(
      CommandLineToArgvW(GetCommandLineW(), &wide_count), &LocalFree);
  if (!wide) return {arguments + (count > 0 ? 1 : 0), arguments + count};
  std::vector<std::string> out;
  for (int i = 1; i < wide_count; ++i) out.push_back(utf8(wide.get()[i]));
  return out;
}

std::filesystem::path program_file() {
  std::wstring name(32768, L'\0');  // the longest that Windows has
  name.resize(GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())));
  return name;
}

}  // namespace sonde
