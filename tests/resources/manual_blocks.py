# SPDX-License-Identifier: GPL-3.0-or-later
"""The blocks of the manual's pages that are set apart, of which kind each is, and the commands
within the text.

A comment above a block says its kind:

<!-- full: WHY -->         commands that take long: run by the full check alone
<!-- not run: WHY -->      commands that no check here can run. WHY names the test that has their
                           work or a sample of it, a path under tests/; "FILE runs it" says that
                           the file runs each of them. "no test: WHY" says why there can be none
<!-- copy of: FILE -->     the code of that file
<!-- c++: WHAT FOR -->     statements that are compiled, with what manual_check.py gives them
<!-- python: WHAT FOR -->  Python that is run

Without a comment a block is shown, where each of its lines is of a kind in SHOWN. Any other block
is commands, and they are run."""
import re
import textwrap
from dataclasses import dataclass
from pathlib import Path

MARK = re.compile(r"<!--\s*(full|not run|copy of|c\+\+|python):\s*(.*?)\s*-->")
SHOWN = re.compile("|".join((
    r"[\u2500-\u25ff≥−]| = |^\w [<>] \w",  # drawings and formulas
    r'^[{}]|^ +["}.]',                     # JSON
    r"^[A-Z]+==",                          # rules of udev
    r"^[0-9A-F]{2}( |$)",                  # bytes
    r"^@\w+ +- ",                          # limits.conf
    r"^[a-z_]+\(.*\)$")))                  # CMake
# What a command within the text begins with.
PROGRAM = re.compile(r"(sonde(-[a-z-]+)?|(test|fuzz)_\w+|cmake|ctest|(\.ci|packaging)/\S+"
                     r"|build/\w+/bin/\S+)( |$)")


@dataclass
class Block:
    page: Path
    number: int  # of its first line
    mark: str
    reason: str
    lines: list

    @property
    def where(self):
        return f"{self.page}:{self.number}"

    @property
    def kind(self):
        shown = all(SHOWN.search(line) for line in self.lines)
        return self.mark or ("shown" if shown else "commands")

    @property
    def commands(self):
        """Its lines without comments, remarks "  (7 minutes)" and breaks."""
        text = "\n".join(self.lines).replace("\\\n", " ")
        text = re.sub(r"  +\([^)]*\)$", "", text, flags=re.MULTILINE)
        return [line for line in text.splitlines() if not line.startswith("#")]


def blocks_of(page):
    """What is indented by four or more below an empty line, with the mark that stands above it."""
    above, lines, start, before = [], [], 0, ""
    for number, line in enumerate(page.read_text("utf-8").splitlines() + ["end"], 1):
        if line.startswith("    ") and (lines or not before.strip()):
            start = start if lines else number
            lines.append(line)
        elif line.strip():
            if lines:
                found = MARK.fullmatch(" ".join(above))
                mark, reason = found.groups() if found else ("", "")
                lines = textwrap.dedent("\n".join(lines)).split("\n")
                yield Block(page, start, mark, reason, lines)
                above, lines = [], []
            above = above + [line] if before.strip() else [line]
        before = line


def marks_in(page):
    """How many comments of the page are of the marks' form, wherever they are."""
    return len(re.findall(r"^ *" + MARK.pattern, page.read_text("utf-8"), re.MULTILINE | re.DOTALL))


def commands_within(page):
    """Code within the text or a table that begins as a command does, each with its line."""
    text = re.sub(r"^(    |\t).*$", "", page.read_text("utf-8"), flags=re.MULTILINE)
    for found in re.finditer(r"`((?:[^`\n]|\n(?!\s*\n))+)`", text):
        command = " ".join(found[1].split())
        if PROGRAM.match(command):
            yield text.count("\n", 0, found.start()) + 1, command
