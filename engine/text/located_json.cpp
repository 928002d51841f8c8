// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/located_json.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/text/json_checks.hpp"

namespace sonde {
namespace {

// Far beyond any real scene: protects against files that would exhaust the stack or the time.
constexpr std::size_t deepest = 64;
constexpr std::size_t most_keys = 1000;

/// Iterates over the text and counts what the parser has read, since its events have no position.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  std::size_t* consumed = nullptr;

  reference operator*() const { return *at; }
  CountingIterator& operator++() {
    ++at;
    ++*consumed;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at == other.at; }
  bool operator!=(const CountingIterator& other) const { return at != other.at; }
};

/// Counts lines up to an offset that never decreases.
class LineCounter {
 public:
  explicit LineCounter(std::string_view text) : text_(text) {}
  std::size_t line_at(std::size_t offset) {
    for (; at_ < std::min(offset, text_.size()); ++at_)
      if (text_[at_] == '\n') ++line_;
    return line_;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

/// Removes the library's own prefix: "[...] parse error at line 1, column 2: why".
std::string reason_of(const std::string& what) {
  const std::size_t column = what.find("column ");
  const std::size_t colon = column == std::string::npos ? what.find("] ") : what.find(": ", column);
  return colon == std::string::npos ? what : what.substr(colon + 2);
}

/// Builds the tree from the parser's events.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(std::string file, std::string_view text) : file_(std::move(file)), lines_(text) {}
  JsonNode root;
  std::size_t consumed = 0;

  bool null() override { return leaf(JsonNode::Kind::null), true; }
  bool boolean(bool value) override { return leaf(JsonNode::Kind::boolean).boolean = value, true; }
  bool number_integer(number_integer_t value) override { return number(double(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(double(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }
  bool string(string_t& value) override {
    leaf(JsonNode::Kind::string).text = value;
    return true;
  }
  bool binary(binary_t&) override { return false; }  // not in JSON text
  bool start_object(std::size_t) override { return open(JsonNode::Kind::object); }
  bool start_array(std::size_t) override { return open(JsonNode::Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    const std::size_t line = here();
    if (const JsonNode* first = stack_.back()->find(name))
      throw InputError::at_line(file_, line,
                                "key " + in_quotes(name) + " is given twice (first in line " +
                                    std::to_string(first->key_line) + ")");
    if (stack_.back()->children.size() == most_keys)
      throw InputError::at_line(file_, line, "too many keys in one object");
    key_ = name;
    key_line_ = line;
    return true;
  }

  bool parse_error(std::size_t, const std::string&,
                   const nlohmann::json::exception& error) override {
    throw InputError::at_line(file_, here(), "not JSON: " + reason_of(error.what()));
  }

 private:
  /// The line of the token just read. The parser has read the token's last character or, after a
  /// number, one more, which may be a line end; so the last character is not counted.
  std::size_t here() { return lines_.line_at(consumed == 0 ? 0 : consumed - 1); }

  JsonNode& leaf(JsonNode::Kind kind) {
    JsonNode& node = stack_.empty() ? root : stack_.back()->children.emplace_back();
    node.kind = kind;
    node.line = here();
    node.key = std::move(key_);
    node.key_line = key_line_;
    key_.clear();
    return node;
  }
  bool number(double value) {
    leaf(JsonNode::Kind::number).number = value;
    return true;
  }
  bool open(JsonNode::Kind kind) {
    JsonNode& node = leaf(kind);
    if (stack_.size() == deepest) throw InputError::at_line(file_, node.line, "nested too deeply");
    node.begin = consumed - 1;
    // A parent's children move only when the next sibling is added, and then this one is closed.
    stack_.push_back(&node);
    return true;
  }
  bool close() {
    stack_.back()->end = consumed;
    stack_.pop_back();
    return true;
  }

  std::string file_;
  LineCounter lines_;
  std::vector<JsonNode*> stack_;
  std::string key_;
  std::size_t key_line_ = 0;
};

}  // namespace

const JsonNode* JsonNode::find(std::string_view name) const {
  const auto found = std::ranges::find(children, name, &JsonNode::key);
  return kind != Kind::object || found == children.end() ? nullptr : &*found;
}

JsonNode parse_json(const std::string& file, std::string_view text) {
  Builder builder(file, text);
  const CountingIterator begin{text.data(), &builder.consumed};
  const CountingIterator end{text.data() + text.size(), &builder.consumed};
  nlohmann::json::sax_parse(begin, end, &builder);
  return std::move(builder.root);
}

const char* name_of(JsonNode::Kind kind) {
  switch (kind) {
    case JsonNode::Kind::null:
      return "null";
    case JsonNode::Kind::boolean:
      return "true or false";
    case JsonNode::Kind::number:
      return "a number";
    case JsonNode::Kind::string:
      return "a string";
    case JsonNode::Kind::array:
      return "a list";
    case JsonNode::Kind::object:
      return "an object";
  }
  return "";
}

}  // namespace sonde
