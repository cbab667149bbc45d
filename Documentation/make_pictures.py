#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of tutorial.md and draws the pictures of the documentation. Needs an X server.

The pictures of the window are made by its test, which draws the tutorial's curves by mouse, where it is built;
the variable PATTERN_EDITOR_TEST names it.

    make_pictures.py FOLDER    writes the pictures to FOLDER/images and, for the HTML pages alone,
                               FOLDER/pages/pieces.md with a picture of each piece
"""

import os
import shlex
import subprocess
import sys

from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkImagingCore import vtkExtractVOI, vtkImageResize
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

import method_drawing
import shapes
from measures import COMMAND, DATA, HERE, PIECES

WIDTH = 640  # of a picture in a page, in pixels
COLUMNS, COLUMN_WIDTH = 3, 240  # of the gallery
SHAPE_WIDTH = 480
WINDOW_WIDTH = 900  # of a picture of the window
PARAVIEW_WIDTH, PARAVIEW_HEIGHT = 720, 760
EDITOR = os.environ.get("PATTERN_EDITOR_TEST",
                        os.path.join(os.path.dirname(COMMAND), "TestPatternEditor"))
EDITOR_SESSIONS = ("TheTutorialsCurvesDrawnByMouseSavedAndLoadedGiveItsReport", "AStrokeIsACurveOfFewNodes",
                   "AnOffsetRunsThroughTheClickedPlaceOrAtTheGivenDistance",
                   "ANewUserGetsFromAMeshToAPdfByTheMenus")


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def write(image, path):
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.SetCompressionLevel(9)
    writer.Write()
    if not os.path.isfile(path):
        raise RuntimeError(f"cannot write {path}")


def scaled(image, width, above=0):
    """The picture without the rows below `above`, as wide as is asked for."""
    columns, rows, _ = image.GetDimensions()
    part = vtkExtractVOI()
    part.SetInputData(image)
    part.SetVOI(0, columns - 1, above, rows - 1, 0, 0)
    resize = vtkImageResize()
    resize.SetInputConnection(part.GetOutputPort())
    resize.SetOutputDimensions(width, round(width * (rows - above) / columns), 1)
    resize.Update()
    result = resize.GetOutput()
    result.SetExtent(0, result.GetDimensions()[0] - 1, 0, result.GetDimensions()[1] - 1, 0, 0)
    return result


def appended(images, axis):
    append = vtkImageAppend()
    append.SetAppendAxis(axis)
    for image in images:
        append.AddInputData(image)
    append.Update()
    return append.GetOutput()


def commands():
    """The commands of the tutorial, indented by four spaces in its source."""
    with open(os.path.join(HERE, "tutorial.md"), encoding="utf-8") as file:
        return [shlex.split(line)[1:] for line in file if line.startswith("    wirewarp ")]


def run_tutorial(folder, images):
    """Runs the commands in a folder that looks like the clone."""
    for name in ("Data", "Documentation"):
        if not os.path.lexists(os.path.join(folder, name)):
            os.symlink(os.path.join(HERE, "..", name), os.path.join(folder, name))
    made = os.path.join(folder, "build", "tutorial")
    os.makedirs(made, exist_ok=True)
    for arguments in commands():
        subprocess.run([COMMAND, *arguments], cwd=folder, check=True)
    for name in ("first", "second"):
        write(scaled(read(os.path.join(made, name + ".png")), WIDTH), f"{images}/{name}.png")
    subprocess.run(["pdftoppm", "-png", "-singlefile", "-r", "28",
                    os.path.join(made, "pattern.pdf"), f"{images}/pattern"], check=True)


def draw_editor(folder, images):
    """The window, where it is built."""
    if not os.path.isfile(EDITOR):
        return
    session = os.path.join(folder, "session")
    os.makedirs(session, exist_ok=True)
    tests = ":".join(f"*.{name}" for name in EDITOR_SESSIONS)
    subprocess.run([EDITOR, f"--gtest_filter={tests}"], check=True,
                   env={**os.environ, "PATTERN_EDITOR_PICTURES": session})
    for name in ("drawing", "drawn", "stroke", "offset", "proposed"):
        write(scaled(read(os.path.join(session, name + ".png")), WINDOW_WIDTH),
              f"{images}/editor_{name}.png")


def draw_paraview(folder, images):
    """ParaView's window, where the plugin is built, worked as its test does."""
    root = os.path.dirname(HERE)
    build = os.environ.get("PARAVIEW_BUILD", os.path.join(root, "build-paraview"))
    if not os.path.isfile(os.path.join(build, "bin", "paraview")):
        print("paraview.png is not drawn:", build, "has no plugin")
        return
    home = os.path.join(folder, "paraview")
    os.makedirs(home, exist_ok=True)
    os.environ.update(FLATTENING_BINARY=build, FLATTENING_OUTPUT=home, FLATTENING_SOURCE=root)
    sys.path.insert(0, os.path.join(root, "Testing", "ParaView"))
    from TestWindow import ParaViewWindow
    picture = os.path.join(home, "window.png")
    window = ParaViewWindow(home, f"--script={os.path.join(HERE, 'paraview_window.py')}")
    try:
        window.do("click", "pqWelcomeDialog #buttonBox QPushButton=Close")
        window.do("size", "#pqClientMainWindow", width=1280, height=PARAVIEW_HEIGHT)
        window.do("click", "#pipelineBrowser", x=0.5, y=0.95)
        window.ask("picture", file=picture)
    finally:
        window.close()
    image = read(picture)
    write(scaled(image, PARAVIEW_WIDTH, above=image.GetDimensions()[1] - PARAVIEW_HEIGHT), f"{images}/paraview.png")


def draw_suggestion(folder, images):
    """What is proposed for a piece without curves."""
    picture = os.path.join(folder, "suggestions.png")
    result = os.path.join(folder, "suggestions")
    subprocess.run([COMMAND, "cut", f"{DATA}/wetsuit_upper_front.vtp", "--max-strain", "3%", "--quiet", "-o", result],
                   check=True)
    subprocess.run([COMMAND, "picture", result, "--quiet", "-o", picture], check=True)
    write(scaled(read(picture), WIDTH), f"{images}/suggestions.png")


def draw_shapes(folder, images):
    """Ten closed shapes and their pieces, a color for each."""
    drawn = []
    shapes.write(folder)
    for name in shapes.shapes():
        result = os.path.join(folder, "shape_" + name)
        picture = result + ".png"
        subprocess.run([COMMAND, "cut", f"{folder}/{name}.obj", "--max-strain", "5%", "--quiet", "-o", result], check=True)
        subprocess.run([COMMAND, "picture", result, "--color", "piece", "--quiet", "-o", picture], check=True)
        # Without the table below the drawings.
        drawn.append(scaled(read(picture), SHAPE_WIDTH, read(picture).GetDimensions()[1] * 17 // 100))
    rows = [appended(drawn[k:k + 2], 0) for k in range(0, len(drawn), 2)]
    write(appended(rows[::-1], 1), f"{images}/shapes.png")


def draw_sewn(folder, images):
    """The T-shirt, sewn again and drawn over its design."""
    picture = os.path.join(folder, "sewn.png")
    result = os.path.join(folder, "sewn")
    subprocess.run([COMMAND, "sew", f"{DATA}/tshirt.vtp", f"{DATA}/tshirt_curves.vtp", "--mode", "product",
                    "--quiet", "-o", result], check=True)
    subprocess.run([COMMAND, "picture", result, "--color", "distance", "--quiet", "-o", picture], check=True)
    write(scaled(read(picture), WIDTH), f"{images}/sewn.png")


def draw_materials(folder, images):
    """The T-shirt in a knit and in a woven cloth, side by side."""
    drawn = []
    for material in ("jersey", "twill"):
        picture = os.path.join(folder, f"{material}.png")
        run = subprocess.run(
            [COMMAND, "picture", f"{DATA}/tshirt.vtp", f"{DATA}/tshirt_curves.vtp", "--material", material,
             "--color", "stretch", "--quiet", "-o", picture], check=False)
        if run.returncode not in (0, 4):
            raise RuntimeError(f"wirewarp ended with {run.returncode} on the T-shirt in {material}")
        drawn.append(scaled(read(picture), WIDTH))
    write(appended(drawn, 0), f"{images}/materials.png")


def draw_pieces(folder, images):
    small, page = [], "# Pictures of the pieces\n"
    for name in PIECES:
        run = subprocess.run(
            [COMMAND, "picture", f"{DATA}/{name}.vtp", f"{DATA}/{name}_curves.vtp", "--color", "homogeneity",
             "--quiet", "-o", f"{images}/piece_{name}.png"],
            check=False)
        if run.returncode not in (0, 4):  # 4: a warning, which the picture shows
            raise RuntimeError(f"wirewarp ended with {run.returncode} on {name}")
        picture = read(f"{images}/piece_{name}.png")
        # Without the table and the legend below the drawings.
        small.append(scaled(picture, COLUMN_WIDTH, picture.GetDimensions()[1] * 17 // 100))
        page += f"\n## {name}\n\n![{PIECES[name]}](images/piece_{name}.png)\n"
    rows = [appended(small[k:k + COLUMNS], 0) for k in range(0, len(small), COLUMNS)]
    write(appended(rows[::-1], 1), f"{images}/gallery.png")
    with open(os.path.join(folder, "pages", "pieces.md"), "w", encoding="utf-8") as file:
        file.write(page)


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    folder = os.path.abspath(sys.argv[1])
    images = os.path.join(folder, "images")
    for made in (images, os.path.join(folder, "pages")):
        os.makedirs(made, exist_ok=True)
    run_tutorial(folder, images)
    draw_editor(folder, images)
    draw_paraview(folder, images)
    with open(os.path.join(images, "method.svg"), "w", encoding="utf-8") as file:
        file.write(method_drawing.drawing())
    draw_suggestion(folder, images)
    draw_shapes(folder, images)
    draw_sewn(folder, images)
    draw_materials(folder, images)
    draw_pieces(folder, images)


if __name__ == "__main__":
    main()
