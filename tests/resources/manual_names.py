# SPDX-License-Identifier: GPL-3.0-or-later
"""What the commands of the manual's pages name: programs, flags, presets, targets and tests."""
import functools
import json
import os
import re
import shlex
import subprocess

FILE = re.compile(r"(?<![\w/])((?:\.ci|app|packaging|resources|tests)/[\w./-]*\w)( runs\b)?")


class Tree:
    """What a command of the pages may name, and what this build can run."""

    def __init__(self, source, build):
        self.source, self.build = source, build
        makes = [source / "CMakeLists.txt", *source.glob("*/**/CMakeLists.txt"),
                 *source.glob("packaging/cmake/*.cmake")]
        self.makes = "\n".join(path.read_text("utf-8") for path in makes
                               if "build" not in path.relative_to(source).parts[:-1])
        sources = [*source.glob("tests/**/*.cpp"), *source.glob("app/*.cpp")]
        self.mains = {path.stem for path in sources}
        self.sources = "\n".join(path.read_text("utf-8") for path in sources)
        presets = json.loads((source / "CMakePresets.json").read_text("utf-8"))
        self.presets = {preset["name"] for preset in presets["configurePresets"]}
        # What a preset builds, where that is not all.
        self.builds = {preset["name"]: preset["targets"] for preset in presets["buildPresets"]
                       if "targets" in preset}
        self.cache = (build / "CMakeCache.txt").read_text("utf-8")
        self.has_window = self.cached("SONDE_BUILD_VIEW") == "ON"
        self.has_python = (self.cached("SONDE_BUILD_PYTHON") == "ON"
                           and not self.cached("SONDE_SANITIZE"))

    def cached(self, name):
        found = re.search(rf"^{name}:\w+=(.*)$", self.cache, re.MULTILINE)
        return found[1] if found else ""

    def can_run(self, block):
        """Whether this build has the window or the Python module, where the block is about them."""
        text = "\n".join(block.commands)
        if block.kind == "python" or "app/python/" in text:
            return self.has_python
        return self.has_window or "sonde-view" not in text

    def has_target(self, name):
        return re.search(rf"\b{re.escape(name)}\b", self.makes) or self.has_program(name)

    def has_program(self, name):
        return (self.build / "bin" / name).exists() or name.replace("-", "_") in self.mains

    @functools.cached_property
    def tests(self):
        """The names of the build's tests, one on a line."""
        found = (re.findall(r"add_test\(\[=+\[(.*?)\]=+\]", path.read_text("utf-8"))
                 for path in (self.build / "tests").glob("**/*.cmake"))
        return "\n".join(name for names in found for name in names)

    @functools.cache
    def help(self, *asked):
        """What a program says of itself; nothing, where this build does not have it."""
        program = self.build / "bin" / asked[0]
        return program.exists() and subprocess.run([program, *asked[1:], "--help"], text=True,
                                                   capture_output=True, check=False).stdout

    def chosen(self, program, pattern):
        """Whether a test program has tests of this name."""
        listed = subprocess.run([self.build / "bin" / program, f"--gtest_filter={pattern}",
                                 "--gtest_list_tests"], capture_output=True, text=True, check=False)
        return listed.returncode == 0 and "  " in listed.stdout


def programs_in(command):
    """The words of each program that a command runs before a pipe, from the program's own on."""
    for part in command.split("&&"):
        words = shlex.split(part.split("|")[0], comments=True)
        while words and (words[0] in ("parallel", "sudo") or re.match(r"\w+=", words[0])):
            words = words[1:]
        if words:
            yield words


def flags_of(words):
    return [word.split("=")[0] for word in words[1:] if re.match(r"--[a-z]", word)]


def unknown_to_sonde(words, tree):
    asked = [os.path.basename(words[0])]
    if not tree.help(*asked):
        return
    if asked == ["sonde"] and len(words) > 1 and not words[1].startswith("-"):
        if not re.search(rf"^  {words[1]} ", tree.help("sonde"), re.MULTILINE):
            yield f"sonde has no command {words[1]}"
        asked.append(words[1])
    text = tree.help(*asked) + " --help --version"
    yield from (f"{flag} is no flag of {' '.join(words)}" for flag in flags_of(words)
                if not re.search(re.escape(flag) + r"(?![a-z-])", text))


def unknown_to_cmake(words, tree):
    for flag, name in zip(words, words[1:]):
        if flag == "--preset" and name not in tree.presets:
            yield f"no preset is called {name}"
        if flag in ("--build", "--install") and not name.startswith("--"):
            if name.removeprefix("build/") not in tree.presets:
                yield f"no preset builds under {name}"
    if "--target" in words:
        for name in words[words.index("--target") + 1:]:
            if not tree.has_target(name):
                yield f"no target is called {name}"


def unknown_to_script(words, tree):
    script = tree.source / words[0]
    if not os.access(script, os.X_OK):
        yield f"no script is {words[0]}"
        return
    text = script.read_text("utf-8")
    yield from (f"{words[0]} does not know {flag}" for flag in flags_of(words)
                if flag not in text + tree.sources)
    for before, word in zip(words, words[1:]):
        if re.fullmatch(r"[a-z][a-z-]*", word) and not before.startswith("-"):
            if not re.search(rf"\b{word}\b", text):
                yield f"{words[0]} does not know {word}"
        if before == "-R" and (tree.has_window or not word.startswith("ui")):
            if not re.search(word, tree.tests):
                yield f"no test is called {word}"


def unknown_to_program(words, tree):
    program = os.path.basename(words[0])
    if not tree.has_program(program):
        if tree.has_window or not program.startswith("test_ui"):
            yield f"no program is called {program}"
        return
    preset = words[0].split("/")[1] if words[0].startswith("build/") else ""
    if program.replace("-", "_") not in tree.builds.get(preset, [program.replace("-", "_")]):
        yield f"the preset {preset} does not build {program}"
    for word in words[1:]:
        if word.startswith("--gtest_filter="):
            for pattern in word.partition("=")[2].split(":"):
                if not tree.chosen(program, pattern):
                    yield f"{program} has no test {pattern}"
    yield from (f"{program} does not know {flag}" for flag in flags_of(words)
                if flag not in tree.sources and not flag.startswith("--gtest_"))


def unknown_in(command, tree):
    """What a command names and the tree does not have."""
    for words in programs_in(command):
        program = os.path.basename(words[0])
        if program in ("sonde", "sonde-view"):
            yield from unknown_to_sonde(words, tree)
        elif program == "cmake":
            yield from unknown_to_cmake(words, tree)
        elif words[0].startswith((".ci/", "packaging/")):
            yield from unknown_to_script(words, tree)
        elif words[0].startswith(("build/", "test_", "fuzz_")) or program.startswith("sonde-"):
            yield from unknown_to_program(words, tree)


def names_of(block):
    """By what a file that runs a block's commands tells that it does: the programs and commands."""
    for command in block.commands:
        for words in programs_in(command):
            name = words[0] if words[0].startswith("packaging/") else os.path.basename(words[0])
            yield words[1] if name == "sonde" else name


def unkept_in(block, tree):
    """The files of a reason that are not there, or are said to run what they do not name; and
    whether it names a test at all."""
    named = FILE.findall(block.reason)
    for name, runs in named:
        path = tree.source / name
        if not path.exists():
            yield f"the reason names {name}, which is not there"
        elif runs:
            text = path.read_text("utf-8")
            yield from (f"{name} does not run {word}" for word in names_of(block)
                        if not re.search(rf"(?<![\w-]){re.escape(word)}(?![\w-])", text))
    if block.mark == "not run" and "no test: " not in block.reason:
        if not any(name.startswith("tests/") for name, _ in named):
            yield "the reason names no test under tests/, nor says \"no test: WHY\""
