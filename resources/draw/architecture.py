#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""architecture.py SOURCE FILE: draws the folders of the engine and the window, each above all that
it sees, from the sonde_layer() lines of their CMakeLists.txt; the studies apart."""
import re
import sys
from pathlib import Path

WIDTH, HEIGHT, GAP = 150, 26, 8
COLOURS = {"engine": "#dce9f7", "ui": "#f8e6dc", "study": "#e3f1dc"}


def layers(text):
    """Folders and what each sees, in the order of their declaration."""
    found = {}
    for arguments in re.findall(r"^ *sonde_layer\(([^)]*)\)", text, re.MULTILINE):
        words = arguments.replace('"', "").replace("${SONDE_PLATFORM}", "linux").split()
        sees, keyword = [], None
        for word in words[1:]:
            if word in ("SEES", "LIBRARIES", "CGAL"):
                keyword = word
            elif keyword == "SEES":
                sees.append(word)
        found[words[0]] = sees
    return found


def rows_of(folders):
    """Folders by their height: one more than that of the highest that they see."""
    height = {}
    for name, sees in folders.items():
        height[name] = 1 + max((height[other] for other in sees if other in height), default=-1)
    rows = [[] for _ in range(1 + max(height.values()))]
    for name, level in height.items():
        rows[level].append(name)
    return rows


def box(x, y, width, text, colour):
    return (f'<rect x="{x}" y="{y}" width="{width}" height="{HEIGHT}" rx="4" fill="{colour}" '
            f'stroke="#667"/>\n<text x="{x + width / 2:g}" y="{y + 17}" '
            f'text-anchor="middle">{text}</text>\n')


def block(rows, top, y, full):
    """The rows of one folder of the tree, from the highest, and where they end."""
    out = f'<text x="10" y="{y + 17}" font-weight="bold">{top}/</text>\n'
    for row in reversed(rows):
        width = WIDTH * len(row) + GAP * (len(row) - 1)
        x = 80 + (full - width) // 2
        for name in row:
            out += box(x, y, WIDTH, name, COLOURS[top])
            x += WIDTH + GAP
        y += HEIGHT + GAP
    return out, y


def draw(source):
    ui, both = (layers((source / top / "CMakeLists.txt").read_text("utf-8"))
                for top in ("ui", "engine"))
    # The studies are a library of their own.
    study = {name: sees for name, sees in both.items() if name.startswith("study/")}
    engine = {name: sees for name, sees in both.items() if name not in study}
    read = {"ui": rows_of(ui), "study": rows_of(study), "engine": rows_of(engine)}
    most = max(len(row) for rows in read.values() for row in rows)
    full = WIDTH * most + GAP * (most - 1)
    y = 10
    body = f'<text x="10" y="{y + 17}" font-weight="bold">app/</text>\n'
    body += box(80, y, full // 2 - GAP, "sonde-view", "#e7e7e7")
    body += box(80 + full // 2, y, full - full // 2, "sonde", "#e7e7e7")
    y += HEIGHT + 3 * GAP
    for top in read:
        part, y = block(read[top], top, y, full)
        body += part
        y += 2 * GAP
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{full + 90}" height="{y}" '
            'font-family="sans-serif" font-size="12">\n'
            '<rect width="100%" height="100%" fill="white"/>\n' + body + "</svg>\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: architecture.py SOURCE FILE")
    Path(sys.argv[2]).write_text(draw(Path(sys.argv[1])), "utf-8")
