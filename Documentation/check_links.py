#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Links and pictures of README.md and of the pages of Documentation lead to files of the project."""

import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


def main():
    pages = [os.path.join(HERE, name) for name in sorted(os.listdir(HERE)) if name.endswith(".md")]
    pages.append(os.path.join(HERE, "..", "README.md"))
    count, broken = 0, []
    for page in pages:
        with open(page, encoding="utf-8") as file:
            links = re.findall(r"\]\(([^)#]+)", file.read())
        for link in links:
            if re.match(r"\w+:", link):
                continue
            count += 1
            if not os.path.exists(os.path.join(os.path.dirname(page), link)):
                broken.append(f"{os.path.relpath(page, HERE)}: no file {link}")
    if broken or count < 10:
        sys.exit("\n".join(broken) or "there are hardly any links")


if __name__ == "__main__":
    main()
