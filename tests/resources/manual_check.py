#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of the manual's pages, as a reader would find out:

manual_check.py links SOURCE             every link leads to a page, a heading or a file
manual_check.py commands SOURCE BUILD    every block of commands runs, but for those with a mark;
                                         what commands name is there: programs, flags, presets,
                                         targets, tests; code is that of its file, compiles or runs
manual_check.py full SOURCE BUILD        the same, and the blocks marked <!-- full: WHY --> run too
manual_check.py itself SOURCE            the kinds of blocks are told apart
manual_check.py diagram SOURCE           the diagram of folders is what its script draws

manual_blocks.py says what a block is, and what marks there are. The blocks of a page run in their
order in a folder of their own, which has resources/, app/ and build/release as the sources do after
a build: what a block needs is made by those above it."""
import os
import re
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.dont_write_bytecode = True
from manual_blocks import Block, blocks_of, marks_in  # noqa: E402
from manual_names import Tree, unkept_in, unknown_in  # noqa: E402

# What the statements of a page may use.
AROUND_STATEMENTS = """#include <sonde/sonde.hpp>
struct Device {
  sonde::Pose pose() const;
  void render(const sonde::Wrench& wrench) const;
};
void statements(const sonde::Pair& pair, const Device& device);
void statements(const sonde::Pair& pair, const Device& device) {
%s
}
"""


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


class Page:
    """Runs the blocks of a page in a folder of its own."""

    def __init__(self, tree, scratch):
        self.tree, self.scratch = tree, scratch
        for name in ("resources", "app"):
            (scratch / name).symlink_to(tree.source / name)
        (scratch / "build").mkdir()
        (scratch / "build/release").symlink_to(tree.build)
        self.environment = dict(
            os.environ, PATH=f"{tree.build}/bin:{os.environ['PATH']}", SLURM_ARRAY_TASK_ID="1",
            XDG_CONFIG_HOME=str(scratch), XDG_DATA_HOME=str(scratch))  # not a person's settings

    def run(self, command, **more):
        done = subprocess.run(command, cwd=self.scratch, env=dict(self.environment, **more),
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            yield f"exit code {done.returncode}:\n{done.stderr}"

    def run_commands(self, block):
        text = "\n".join(block.commands)
        if "sonde-view" in text and not os.environ.get("DISPLAY"):
            yield "no display: packaging/test starts one"
            return
        # A window stays until it is closed, but for one that writes a picture of itself.
        text = re.sub(r"(?m)(^|&& )(\S*sonde-view)(?=\s|$)", r"\1\2 --screenshot window.png", text)
        yield from self.run(["bash", "-euo", "pipefail", "-c", text])

    def run_python(self, block):
        yield from self.run([sys.executable, "-c", "\n".join(block.lines)],
                            PYTHONPATH=f"{self.tree.build}/python")

    def compile(self, block):
        source = self.scratch / "statements.cpp"
        source.write_text(AROUND_STATEMENTS % "\n".join(block.lines), "utf-8")
        eigen = subprocess.run(["pkg-config", "--cflags", "eigen3"], capture_output=True, text=True,
                               check=True).stdout.split()
        yield from self.run([self.tree.cached("CMAKE_CXX_COMPILER"), "-std=c++20", "-fsyntax-only",
                             "-Wall", "-Wextra", "-Werror", f"-I{self.tree.build}/include", *eigen,
                             source])

    def compare(self, block):
        """The file's code begins after its comment."""
        lines = (self.tree.source / block.reason).read_text("utf-8").splitlines()
        while lines and lines[0].startswith("//"):
            del lines[0]
        if list(filter(None, lines)) != block.lines:
            yield f"it is not what {block.reason} holds"


def complaints_of(block, page, wanted):
    """What is wrong with a block."""
    if block.kind in ("commands", "full", "not run"):
        for command in block.commands:
            yield from unknown_in(command, page.tree)
        yield from unkept_in(block, page.tree)
    runs = {"commands": page.run_commands, "python": page.run_python, "c++": page.compile,
            "copy of": page.compare}
    if wanted == "full":
        runs["full"] = page.run_commands
    if block.kind in runs and page.tree.can_run(block):
        yield from runs[block.kind](block)


def check_commands(source, build, wanted):
    tree = Tree(source, build)
    kinds = Counter()
    for file in pages_of(source):
        blocks = list(blocks_of(file))
        if re.search(r"^ *(```|~~~|\t)", file.read_text("utf-8"), re.MULTILINE):
            yield f"{file}: blocks are indented by four"
        kinds.update(block.kind for block in blocks)
        if marks_in(file) != sum(bool(block.mark) for block in blocks):
            yield f"{file}: a mark stands above no block"
        with tempfile.TemporaryDirectory() as scratch:
            page = Page(tree, Path(scratch))
            for block in blocks:
                for complaint in complaints_of(block, page, wanted):
                    yield f"{block.where}: {complaint}"
    print(", ".join(f"{kind}: {count}" for kind, count in kinds.most_common()))
    if kinds["commands"] < 10 or kinds["not run"] < 10 or kinds["shown"] < 10:
        yield f"blocks are not found: {kinds}"


def check_itself():
    """What no rule names is run, and so fails; a mark holds for the block below it alone."""
    page = """<!-- not run: of two
lines -->

    gdb sonde

Text.

    no-such-program --flag

- in a list

      sonde info a.ply  (seconds)
      # a comment

      sonde info \\
          b.ply

<!-- full: a mark above text -->

text

    F = k t
    x

    {
      "key": 1
    }
"""
    expected = [("not run", ["gdb sonde"]), ("commands", ["no-such-program --flag"]),
                ("commands", ["sonde info a.ply", "sonde info      b.ply"]),
                ("commands", ["F = k t", "x", "{", '  "key": 1', "}"])]
    with tempfile.TemporaryDirectory() as scratch:
        file = Path(scratch) / "page.md"
        file.write_text(page, "utf-8")
        found = [(block.kind, block.commands) for block in blocks_of(file)]
        if found != expected:
            yield f"the blocks are {found}"
        if marks_in(file) != 2:
            yield f"{marks_in(file)} marks"
    for line in ("a ─▶ b", "σ = |t|²", "b > K", "}", 'KERNEL=="hidraw*"', "0A 00 26  two",
                 "@group - nice 1", "find_package(sonde 0.1 REQUIRED)"):
        if Block(file, 1, "", "", [line]).kind != "shown":
            yield f"{line} is taken for a command"
    for line in ("sonde info a", "import numpy", "make x=1", "./a.out > out", "V=1 sonde devices"):
        if Block(file, 1, "", "", [line]).kind != "commands":
            yield f"{line} is not taken for a command"


def check_diagram(source):
    with tempfile.TemporaryDirectory() as scratch:
        drawn = Path(scratch) / "architecture.svg"
        subprocess.run([sys.executable, source / "resources/draw/architecture.py", source, drawn],
                       check=True)
        if drawn.read_text() != (source / "resources/docs/images/architecture.svg").read_text():
            yield "architecture.svg is of other folders: resources/draw/architecture.py draws it"


def main():
    what, source = sys.argv[1], Path(sys.argv[2]).resolve()
    build = Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None
    checks = {"links": lambda: check_links(source), "diagram": lambda: check_diagram(source),
              "commands": lambda: check_commands(source, build, "ci"),
              "full": lambda: check_commands(source, build, "full"), "itself": check_itself}
    count = 0
    for count, complaint in enumerate(checks[what](), 1):
        print(complaint, file=sys.stderr)
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
