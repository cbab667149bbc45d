#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Links and pictures of README.md and of the pages of Documentation lead to files of the project, or of
the folder into which it was installed, where that is given."""

import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(HERE)
    folder = os.path.join(root, "Documentation")
    pages = [os.path.join(folder, name) for name in sorted(os.listdir(folder)) if name.endswith(".md")]
    pages.append(os.path.join(root, "README.md"))
    count, broken = 0, []
    for page in pages:
        with open(page, encoding="utf-8") as file:
            links = re.findall(r"\]\(([^)#]+)", file.read())
        for link in links:
            if re.match(r"\w+:", link):
                continue
            count += 1
            if not os.path.exists(os.path.join(os.path.dirname(page), link)):
                broken.append(f"{os.path.relpath(page, root)}: no file {link}")
    if broken or count < 10:
        sys.exit("\n".join(broken) or "there are hardly any links")


if __name__ == "__main__":
    main()
