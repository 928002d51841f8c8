// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/xml_walk.hpp"

#if SONDE_EXPAT
#include <expat.h>
#endif

#include <algorithm>
#include <exception>
#include <memory>

#include "engine/base/progress.hpp"

namespace sonde {
namespace {

std::string_view without_prefix(std::string_view name) {
  return name.substr(name.find(':') == name.npos ? 0 : name.find(':') + 1);
}

}  // namespace

std::string_view XmlElement::attribute(std::string_view wanted) const {
  for (const char** it = attributes; *it; it += 2)
    if (wanted == *it) return it[1];
  for (const char** it = attributes; *it; it += 2)
    if (wanted == without_prefix(*it)) return it[1];
  return {};
}

#if SONDE_EXPAT

namespace {

constexpr int deepest = 200;
constexpr std::size_t piece = 1 << 20;  // bytes between two reports

struct Walk {
  const std::string& file;
  const XmlHandlers& handlers;
  XML_Parser parser;
  int depth = 0;
  std::exception_ptr thrown = {};

  std::size_t line() const { return XML_GetCurrentLineNumber(parser); }

  /// What is thrown must not pass through the parser, which is C.
  template <class Work>
  void guard(const Work& work) noexcept {
    if (thrown) return;
    try {
      work();
    } catch (...) {
      thrown = std::current_exception();
      XML_StopParser(parser, XML_FALSE);
    }
  }
};

void on_begin(void* user, const char* name, const char** attributes) {
  Walk& walk = *static_cast<Walk*>(user);
  walk.guard([&] {
    if (++walk.depth > deepest)
      throw InputError::at_line(walk.file, walk.line(),
                                "nested more than " + std::to_string(deepest) + " elements deep");
    if (walk.handlers.begin) walk.handlers.begin({without_prefix(name), attributes, walk.line()});
  });
}

void on_end(void* user, const char* name) {
  Walk& walk = *static_cast<Walk*>(user);
  --walk.depth;
  walk.guard([&] {
    if (walk.handlers.end) walk.handlers.end(without_prefix(name));
  });
}

void on_text(void* user, const char* text, int length) {
  Walk& walk = *static_cast<Walk*>(user);
  walk.guard([&] {
    if (walk.handlers.text) walk.handlers.text({text, static_cast<std::size_t>(length)});
  });
}

void on_entity(void* user, const char*, int, const char*, int, const char*, const char*,
               const char*, const char*) {
  Walk& walk = *static_cast<Walk*>(user);
  walk.guard([&] {
    throw InputError::at_line(walk.file, walk.line(), "declares an entity, which is not read");
  });
}

}  // namespace

void walk_xml(const std::string& file, std::string_view bytes, const XmlHandlers& handlers,
              const Progress& progress) {
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(nullptr), &XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  Walk walk{file, handlers, parser.get()};
  XML_SetUserData(parser.get(), &walk);
  XML_SetElementHandler(parser.get(), on_begin, on_end);
  XML_SetCharacterDataHandler(parser.get(), on_text);
  XML_SetEntityDeclHandler(parser.get(), on_entity);
  for (std::size_t at = 0;; at += piece) {
    report(progress, static_cast<double>(at) / static_cast<double>(bytes.size() + 1));
    const std::size_t size = std::min(piece, bytes.size() - at);
    const bool last = at + size == bytes.size();
    const auto status =
        XML_Parse(parser.get(), bytes.data() + at, static_cast<int>(size), last ? 1 : 0);
    if (walk.thrown) std::rethrow_exception(walk.thrown);
    if (status == XML_STATUS_ERROR)
      throw InputError::at_line(
          file, walk.line(),
          std::string("not well-formed XML: ") + XML_ErrorString(XML_GetErrorCode(parser.get())));
    if (last) return;
  }
}

#else

void walk_xml(const std::string& file, std::string_view, const XmlHandlers&, const Progress&) {
  throw InputError::in(file, "this Sonde was built without expat, which reads files of this kind");
}

#endif

}  // namespace sonde
