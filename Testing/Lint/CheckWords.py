# SPDX-License-Identifier: BSD-3-Clause
"""Texts that a user meets are in plain English: no phrase of the list below stands in a page, in a text between quotes
of the programs and filters, in the comments of the public headers, in the Python package, its examples, or in the plugin.

Usage: CheckWords.py
"""

import pathlib
import re
import sys

from Sources import read, tracked_files

# What to write instead, by what is not written.
PHRASES = {
    r"so many": "the number",
    r"asks? for(?! root)": "needs, requests",
    r"in (?:the )?place of": "instead of",
    r"as far as": "until, where",
    r"told": "reports, knows",
    r"(?:is|are|was|were|be) refused|refuses?|refusing": "rejects, is an error",
    r"nobody": "no user",
    r"somebody|whoever": "a user, users",
    r"ways? out": "remedy",
    r"banks": "sides of the cut",
    r"what comes of": "the result",
    r"a (?:row|folder|line|layer|page|point|curve) a \w+": "one for each",
    r"(?<!there )(?<!has )(?:is|are) no (?!longer|more|less|other|closer|farther|larger|smaller|wider)\w+": "is not a",
    r"broken promises?": "warning",
    r"laid by": "placed by",
    r"the dearest": "by decreasing cost",
    r"how gladly": "preference weight",
    r"goes on (?:from|with|as)": "continues",
    r"has no use for": "ignores",
    r"from afar": "by penalty continuation",
    r"swallow(?:s|ed)?": "absorbs",
    r"gave up|says (?:no|yes)": "released, rejects, accepts",
    r"unless told otherwise": "by default",
    r"who (?:changes|has|wants|links)": "contributors, users",
    r"of (?:ours|one's own|its own kind)": "our, own",
    r"stands? still|stood still": "stagnates",
    r"has no way": "cannot",
    r"leads? out": "is a remedy",
    r"out of the way": "elsewhere",
    r"a last\b(?! )": "shoe last",
    r"the hand at it": "control",
    r"rooms? of Core": "directory",
    r"thereby|whereby|thereof|hereby|aforementioned": "so, by which",
    r"utili[sz]e[sd]?|leverag(?:e|es|ed|ing)": "use",
    r"in order to": "to",
    r"due to the fact|the fact that": "because, that",
    r"needless to say|please note|it should be noted": "(leave it out)",
    r"basically|obviously|simply put": "(leave it out)",
    r"seamlessly|effortlessly|blazing(?:ly)?": "(leave it out)",
    r"state[- ]of[- ]the[- ]art|cutting[- ]edge|best[- ]in[- ]class": "(say what was measured)",
    r"a wealth of|a plethora of|a myriad of": "many",
    r"at this point in time": "now",
    r"for the sake of": "for",
    r"with regards? to|in regards? to": "about",
    r"and/or": "or",
}
PATTERNS = [(re.compile(r"\b(?:" + phrase + (")" if phrase.endswith("(?! )") else r")\b"), re.IGNORECASE), better)
            for phrase, better in PHRASES.items()]
CODE = ("Applications/", "Filters/", "IO/", "Interaction/", "Figures/", "Plugin/", "Wrapping/")
TEXTS = ("Wrapping/Python/", "Plugin/", "Examples/")
LEFT_OUT = ("Testing/", "IO/Testing/", "Filters/Testing/")


def words_of(name, text):
    """The lines of a file with what is checked there, by their numbers."""
    path = pathlib.PurePath(name)
    for number, line in enumerate(text.split("\n"), 1):
        if path.suffix == ".md":
            yield number, re.sub(r"`[^`]*`", "", line)
        elif path.suffix in (".cxx", ".h") and not line.startswith("#include"):
            quoted = " | ".join(re.findall(r'"((?:[^"\\]|\\.)*)"', line))
            comment = re.search(r"//.*", line) if path.name.startswith("vtk") and path.suffix == ".h" else None
            yield number, quoted + " " + (comment.group() if comment else "")
        elif path.suffix in (".py", ".pyi", ".xml", ".in"):
            yield number, line


def faults_of(name, text):
    found = []
    for number, words in words_of(name, text):
        for pattern, better in PATTERNS:
            match = pattern.search(words)
            if match:
                found.append(f"{name}:{number}: '{match.group()}'; write: {better}")
    return found


def is_read_by_users(name):
    suffix = pathlib.PurePath(name).suffix
    if name.startswith(LEFT_OUT):
        return False
    if suffix == ".md":
        return True
    return name.startswith(CODE if suffix in (".cxx", ".h") else TEXTS)


def self_test():
    bad = {"a.md": "A row a piece.\n`so many` is a name.\n", "Filters/vtkA.h": "/// Nobody reads it.\nint banks;\n",
           "Filters/A.cxx": 'const char* const text = "3 is no number";\n// nobody\n', "Plugin/a.xml": "as far as it goes"}
    places = [fault.split(": ")[0] for name, text in bad.items() for fault in faults_of(name, text)]
    if places != ["a.md:1", "Filters/vtkA.h:1", "Filters/A.cxx:1", "Plugin/a.xml:1"]:
        sys.exit(f"the check finds {places}")


def main():
    self_test()
    names = [name for name in tracked_files() if is_read_by_users(name)]
    faults = [fault for name in names for fault in faults_of(name, read(name))]
    if faults or len(names) < 100:
        sys.exit("\n".join(faults) or "hardly any file is looked at")


if __name__ == "__main__":
    main()
