# SPDX-License-Identifier: GPL-3.0-or-later
"""The manual as a site: how Sphinx reads the pages of resources/docs. They are plain Markdown; the
order of the pages beside them is that of the links in index.md."""
import re

project = "Sonde"
extensions = ["myst_parser"]
myst_heading_anchors = 4
root_doc = "index"
html_theme = "alabaster"
html_theme_options = {"fixed_sidebar": True, "page_width": "72em", "sidebar_width": "17em",
                      "show_powered_by": False}
html_sidebars = {"**": ["about.html", "searchbox.html", "navigation.html"]}
html_copy_source = html_show_sourcelink = html_show_copyright = False
html_use_index = False
highlight_language = "none"


def contents_of(text):
    """The pages that index.md links to, in its order, under its headings."""
    contents, seen = "", set()
    for part in re.split(r"^## ", text, flags=re.MULTILINE)[1:]:
        pages = [page for page in re.findall(r"\]\(([\w/-]+)\.md\)", part)
                 if not (page in seen or seen.add(page))]
        heading = part.splitlines()[0]
        contents += f"\n```{{toctree}}\n:hidden:\n:caption: {heading}\n\n" + "\n".join(pages) + "\n```\n"
    return contents


def add_contents(_app, name, source):
    if name == root_doc:
        source[0] += contents_of(source[0])


def setup(app):
    app.connect("source-read", add_contents)
