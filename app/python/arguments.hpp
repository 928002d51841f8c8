// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

namespace sonde::python {

/// Text as an argument of a template.
template <std::size_t size>
struct Word {
  // NOLINTNEXTLINE(google-explicit-constructor): a literal is one
  constexpr Word(const char (&given)[size]) { std::copy_n(given, size, text); }
  char text[size];
};

/// An argument that is named where it is refused, in a line: what pybind11 says by itself is the
/// signature of the function and all that was given, arrays too.
template <Word word, class T>
struct Argument {
  T value{};
  // NOLINTNEXTLINE(google-explicit-constructor): it is the value
  operator const T&() const { return value; }
};

using MethodArgument = Argument<"method", std::string>;
using SeedArgument = Argument<"seed", std::uint64_t>;
using ThreadsArgument = Argument<"threads", unsigned>;
using BudgetSteps = Argument<"budget_steps", int>;
using BudgetMicroseconds = Argument<"budget_us", double>;
using WholeBound = Argument<"whole_bound", bool>;
using WantClearance = Argument<"clearance", bool>;
using TimeArgument = Argument<"time", std::optional<double>>;
using AccuracyArgument = Argument<"accuracy", std::optional<double>>;
using SureArgument = Argument<"sure", double>;
using FileArgument = Argument<"file", std::filesystem::path>;
using ModelArgument = Argument<"model", std::string>;
using NameArgument = Argument<"name", std::string>;
using RepairArgument = Argument<"repair", std::string>;

template <class T>
constexpr bool is_integer = std::integral<T> && !std::same_as<T, bool>;

/// What an argument of this type is to be, for an error.
template <class T>
std::string expected() {
  if constexpr (std::same_as<T, bool>) return "True or False";
  if constexpr (is_integer<T>) return "an integer";
  if constexpr (std::same_as<T, double>) return "a number";
  if constexpr (std::same_as<T, std::optional<double>>) return "a number or None";
  if constexpr (std::same_as<T, std::string>) return "a str";
  if constexpr (std::same_as<T, std::filesystem::path>) return "a str or a path";
  return "an array of numbers";
}

inline void refuse_type(const char* name, const std::string& is_to_be, pybind11::handle given) {
  throw pybind11::type_error(std::string(name) + " must be " + is_to_be + ", not " +
                             Py_TYPE(given.ptr())->tp_name);
}

/// Refuses an integer that the type has no room for: a wrong value, of the right type.
template <class T>
void need_room(const char* name, pybind11::handle given) {
  if (!PyIndex_Check(given.ptr())) return;
  const auto number = pybind11::reinterpret_steal<pybind11::object>(PyNumber_Index(given.ptr()));
  if (!number) throw pybind11::error_already_set();
  const pybind11::int_ least(std::numeric_limits<T>::min()), most(std::numeric_limits<T>::max());
  if (number >= least && number <= most) return;
  throw pybind11::value_error(std::string(name) + " is " +
                              pybind11::str(number).cast<std::string>() + "; it must be from " +
                              std::to_string(std::numeric_limits<T>::min()) + " to " +
                              std::to_string(std::numeric_limits<T>::max()));
}

}  // namespace sonde::python

namespace pybind11::detail {

template <sonde::python::Word word, class T>
struct type_caster<sonde::python::Argument<word, T>> {
  using Given = sonde::python::Argument<word, T>;
  PYBIND11_TYPE_CASTER(Given, make_caster<T>::name);

  bool load(handle given, bool) {
    make_caster<T> inner;
    if (!inner.load(given, true)) {
      if constexpr (sonde::python::is_integer<T>) sonde::python::need_room<T>(word.text, given);
      sonde::python::refuse_type(word.text, sonde::python::expected<T>(), given);
    }
    value.value = cast_op<T>(std::move(inner));
    return true;
  }
};

}  // namespace pybind11::detail
