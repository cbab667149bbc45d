# SPDX-License-Identifier: BSD-3-Clause
"""README.md and the pages of Documentation are short and read easily: a limit of lines, lines of at most 100 characters
but for tables, pictures, commands and long links, and a Flesch reading ease of at least 50 for each page.

Flesch's formula: 206.835 - 1.015 words / sentences - 84.6 syllables / words. Paragraphs and items of lists are counted;
code between backquotes is a word of one syllable. Headings, tables, commands and pictures are left out.

Usage: CheckPages.py [--list]
"""

import re
import sys

from Sources import read, tracked_files

LINES = {"README.md": 120, "CHANGELOG.md": 60}
WIDTHS = {"README.md": 120, "CHANGELOG.md": 120}
LINES_OF_DOCUMENTATION = 1990
LINE_WIDTH = 100
READING_EASE = 50


def paragraphs(text):
    """The prose of a page: its paragraphs and items of lists."""
    text = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)
    text = re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE)
    for block in re.split(r"\n\s*\n", text):
        lines = [line for line in block.split("\n") if line and not re.match(r"    \S|[#|!]", line)]
        for part in re.split(r"\n(?=\s*(?:[-*]|\d+\.)\s)", "\n".join(lines)):
            if part.strip():
                yield " ".join(part.split())


def syllables(word):
    """Groups of vowels, without a silent e at the end (curve, curves, curved, but not table, pieces or dented)."""
    silent = re.compile(r"(?<=[^aeiouyl])e$|(?<=[^aeiouylscxzgh])es$|(?<=[^aeiouytd])ed$")
    return max(1, len(re.findall(r"[aeiouy]+", silent.sub("", word.lower()))))


def reading_ease(text):
    """Flesch's figure of a page; 100 where it has no prose."""
    words, sentences = [], 0
    for paragraph in paragraphs(text):
        plain = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", re.sub(r"`[^`]*`", "code", paragraph))
        for sentence in re.split(r"(?<=[.?!])[*)\"]*\s+(?=\S)", plain):
            found = re.findall(r"[A-Za-z]+(?:['-][A-Za-z]+)*", sentence)
            words += [part for word in found for part in word.split("-") if part]
            sentences += bool(found)
    if not words:
        return 100.0
    return 206.835 - 1.015 * len(words) / sentences - 84.6 * sum(map(syllables, words)) / len(words)


def faults_of(name, text):
    found = []
    width = WIDTHS.get(name, LINE_WIDTH)
    for number, line in enumerate(text.split("\n"), 1):
        if len(line) > width and " " in line.strip() and not re.match(r"\||!|    |<", line):
            found.append(f"{name}:{number}: {len(line)} characters, at most {width}")
    if text.count("\n") > LINES.get(name, LINES_OF_DOCUMENTATION):
        found.append(f"{name}: {text.count(chr(10))} lines, at most {LINES.get(name, LINES_OF_DOCUMENTATION)}")
    if name != "CHANGELOG.md" and reading_ease(text) < READING_EASE:
        found.append(f"{name}: a reading ease of {reading_ease(text):.1f}, at least {READING_EASE}; write shorter sentences")
    return found


def self_test():
    if [syllables(word) for word in ("the", "surface", "table", "curves", "pieces", "boundary")] != [1, 2, 2, 1, 2, 3]:
        sys.exit("syllables are counted wrongly")
    easy, hard = "The cat sat on the mat. It ate.\n", "Developability characterizes triangulated surfaces " * 6 + ".\n"
    if not (reading_ease(easy) > 100 > 0 > reading_ease(hard)) or faults_of("a.md", easy) or len(faults_of("a.md", hard)) != 2:
        sys.exit("the check finds nothing")


def main():
    self_test()
    names = [name for name in tracked_files() if re.match(r"(Documentation/\w+|README|CHANGELOG)\.md$", name)]
    pages = {name: read(name) for name in names}
    if "--list" in sys.argv[1:]:
        for name, text in pages.items():
            print(f"{reading_ease(text):5.1f} {text.count(chr(10)):5d} {name}")
    faults = [fault for name, text in pages.items() for fault in faults_of(name, text)]
    lines = sum(text.count("\n") for name, text in pages.items() if name.startswith("Documentation/"))
    if lines > LINES_OF_DOCUMENTATION:
        faults.append(f"Documentation has {lines} lines, at most {LINES_OF_DOCUMENTATION}")
    if faults or len(names) < 10:
        sys.exit("\n".join(faults) or "hardly any page is looked at")


if __name__ == "__main__":
    main()
