#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of the manual's pages, as a reader would find out:

manual_check.py links SOURCE             every link leads to a page, a heading or a file
manual_check.py commands SOURCE BUILD    the commands of `sonde` run, and every flag is known; of all
                                         others the program, its flags, the preset, the target and
                                         the tests they choose are there
manual_check.py full SOURCE BUILD        the same for blocks marked <!-- full: WHY -->
manual_check.py diagram SOURCE           the diagram of folders is what its script draws

A block of commands is indented by four. It is not run where <!-- not run: WHY --> stands above it, or
where it holds a word for the reader to fill in (SCENE); its flags are looked at all the same."""
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

COMMENT = re.compile(r"<!--\s*(full|not run):\s*(.*?)\s*-->", re.DOTALL)
PLACEHOLDER = re.compile(r"\b(SCENE|NAME|DIR|FOLDER|FILE|MESH|PICTURE)\b|scene\.sonde\.json|\.\.\.")


def pages_of(source):
    folder = source / "resources/docs"
    return sorted(folder.rglob("*.md")) + [source / "README.md", source / "CONTRIBUTING.md"]


def without_code(text):
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^(    .*|\t.*)$", "", text, flags=re.MULTILINE))


def anchors_of(text):
    headings = re.findall(r"^#+ +(.*)$", text, re.MULTILINE)
    return {re.sub(r"\s", "-", re.sub(r"[^\w\s-]", "", heading.lower())) for heading in headings}


def check_links(source):
    pages, count = pages_of(source), 0
    for page in pages:
        text = without_code(page.read_text("utf-8"))
        for link in re.findall(r"\]\(([^)\s]+)\)", text):
            if re.match(r"[a-z]+:", link):
                continue
            count += 1
            path, _, anchor = link.partition("#")
            target = (page.parent / path).resolve() if path else page
            if not target.exists():
                yield f"{page}: no file is at {link}"
            elif anchor and anchor not in anchors_of(target.read_text("utf-8")):
                yield f"{page}: no heading is called {link}"
    index = (source / "resources/docs/index.md").read_text("utf-8")
    for page in (source / "resources/docs").glob("*/*.md"):
        if f"({page.parent.name}/{page.name})" not in index:
            yield f"{page}: the index does not name it"
    if count < 100:
        yield f"{count} links in all: they are not found"


def blocks_of(page):
    """The blocks of a page: the mark above each, its first line's number, its lines."""
    mark, lines, start, before = "", [], 0, ""
    for number, line in enumerate(page.read_text("utf-8").splitlines() + ["end"], 1):
        if line.startswith("    ") and (lines or not before.strip()):
            start = start if lines else number
            lines.append(line[4:])
        elif line.strip():
            if lines:
                yield mark, start, lines
                mark, lines = "", []
            found = COMMENT.match(line)
            mark = found[1] if found else ""
        before = line


def commands_in(lines):
    text = "\n".join(lines).replace("\\\n", " ")
    text = re.sub(r"  +\([^)]*\)$", "", text, flags=re.MULTILINE)  # a remark on the time it takes
    return [line for line in text.splitlines() if line and not line.startswith("#")]


def unknown_flags(command, build):
    words = command.split("|")[0].split()
    program = os.path.basename(words[0]) if words else ""
    if program not in ("sonde", "sonde-view") or not (build / "bin" / program).exists():
        return []
    asked = [build / "bin" / program] + (words[1:2] if program == "sonde" else [])
    known = subprocess.run([*asked, "--help"], capture_output=True, text=True, check=False)
    flags = [word.split("=")[0] for word in words if word.startswith("--")]
    text = known.stdout + " --help --version --"
    return [flag for flag in flags if not re.search(re.escape(flag) + r"(?![a-z-])", text)]


class Tree:
    """What a command of the pages may name."""

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
        cache = (build / "CMakeCache.txt").read_text("utf-8")
        self.has_window = "SONDE_BUILD_VIEW:BOOL=ON" in cache

    def has_target(self, name):
        return re.search(rf"\b{re.escape(name)}\b", self.makes) or self.has_program(name)

    def has_program(self, name):
        return (self.build / "bin" / name).exists() or name.replace("-", "_") in self.mains

    def chosen(self, program, pattern):
        """Whether a test program has tests of this name."""
        listed = subprocess.run([self.build / "bin" / program, f"--gtest_filter={pattern}",
                                 "--gtest_list_tests"], capture_output=True, text=True, check=False)
        return listed.returncode == 0 and "  " in listed.stdout


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


def unknown_to_others(words, tree):
    flags = [word.split("=")[0] for word in words[1:] if re.match(r"--[a-z]", word)]
    if words[0].startswith("packaging/"):
        script = tree.source / words[0]
        if not os.access(script, os.X_OK):
            yield f"no script is {words[0]}"
        else:
            text = script.read_text("utf-8") + tree.sources
            yield from (f"{words[0]} does not know {flag}" for flag in flags if flag not in text)
        return
    program = os.path.basename(words[0])
    if not tree.has_program(program):
        if tree.has_window or not program.startswith("test_ui"):
            yield f"no program is called {program}"
        return
    for word in words[1:]:
        if word.startswith("--gtest_filter="):
            for pattern in word.partition("=")[2].split(":"):
                if not tree.chosen(program, pattern):
                    yield f"{program} has no test {pattern}"
        elif word.split("=")[0] in flags and word.split("=")[0] not in tree.sources:
            yield f"{program} does not know {word}"


def unknown_in(command, tree):
    """What a command that is not sonde's names and the tree does not have."""
    for part in command.split("&&"):
        if part.startswith("sonde "):
            continue
        words = shlex.split(part.split("|")[0], comments=True)
        if not words:
            continue
        program = os.path.basename(words[0])
        if program == "cmake":
            yield from unknown_to_cmake(words, tree)
        elif words[0].startswith(("packaging/", "build/", "test_")) or program.startswith("sonde-"):
            if program not in ("sonde", "sonde-view"):  # their flags are looked at with their help
                yield from unknown_to_others(words, tree)


def check_commands(source, build, wanted):
    tree = Tree(source, build)
    others = 0
    ran = 0
    environment = dict(os.environ, PATH=f"{build}/bin:{os.environ['PATH']}")
    for page in pages_of(source):
        with tempfile.TemporaryDirectory() as scratch:
            (Path(scratch) / "resources").symlink_to(source / "resources")
            for mark, number, lines in blocks_of(page):
                commands = commands_in(lines)
                where = f"{page}:{number}"
                for command in commands:
                    for flag in unknown_flags(command, build):
                        yield f"{where}: {flag} is no flag of: {command}"
                    for complaint in unknown_in(command, tree):
                        yield f"{where}: {complaint}"
                    others += bool(re.match(r"cmake |packaging/|build/|test_", command))
                if not all(re.match(r"(sonde|sed|export) ", c) for c in commands):
                    continue
                if mark == "not run" or any(PLACEHOLDER.search(c) for c in commands):
                    continue
                # What a marked block needs is made by those above it.
                if mark == "full" and wanted != "full":
                    continue
                ran += sum(command.startswith("sonde ") for command in commands)
                done = subprocess.run(["bash", "-euo", "pipefail", "-c", "\n".join(commands)],
                                      cwd=scratch, env=environment, capture_output=True,
                                      text=True, check=False)
                if done.returncode != 0:
                    yield f"{where}: exit code {done.returncode}: {commands}\n{done.stderr}"
    if ran < 5 or others < 20:
        yield f"{ran} commands were run, {others} others looked at: they are not found"


def check_diagram(source):
    with tempfile.TemporaryDirectory() as scratch:
        drawn = Path(scratch) / "architecture.svg"
        subprocess.run([sys.executable, source / "resources/draw/architecture.py", source, drawn],
                       check=True)
        if drawn.read_text() != (source / "resources/docs/images/architecture.svg").read_text():
            yield "architecture.svg is not of these folders: resources/draw/architecture.py draws it"


def main():
    what, source = sys.argv[1], Path(sys.argv[2]).resolve()
    build = Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None
    checks = {"links": lambda: check_links(source), "diagram": lambda: check_diagram(source),
              "commands": lambda: check_commands(source, build, "ci"),
              "full": lambda: check_commands(source, build, "full")}
    complaints = list(checks[what]())
    print("\n".join(complaints), file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
