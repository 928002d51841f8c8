// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/xml.hpp"

#include <expat.h>

#include <memory>
#include <stdexcept>
#include <utility>

#include "engine/text/number_text.hpp"

namespace sonde::test {
namespace {

/// The elements that are open, the innermost last, under one that stands for the text.
using Open = std::vector<Xml>;

void begin(void* data, const char* name, const char** attributes) {
  Xml element;
  element.name = name;
  for (; *attributes; attributes += 2) element.attributes[attributes[0]] = attributes[1];
  static_cast<Open*>(data)->push_back(std::move(element));
}

void end(void* data, const char*) {
  Open& open = *static_cast<Open*>(data);
  Xml element = std::move(open.back());
  open.pop_back();
  open.back().children.push_back(std::move(element));
}

void characters(void* data, const char* text, int length) {
  static_cast<Open*>(data)->back().text.append(text, static_cast<std::size_t>(length));
}

void collect(const Xml& in, const std::string& named, const std::string& with_class,
             std::vector<const Xml*>& out) {
  for (const Xml& child : in.children) {
    const auto found = child.attributes.find("class");
    const std::string of_class = found == child.attributes.end() ? "" : found->second;
    if (child.name == named && (with_class.empty() || of_class == with_class))
      out.push_back(&child);
    collect(child, named, with_class, out);
  }
}

}  // namespace

const std::string& Xml::operator[](const std::string& attribute) const {
  return attributes.at(attribute);
}

double Xml::number(const std::string& attribute) const {
  return parse_number(attributes.at(attribute)).value();
}

std::vector<const Xml*> Xml::all(const std::string& named, const std::string& with_class) const {
  std::vector<const Xml*> out;
  collect(*this, named, with_class, out);
  return out;
}

Xml parse_xml(const std::string& text) {
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate("UTF-8"),
                                                                       &XML_ParserFree);
  Open open(1);
  XML_SetUserData(parser.get(), &open);
  XML_SetElementHandler(parser.get(), begin, end);
  XML_SetCharacterDataHandler(parser.get(), characters);
  if (XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE) !=
      XML_STATUS_OK)
    throw std::runtime_error("line " + std::to_string(XML_GetCurrentLineNumber(parser.get())) +
                             ": " + XML_ErrorString(XML_GetErrorCode(parser.get())));
  return open.front().children.front();
}

}  // namespace sonde::test
