# SPDX-License-Identifier: GPL-3.0-or-later
"""markdown_filter.py PAGE: a page as Doxygen should read it.

Doxygen 1.9 does not know the anchors that headings have elsewhere, nor files that are no pages.
So each heading gets a label, links with an anchor name that, and links to other files become text.
A title must be the first line, and plain text.
"""

import os
import re
import sys


def label(page, anchor):
    return re.sub(r"\W", "_", os.path.relpath(page)) + "-" + anchor


def with_label(page, heading):
    anchor = re.sub(r"[^\w -]", "", heading[2].lower()).replace(" ", "-")
    return f"{heading[1]} {heading[2]} {{#{label(page, anchor)}}}"


def link(page, found):
    text, target = found[1], found[2]
    path, _, anchor = target.partition("#")
    if ":" in target or path.endswith(".md") and not anchor:
        return found[0]
    if path and not path.endswith(".md"):
        return text
    path = os.path.join(os.path.dirname(page), path) if path else page
    return f"[{text}](#{label(path, anchor)})"


def main(page):
    with open(page, encoding="utf-8") as file:
        text = re.sub(r"\A<!--.*-->\n", "", file.read())
    text = re.sub(r"\A# .*", lambda m: m[0].replace("`", ""), text)
    parts = re.split(r"(^```.*?^```$)", text, flags=re.MULTILINE | re.DOTALL)
    for i in range(0, len(parts), 2):  # what is outside of code
        text = re.sub(r"^(##+) (.*)$", lambda m: with_label(page, m), parts[i], flags=re.MULTILINE)
        parts[i] = re.sub(r"(?<!!)\[([^][]*)\]\(([^()\s]+)\)", lambda m: link(page, m), text)
    sys.stdout.write("".join(parts))


main(sys.argv[1])
