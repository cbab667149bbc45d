# SPDX-License-Identifier: BSD-3-Clause
"""Screenshots equal the baselines, and a wrong one would not."""

import os
import runpy
import shutil
import subprocess
import sys
import unittest

import numpy as np
import paraview.simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from plugin import OUTPUT, PLUGIN, SOURCE, fetch, main, read

sys.path.insert(0, os.path.join(SOURCE, "Examples", "ParaView"))
from flat_beside import show_beside  # noqa: E402  - it lies in another folder

BASELINES = os.path.join(SOURCE, "Testing", "Data", "Baseline")
# Edges of lines may fall on other pixels with another OpenGL; areas may not.
LARGEST_DIFFERENCE = 48
SHARE_OF_PIXELS = 0.005


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    colors = vtk_to_numpy(image.GetPointData().GetScalars())
    return colors[:, :3].astype(int).reshape(image.GetDimensions()[1], image.GetDimensions()[0], 3)


def different(path, baseline):
    """Share of the pixels that differ."""
    one, other = pixels(path), pixels(baseline)
    if one.shape != other.shape:
        return 1.0
    return (np.abs(one - other).max(axis=2) > LARGEST_DIFFERENCE).mean()


class Pictures(unittest.TestCase):
    def compare(self, name):
        path, baseline = os.path.join(OUTPUT, name), os.path.join(BASELINES, name)
        if os.environ.get("FLATTENING_WRITE_BASELINES"):
            shutil.copy(path, baseline)
            self.fail(f"{baseline} was written anew: look at it, and run the test without that")
        self.assertLess(different(path, baseline), SHARE_OF_PIXELS, path)

    def new_file(self, name):
        """The path of a picture that no earlier run has left there."""
        path = os.path.join(OUTPUT, name)
        if os.path.exists(path):
            os.remove(path)
        return path

    def screenshot(self, name, scheme):
        inputs = {"Input": read("shirt_front"), "Curves": read("shirt_front_curves")}
        flattening = (pv.FlattenSurfaceWireWarping(**inputs, Scheme=scheme, DartLegs="Free") if scheme
                      else pv.LeastSquaresConformalMap(**inputs))
        view = pv.CreateView("RenderView")
        view.ViewSize = [500, 600]
        view.UseColorPaletteForBackground = 0
        view.Background = [1, 1, 1]
        view.OrientationAxesVisibility = 0
        display = pv.Show(pv.OutputPort(flattening, 0), view)
        pv.ColorBy(display, ("CELLS", "HomogeneityOfDistortion"))
        colors = pv.GetColorTransferFunction("HomogeneityOfDistortion")
        colors.RescaleTransferFunction(0.5, 1.0)
        display.Ambient, display.Diffuse = 1.0, 0.0
        wires = pv.Show(pv.OutputPort(flattening, 1), view)
        wires.ColorArrayName = ["CELLS", ""]
        wires.AmbientColor = wires.DiffuseColor = [0, 0, 0]
        wires.LineWidth = 3
        view.InteractionMode = "2D"
        pv.ResetCamera(view)
        path = self.new_file(name)
        pv.SaveScreenshot(path, view)
        return path

    def test_a_flat_piece(self):
        self.screenshot("TestParaViewPlugin.png", "Global")
        self.compare("TestParaViewPlugin.png")

    def test_a_wrong_picture_fails(self):
        path = self.screenshot("wrong.png", None)
        baseline = os.path.join(BASELINES, "TestParaViewPlugin.png")
        self.assertGreater(different(path, baseline), 2 * SHARE_OF_PIXELS)

    def test_the_four_views_of_figure_9(self):
        path = self.new_file("TestParaViewFigure9.png")
        run = subprocess.run(
            [os.environ["PVPYTHON"], os.path.join(SOURCE, "Examples", "ParaView", "figure9.py"),
             "--plugin", PLUGIN, "--png", path],
            stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.compare("TestParaViewFigure9.png")

    def test_flat_pieces_beside_the_surface(self):
        flattening = pv.FlattenSurfaceWireWarping(
            Input=read("shirt_front"), Curves=read("shirt_front_curves"), Scheme="Global",
            DartLegs="Free")
        pv.SetActiveView(pv.CreateView("RenderView"))
        pv.Show(flattening.Input)
        space, plane = show_beside(flattening)
        self.assertEqual(pv.GetLayout(space), pv.GetLayout(plane))
        ports = {view: {(display.Input.SMProxy, display.Input.Port)
                        for display in view.Representations
                        if display.Visibility and display.GetProperty("Input")}  # no legends
                 for view in (space, plane)}
        self.assertEqual(ports[space], {(flattening.SMProxy, 2)})
        self.assertEqual(ports[plane], {(flattening.SMProxy, 0), (flattening.SMProxy, 1)})
        with self.assertRaisesRegex(RuntimeError, "select"):
            show_beside(flattening.Input)

    def test_the_surface_is_in_the_middle_with_its_curves_colored_and_the_legend_below(self):
        curves = read("shirt_front_curves")
        flattening = pv.FlattenSurfaceWireWarping(Input=read("shirt_front"), Curves=curves)
        view = pv.CreateView("RenderView")
        pv.SetActiveView(view)
        drawn = pv.Show(curves, view)
        pv.Show(flattening, view)  # beside the surface
        pv.ResetCamera(view)
        space, plane = show_beside(flattening)
        low, high = (fetch(flattening, 2).GetBounds()[k::2] for k in (0, 1))
        for axis in (0, 1):
            self.assertAlmostEqual(
                space.CameraFocalPoint[axis], (low[axis] + high[axis]) / 2, delta=0.02 * (high[axis] - low[axis]))
        self.assertEqual(list(drawn.ColorArrayName), ["CELLS", "CurveType"])
        bar = pv.GetScalarBar(pv.GetColorTransferFunction("HomogeneityOfDistortion"), plane)
        self.assertEqual((bar.Visibility, bar.Orientation), (1, "Horizontal"))

    def test_connectors_are_drawn_thinner_than_wires(self):
        surface = read("shirt_front")
        cut = fetch(pv.FlattenSurfaceWireWarping(Input=surface), 2)
        ends = [cut.GetPoint(cut.GetCell(700).GetPointId(k)) for k in range(2)]
        loose = pv.Line(Point1=ends[0], Point2=ends[1])  # a wire far from the others
        flattening = pv.FlattenSurfaceWireWarping(Input=surface, Curves=loose)
        pv.SetActiveView(pv.CreateView("RenderView"))
        _, plane = show_beside(flattening)
        widths = {}
        for display in plane.Representations:
            if display.GetProperty("Input") and display.ColorArrayName[1] == "WireKind":
                kinds = display.Input.GetCellDataInformation().GetArray("WireKind").GetRange()
                widths[kinds[0]] = display.LineWidth
        self.assertEqual(set(widths), {-2, -1})
        self.assertGreaterEqual(widths[-1], 3 * widths[-2])

    def test_the_macro_shows_the_pieces_of_the_active_source(self):
        flattening = pv.FlattenSurfaceWireWarping(Input=read("shirt_front"), Curves=read("shirt_front_curves"))
        pv.SetActiveView(pv.CreateView("RenderView"))
        pv.SetActiveSource(flattening)
        before = len(pv.GetViews())
        # As ParaView's window runs it: pqPythonMacroSupervisor, the shell's module.
        runpy.run_path(os.path.join(SOURCE, "Examples", "ParaView", "flat_beside.py"),
                       run_name="__vtkconsole__")
        self.assertEqual(len(pv.GetViews()), before + 1)


if __name__ == "__main__":
    main()
