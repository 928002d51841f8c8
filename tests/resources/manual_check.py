#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of the manual's pages, as a reader would find out:

manual_check.py links SOURCE             every link leads to a page, a heading or a file
manual_check.py commands SOURCE BUILD    every block of commands runs, but for those with a mark;
                                         what commands name is there, within the text too: programs,
                                         flags, presets, targets, tests; code is that of its file,
                                         compiles or runs; what no test runs is listed
manual_check.py full SOURCE BUILD        the same, and the blocks marked <!-- full: WHY --> run too
manual_check.py itself SOURCE BUILD      the kinds of blocks are told apart, faults of a page found
manual_check.py diagram SOURCE           the diagram of folders is what its script draws, and every
                                         picture is one that packaging/pictures draws

manual_blocks.py says what a block is, and what marks there are. The blocks of a page run in their
order in a folder of their own, which has resources/, app/ and build/release as the sources do after
a build: what a block needs is made, or exported, by those above it."""
import re
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.dont_write_bytecode = True
from manual_blocks import Block, blocks_of, commands_within, marks_in  # noqa: E402
from manual_names import Tree, unkept_in, unknown_in  # noqa: E402
from manual_page import Page  # noqa: E402


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


def complaints_of(block, page, wanted):
    """What is wrong with a block."""
    if block.kind in ("commands", "full", "not run"):
        for command in block.commands:
            yield from unknown_in(command, page.tree)
        yield from unkept_in(block, page.tree)
        if page.tree.can_run(block):
            yield from page.unfound_in(block)
    runs = {"commands": page.run_commands, "python": page.run_python, "c++": page.compile,
            "copy of": page.compare}
    if wanted == "full":
        runs["full"] = page.run_commands
    if block.kind in runs and page.tree.can_run(block):
        yield from runs[block.kind](block)


def complaints_about(file, tree, wanted):
    """What is wrong with a page, each with its line."""
    blocks = list(blocks_of(file))
    if re.search(r"^ *(```|~~~|\t)", file.read_text("utf-8"), re.MULTILINE):
        yield f"{file}: blocks are indented by four"
    if marks_in(file) != sum(bool(block.mark) for block in blocks):
        yield f"{file}: a mark stands above no block"
    for number, command in commands_within(file):
        if not (tree.source / command).is_file():  # a path alone names a file
            yield from (f"{file}:{number}: {what}" for what in unknown_in(command, tree))
    with tempfile.TemporaryDirectory() as scratch:
        page = Page(tree, Path(scratch))
        for block in blocks:
            yield from (f"{block.where}: {what}" for what in complaints_of(block, page, wanted))


def check_commands(source, build, wanted):
    tree = Tree(source, build)
    kinds = Counter()
    for file in pages_of(source):
        kinds["within the text"] += len(list(commands_within(file)))
        kinds.update(block.kind for block in blocks_of(file))
        for block in blocks_of(file):
            if "no test: " in block.reason:
                kinds["no test"] += 1
                print(f"{block.where}: {block.reason}")
        yield from complaints_about(file, tree, wanted)
    print(", ".join(f"{kind}: {count}" for kind, count in kinds.most_common()))
    if min(kinds[kind] for kind in ("commands", "not run", "shown", "within the text")) < 10:
        yield f"blocks are not found: {kinds}"


def check_kinds():
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


FAULTS = (
    ("    sonde devices", "no block above leads to sonde"),
    ("<!-- full: long -->\n\n    sonde devices", "no block above leads to sonde"),
    ("<!-- not run: packaging/test does -->\n\n    packaging/soak", "no test under tests/"),
    ("<!-- not run: tests/none.sh -->\n\n    packaging/soak", "tests/none.sh, which is not there"),
    ("<!-- not run: tests/packaging/fuzz.sh runs it -->\n\n    packaging/fuzz\n    packaging/soak",
     "fuzz.sh does not run packaging/soak"),
    ("<!-- not run: tests/packaging/release.sh runs it -->\n\n    packaging/rel",
     "release.sh does not run packaging/rel"),
    ("`packaging/none 3`", "no script is packaging/none"),
    ("| `packaging/none` |", "no script is packaging/none"),
    ("`packaging/sanitize everything`", "packaging/sanitize does not know everything"),
    ("`packaging/test -R no_such_test`", "no test is called no_such_test"),
    ("`sonde none`", "sonde has no command none"),
    ("`sonde\nquery --none`", "--none is no flag of sonde query"),
    ("`cmake --build build/release --target none`", "no target is called none"),
    ("`cmake --preset none`", "no preset is called none"),
    ("`test_base --gtest_filter='None.*'`", "test_base has no test None.*"),
    ("`fuzz_none`", "no program is called fuzz_none"),
    ("`build/bench/bin/sonde-generate`", "the preset bench does not build sonde-generate"),
)
SOUND = """<!-- not run: no test: of a sound page -->

    packaging/soak

Text with `packaging/races.supp`, `sonde query --poses P` and `sonde-view`.

    export PATH=$PWD/build/release/bin:$PATH

Text.

    sonde devices
"""


def check_itself(source, build):
    yield from check_kinds()
    tree = Tree(source, build)
    with tempfile.TemporaryDirectory() as scratch:
        file = Path(scratch) / "page.md"
        for page, wanted in FAULTS:
            file.write_text(page + "\n", "utf-8")
            found = list(complaints_about(file, tree, "ci"))
            if not any(wanted in complaint for complaint in found):
                yield f"{page!r} passes for sound, or for another fault: {found}"
        file.write_text(SOUND, "utf-8")
        yield from complaints_about(file, tree, "ci")


def check_diagram(source):
    with tempfile.TemporaryDirectory() as scratch:
        drawn = Path(scratch) / "architecture.svg"
        subprocess.run([sys.executable, source / "resources/draw/architecture.py", source, drawn],
                       check=True)
        if drawn.read_text() != (source / "resources/docs/images/architecture.svg").read_text():
            yield "architecture.svg is of other folders: resources/draw/architecture.py draws it"
    script = (source / "packaging/pictures").read_text("utf-8")
    for picture in (source / "resources/docs/images").iterdir():
        if not re.search(rf"^ +{picture.stem}\)", script, re.MULTILINE):
            yield f"packaging/pictures does not draw {picture.name}"


def main():
    what, source = sys.argv[1], Path(sys.argv[2]).resolve()
    build = Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None
    checks = {"links": lambda: check_links(source), "diagram": lambda: check_diagram(source),
              "commands": lambda: check_commands(source, build, "ci"),
              "full": lambda: check_commands(source, build, "full"),
              "itself": lambda: check_itself(source, build)}
    count = 0
    for count, complaint in enumerate(checks[what](), 1):
        print(complaint, file=sys.stderr)
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
