// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace sonde::app {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// Those that are shown, in the order of their declaration.
std::vector<const CLI::Option*> options_of(const CLI::App& app, bool positional) {
  return app.get_options([positional](const CLI::Option* option) {
    return option->get_positional() == positional && !option->get_group().empty();
  });
}

/// The words between braces that CLI11 writes of an option that is one of some; empty for others.
std::vector<std::string> words_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{'), end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos) return {};
  return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

/// CLI11 joins a type with the descriptions of its checks: "UINT:UINT in [0 - 1024]". The words of
/// a choice are said otherwise.
std::string type_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));
}

// The page.

/// Text as man(7) wants it: no control lines by chance, hyphens that are minus signs.
std::string text(std::string_view plain) {
  std::string out;
  bool line_begins = true;
  for (const char c : plain) {
    if (line_begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
    line_begins = c == '\n';
  }
  return out;
}

std::string bold(std::string_view plain) { return "\\fB" + text(plain) + "\\fR"; }
std::string italic(std::string_view plain) { return "\\fI" + text(plain) + "\\fR"; }

std::string joined(const std::vector<std::string>& items, std::string_view separator) {
  std::string out;
  for (const std::string& item : items) out += (out.empty() ? "" : std::string(separator)) + item;
  return out;
}

std::string names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back(bold("-" + name));
  for (const std::string& name : option.get_lnames()) names.push_back(bold("--" + name));
  return joined(names, ", ");
}

std::string value_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  std::vector<std::string> words;
  for (const std::string& word : words_of(option)) words.push_back(bold(word));
  return " " + (words.empty() ? italic(type_of(option)) : joined(words, "|"));
}

std::string entry(const std::string& title, const CLI::Option& option) {
  std::string out = ".TP\n" + title + "\n" + text(option.get_description());
  if (option.get_required()) out += " (required)";
  if (!option.get_default_str().empty())
    out += " (default: " + text(option.get_default_str()) + ")";
  return out + "\n";
}

std::string entries(const CLI::App& app) {
  std::string out;
  for (const CLI::Option* option : options_of(app, true))
    out += entry(italic(option->get_name(true)), *option);
  std::string group = "Options";
  for (const CLI::Option* option : options_of(app, false)) {
    if (option->get_group() != group) out += ".PP\n" + text(group = option->get_group()) + ":\n";
    out += entry(names_of(*option) + value_of(*option), *option);
  }
  return out;
}

std::string positionals(const CLI::App& app) {
  std::string out;
  for (const CLI::Option* option : options_of(app, true)) {
    const std::string name =
        italic(option->get_name(true)) + (option->get_items_expected_max() > 1 ? "..." : "");
    out += option->get_required() ? " " + name : " [" + name + "]";
  }
  return out;
}

std::string synopsis(const CLI::App& program) {
  const auto commands = commands_of(program);
  const std::string& name = program.get_name();
  if (commands.empty()) return bold(name) + " [options]" + positionals(program) + "\n";
  std::string out;
  for (const CLI::App* command : commands)
    out += (out.empty() ? "" : ".br\n") + bold(name + " " + command->get_name()) + " [options]" +
           positionals(*command) + "\n";
  return out;
}

std::string capitals(std::string name) {
  std::ranges::transform(name, name.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return name;
}

/// The summary as the line of NAME has it: no capital, no full stop.
std::string in_one_line(std::string summary) {
  if (summary.ends_with('.')) summary.pop_back();
  if (!summary.empty() && summary[0] >= 'A' && summary[0] <= 'Z')
    summary[0] = char(summary[0] - 'A' + 'a');
  return summary;
}

// The completion.

/// All names of the options, "-h --help --out".
std::string flags_of(const CLI::App& app) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : options_of(app, false)) {
    for (const std::string& name : option->get_snames()) flags.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  }
  return joined(flags, " ");
}

std::string case_of(const std::string& pattern, const std::string& variable,
                    const std::string& words) {
  return "    " + pattern + ") " + variable + "=\"" + words + "\" ;;\n";
}

/// One case for each option with words to choose from; the same option has the same everywhere.
std::string word_cases(const CLI::App& program) {
  std::vector<std::string> cases;
  const auto add = [&](const CLI::App& app) {
    for (const CLI::Option* option : options_of(app, false)) {
      const std::string words = joined(words_of(*option), " ");
      if (words.empty() || option->get_lnames().empty()) continue;
      const std::string line = case_of("--" + option->get_lnames().front(), "words", words);
      if (std::ranges::find(cases, line) == cases.end()) cases.push_back(line);
    }
  };
  add(program);
  for (const CLI::App* command : commands_of(program)) add(*command);
  return joined(cases, "");
}

}  // namespace

std::string manual_page(const CLI::App& program, const std::string& version,
                        const std::string& see_also) {
  const std::string& name = program.get_name();
  std::string out = ".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n";
  out += ".TH " + capitals(name) + " 1 \"\" \"sonde " + version + "\" \"User Commands\"\n";
  out += ".nh\n.SH NAME\n" + text(name) + " \\- " + text(in_one_line(program.get_description())) +
         "\n.SH SYNOPSIS\n" + synopsis(program) + ".SH OPTIONS\n" + entries(program);
  if (!commands_of(program).empty()) out += ".SH COMMANDS\n";
  for (const CLI::App* command : commands_of(program))
    out += ".SS " + text(command->get_name()) + "\n" + text(command->get_description()) + ".\n" +
           entries(*command);
  if (!program.get_footer().empty()) out += ".SH NOTES\n" + text(program.get_footer()) + "\n";
  out +=
      ".SH FILES\n.I ../share/sonde\n.RS\nbeside the program: the manual (docs), example scenes,"
      " models, device profiles and JSON schemas\n.RE\n";
  return out + ".SH SEE ALSO\n.BR " + see_also + "\n";
}

std::string bash_completion(const CLI::App& program) {
  const std::string& name = program.get_name();
  std::string function = "_" + name;
  std::ranges::replace(function, '-', '_');
  std::vector<std::string> commands;
  std::string flags = case_of("*", "flags", flags_of(program));
  for (const CLI::App* command : commands_of(program)) {
    commands.push_back(command->get_name());
    flags.insert(0, case_of(command->get_name(), "flags", flags_of(*command)));
  }
  return "# SPDX-License-Identifier: GPL-3.0-or-later\n" + function +
         "() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  local commands=\"" +
         joined(commands, " ") +
         "\" flags words=\n"
         "  case ${COMP_WORDS[1]} in\n" +
         flags +
         "  esac\n"
         "  case $previous in\n" +
         word_cases(program) +
         "    *)\n"
         "      if [[ $current == -* ]]; then\n"
         "        words=$flags\n"
         "      elif [[ $COMP_CWORD -eq 1 ]]; then\n"
         "        words=$commands\n"
         "      fi ;;\n"
         "  esac\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
         "}\n"
         "complete -o bashdefault -o default -F " +
         function + " " + name + "\n";
}

}  // namespace sonde::app
