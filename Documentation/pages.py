# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts that make and check the pages share: tables between marks, and sentences."""

import os
import re

HERE = os.path.dirname(os.path.abspath(__file__))


def read(page):
    with open(os.path.join(HERE, page), encoding="utf-8") as file:
        return file.read()


def write(page, text):
    with open(os.path.join(HERE, page), "w", encoding="utf-8") as file:
        file.write(text)


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines)


def _pattern(page, text, mark):
    begin, end = f"<!-- {mark} -->\n", f"<!-- /{mark} -->\n"
    if text.count(begin) != 1 or text.count(end) != 1:
        raise ValueError(f"{page} has no place {begin.strip()}")
    return f"(?<={begin}).*?(?={end})"


def between_marks(page, mark):
    text = read(page)
    return re.search(_pattern(page, text, mark), text, re.DOTALL).group()


def filled(page, tables):
    """The page's text with each table between its marks."""
    text = read(page)
    for mark, new in tables.items():
        text = re.sub(_pattern(page, text, mark), lambda _, new=new: new, text, flags=re.DOTALL)
    return text


def unsaid(page, sentences):
    """Complaints about sentences with numbers that the page does not have; line breaks are blanks."""
    text = " ".join(read(page).split())
    return [f"{page} does not say '{sentence}'" for sentence in sentences if sentence not in text]
