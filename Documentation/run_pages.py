#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of the README and of all pages but the tutorial, page by page, in a folder that has Data's
surfaces and what the pages name beside them. Exit 1 where one fails or does not write what its -o names.

    run_pages.py FOLDER
"""

import glob
import os
import re
import shlex
import shutil
import subprocess
import sys

from measures import COMMAND, DATA, HERE
from vtkmodules.vtkIOGeometry import vtkOBJWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

PAGES = [os.path.join(HERE, "..", "README.md"), *sorted(glob.glob(os.path.join(HERE, "*.md")))]
BY_ANOTHER_TEST = "tutorial.md"
EXIT_CODES = {"prices": 4}  # of keys that contradict each other, which the page shows
INLINE = re.compile(r"`(wirewarp (?!picture)[a-z]+ [a-z]\w*\.(?:txt|obj|vtp) [^`.]*(?:\.\w+[^`.]*)*)`")


def commands(page):
    with open(page, encoding="utf-8") as file:
        text = file.read()
    blocks = [(match.start(), match.group(1)) for match in re.finditer(r"^    (wirewarp .*)$", text, re.M)]
    inline = [(match.start(), match.group(1)) for match in INLINE.finditer(text)]
    return [shlex.split(line, comments=True)[1:] for _, line in sorted(blocks + inline)
            if not line.startswith("wirewarp picture")]  # which needs an X server


def write_obj(name, scale):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(DATA, "shirt_front.vtp"))
    reader.Update()
    surface = reader.GetOutput()
    points = surface.GetPoints()
    for k in range(points.GetNumberOfPoints()):
        points.SetPoint(k, [scale * x for x in points.GetPoint(k)])
    writer = vtkOBJWriter()
    writer.SetFileName(name)
    writer.SetInputData(surface)
    writer.Write()


def run(folder, words):
    code = subprocess.run([COMMAND, *words], cwd=folder, check=False, stdout=subprocess.DEVNULL).returncode
    if code != EXIT_CODES.get(words[0], 0):
        raise RuntimeError(f"{' '.join(words)} ended with {code}")
    for flag, name in zip(words, words[1:]):
        if flag in ("-o", "--output") and not glob.glob(os.path.join(folder, "**", name), recursive=True):
            raise RuntimeError(f"{' '.join(words)} has not written {name}")


def main(folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for name in glob.glob(os.path.join(DATA, "*.vtp")):
        shutil.copy(name, folder)
    shutil.copy(os.path.join(HERE, "tutorial_curves.txt"), os.path.join(folder, "curves.txt"))
    for name, scale in (("shirt", 1.0), ("small", 0.95), ("medium", 1.0), ("large", 1.05)):
        write_obj(os.path.join(folder, name + ".obj"), scale)
    with open(os.path.join(folder, "list.txt"), "w", encoding="utf-8") as file:
        file.write("small.obj curves.txt\nlarge.obj curves.txt\n")
    count = 0
    for page in PAGES:
        for words in () if page.endswith(BY_ANOTHER_TEST) else commands(page):
            run(folder, words)
            count += 1
    print(f"{count} commands of the pages run")


if __name__ == "__main__":
    main(*sys.argv[1:])
