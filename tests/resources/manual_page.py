# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the blocks of the manual's pages, as manual_check.py says."""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from manual_names import programs_in

# What the statements of a page may use.
AROUND_STATEMENTS = """#include <sonde/sonde.hpp>
struct Device {
  sonde::Pose pose() const;
  void render(const sonde::Wrench& wrench) const;
};
void statements(const sonde::Pair& pair, const sonde::Pose& X, const Device& device);
void statements(const sonde::Pair& pair, const sonde::Pose& X, const Device& device) {
  (void)pair, (void)X, (void)device;
%s
}
"""


class Page:
    """Runs the blocks of a page in a folder of its own."""

    def __init__(self, tree, scratch):
        self.tree, self.scratch = tree, scratch
        for name in ("resources", "app"):
            (scratch / name).symlink_to(tree.source / name)
        (scratch / "build").mkdir()
        (scratch / "build/release").symlink_to(tree.build)
        # Neither a person's settings, nor programs that a page does not lead to.
        path = [each for each in os.environ["PATH"].split(":")
                if Path(each).resolve() != tree.build / "bin"]
        self.environment = dict(os.environ, PATH=":".join(path), SLURM_ARRAY_TASK_ID="1",
                                XDG_CONFIG_HOME=str(scratch), XDG_DATA_HOME=str(scratch))
        self.environment.pop("PYTHONPATH", None)

    def run(self, command):
        done = subprocess.run(command, cwd=self.scratch, env=self.environment,
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
        # What it exports holds in the blocks below.
        kept = self.scratch / ".environment"
        yield from self.run(["bash", "-euo", "pipefail", "-c", f"{text}\nenv -0 >{kept}"])
        if kept.exists():
            pairs = kept.read_text("utf-8").rstrip("\0").split("\0")
            self.environment = dict(pair.split("=", 1) for pair in pairs)

    def unfound_in(self, block):
        """The programs of this build that are not found by their names where the block stands."""
        for command in block.commands:
            for name, *_ in programs_in(command):
                found = shutil.which(name, path=self.environment["PATH"]) or ""
                if "/" not in name and self.tree.has_program(name):
                    if Path(found).resolve().parent != self.tree.build / "bin":
                        yield f"no block above leads to {name}: export PATH=..."

    def run_python(self, block):
        yield from self.run([sys.executable, "-c", "\n".join(block.lines)])

    def compile(self, block):
        source = self.scratch / "statements.cpp"
        source.write_text(AROUND_STATEMENTS % "\n".join(block.lines), "utf-8")
        eigen = subprocess.run(["pkg-config", "--cflags", "eigen3"], capture_output=True, text=True,
                               check=True).stdout.split()
        yield from self.run([self.tree.cached("CMAKE_CXX_COMPILER"), "-std=c++20", "-fsyntax-only",
                             "-Wall", "-Wextra", "-Wno-unused", "-Werror",
                             f"-I{self.tree.build}/include", *eigen,
                             source])

    def compare(self, block):
        """The file's code begins after its comment."""
        lines = (self.tree.source / block.reason).read_text("utf-8").splitlines()
        while lines and lines[0].startswith("//"):
            del lines[0]
        if list(filter(None, lines)) != block.lines:
            yield f"it is not what {block.reason} holds"
