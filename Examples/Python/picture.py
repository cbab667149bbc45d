# SPDX-License-Identifier: BSD-3-Clause
"""Flat pieces side by side on white ground, written as a PNG file without opening a window."""

import os
import sys
from typing import List, Optional, Tuple

import vtkmodules.vtkRenderingFreeType  # noqa: F401 - draws the titles
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 - draws everything else
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter)

BLACK, GREEN, RED, BLUE, PURPLE = (0, 0, 0), (0, 0.6, 0.1), (0.85, 0, 0), (0, 0.2, 0.9), (0.6, 0, 0.75)
# By the array CurveType: boundary, accessory, key, dart, seam.
WIRE_COLORS = {-1: BLACK, 0: GREEN, 1: RED, 2: BLUE, 3: PURPLE}


def blue_to_red(low: float, high: float) -> vtkLookupTable:
    """Colours from blue at low to red at high; low may be the larger."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetHueRange(*((2 / 3, 0) if low < high else (0, 2 / 3)))
    table.SetRampToLinear()
    table.SetTableRange(min(low, high), max(low, high))
    table.Build()
    return table


def _wire_colors() -> vtkLookupTable:
    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(WIRE_COLORS))
    table.SetTableRange(-1.5, 3.5)
    for index, color in enumerate(WIRE_COLORS.values()):
        table.SetTableValue(index, *color, 1)
    return table


class Picture:
    """Panels in a row, all in one scale, so that sizes compare."""

    def __init__(self, width: int = 1200, height: int = 800) -> None:
        if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
            sys.exit("Debian's VTK draws through an X server, and DISPLAY names none: "
                     "run this with xvfb-run")
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetSize(width, height)
        self.window.SetMultiSamples(4)
        self.panels: List[Tuple[vtkRenderer, Tuple[float, ...]]] = []

    def add(self, flat: vtkPolyData, wires: vtkPolyData, title: str, array: Optional[str] = None,
            low: float = 0.0, high: float = 1.0) -> None:
        """One more panel: outputs 0 and 1 of the filter, the pieces coloured by a cell array."""
        renderer = vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(flat)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetColor(0.9, 0.9, 0.87)
        mapper.ScalarVisibilityOff()
        if array:
            mapper.ScalarVisibilityOn()
            mapper.SetScalarModeToUseCellFieldData()
            mapper.SelectColorArray(array)
            mapper.SetLookupTable(blue_to_red(low, high))
            mapper.UseLookupTableScalarRangeOn()
        renderer.AddActor(actor)

        mapper = vtkPolyDataMapper()
        mapper.SetInputData(wires)
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray("CurveType")
        mapper.SetLookupTable(_wire_colors())
        mapper.UseLookupTableScalarRangeOn()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetLineWidth(2)
        actor.SetPosition(0, 0, 1e-3 * flat.GetLength())  # above the triangles
        renderer.AddActor(actor)

        text = vtkTextActor()
        text.SetInput(title)
        text.SetPosition(12, 12)
        text.GetTextProperty().SetColor(BLACK)
        text.GetTextProperty().SetFontSize(16)
        renderer.AddActor(text)
        self.window.AddRenderer(renderer)
        self.panels.append((renderer, flat.GetBounds()))

    def write(self, path: str) -> None:
        """Draws the panels into a PNG file."""
        count = len(self.panels)
        width, height = self.window.GetSize()
        scale = 0.0
        for index, (renderer, bounds) in enumerate(self.panels):
            renderer.SetViewport(index / count, 0, (index + 1) / count, 1)
            x, y = bounds[1] - bounds[0], bounds[3] - bounds[2]
            scale = max(scale, y, x * height * count / width)
        for renderer, bounds in self.panels:
            camera = renderer.GetActiveCamera()
            camera.ParallelProjectionOn()
            center = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2]
            center[1] -= 0.06 * scale  # room for the title
            camera.SetFocalPoint(*center, 0)
            camera.SetPosition(*center, scale)
            camera.SetParallelScale(0.6 * scale)
            renderer.ResetCameraClippingRange()
        self.window.Render()
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(self.window)
        grabber.ReadFrontBufferOff()
        writer = vtkPNGWriter()
        writer.SetInputConnection(grabber.GetOutputPort())
        writer.SetFileName(path)
        writer.Write()
        if writer.GetErrorCode():
            sys.exit(f"cannot write {path}")
