# SPDX-License-Identifier: BSD-3-Clause
"""The first sentences that Doxygen shows in the lists of the classes' pages are whole: CheckBriefs.py
DOXYGEN DOXYFILE runs it, and fails where it warns."""

import glob
import html
import os
import re
import subprocess
import sys


def main():
    doxygen, doxyfile = sys.argv[1:]
    if subprocess.run([doxygen, doxyfile], check=False).returncode:
        sys.exit("Doxygen warns")
    with open(doxyfile, encoding="utf-8") as file:
        folder = re.search(r'^OUTPUT_DIRECTORY\s*=\s*"(.*)"', file.read(), re.M).group(1)
    pages = glob.glob(os.path.join(folder, "html", "classvtk*.html"))
    count, cut = 0, set()
    for page in pages:
        with open(page, encoding="utf-8") as file:
            rows = re.findall(r'class="mdescRight">(.*?)(?:<a href="[^"]*">More\.\.\.|<br)', file.read())
        for row in rows:
            text = html.unescape(re.sub(r"<[^>]*>", "", row)).strip()
            count += 1
            if re.search(r"\b(Eqs?|Figs?|al|e\.g|i\.e)\.$", text) or text.count("(") != text.count(")"):
                cut.add(text)
    if cut or count < 100:
        sys.exit("\n".join(sorted(cut)) or f"only {count} sentences in {len(pages)} pages")


if __name__ == "__main__":
    main()
