# SPDX-License-Identifier: BSD-3-Clause
"""The paper's Fig. 9 in four views: the upper front of a wetsuit in space, and its flat piece by the
progressive scheme, the global scheme and, for comparison, the least squares conformal map.

Flat pieces are coloured by the homogeneity of distortion, blue where ideal, red where a triangle grew
or shrank to half its area. Outlines are black, accessory curves green, key curves red, darts blue.

In the window: start ParaView with the plugin in the folder that holds Data, or with the path of Data in
SURFACEFLATTENING_DATA, and run this with View > Python Shell > Run Script, keep it with Macros > Import
New Macro, or `paraview --script=Examples/ParaView/figure9.py`. Without a window:

    pvpython figure9.py --plugin SurfaceFlattening.so --png figure9.png
"""

import argparse
import os

import paraview.simple as pv

WIRE_COLORS = {  # CurveType: name and colour
    -1: ("boundary", (0.0, 0.0, 0.0)),
    0: ("accessory", (0.0, 0.6, 0.1)),
    1: ("key", (0.85, 0.0, 0.0)),
    2: ("dart", (0.0, 0.2, 0.9)),
    3: ("seam", (0.6, 0.0, 0.75)),
}


def data_folder():
    if "SURFACEFLATTENING_DATA" in os.environ:
        return os.environ["SURFACEFLATTENING_DATA"]
    if "__file__" in globals():
        return os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
    return "Data"


def color_wires(display):
    """Colours of the array CurveType, as categories."""
    pv.ColorBy(display, ("CELLS", "CurveType"))
    colors = pv.GetColorTransferFunction("CurveType")
    colors.InterpretValuesAsCategories = 1
    colors.AnnotationsInitialized = 1
    colors.Annotations = [text for value, (name, _) in WIRE_COLORS.items() for text in (str(value), name)]
    colors.IndexedColors = [part for _, color in WIRE_COLORS.values() for part in color]
    display.LineWidth = 3
    display.Ambient, display.Diffuse = 1.0, 0.0


def color_homogeneity(display):
    """Blue at 1 to red at 0.5, as in Fig. 9e."""
    pv.ColorBy(display, ("CELLS", "HomogeneityOfDistortion"))
    colors = pv.GetColorTransferFunction("HomogeneityOfDistortion")
    colors.RGBPoints = [0.5, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0]
    colors.ColorSpace = "HSV"
    colors.AutomaticRescaleRangeMode = "Never"
    display.Ambient, display.Diffuse = 1.0, 0.0


def make_view(layout, cell, title):
    view = pv.CreateRenderView()
    pv.AssignViewToLayout(view=view, layout=layout, hint=cell)
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    text = pv.Text(registrationName=f"{title} (title)", Text=title)
    display = pv.Show(text, view)
    display.Color = [0.0, 0.0, 0.0]
    display.WindowLocation = "Lower Center"
    return view


def look_at(view):
    """Straight from the front, as large as the title below allows."""
    view.InteractionMode = "2D"
    pv.ResetCamera(view)
    view.CameraParallelScale *= 0.85


def show_figure():
    data = data_folder()
    files = [os.path.join(data, name)
             for name in ("wetsuit_upper_front.vtp", "wetsuit_upper_front_curves.vtp")]
    for file in files:
        if not os.path.isfile(file):
            raise RuntimeError(f"no file {file}: set SURFACEFLATTENING_DATA to the folder Data")
    surface = pv.XMLPolyDataReader(registrationName="Wetsuit", FileName=[files[0]])
    curves = pv.XMLPolyDataReader(registrationName="Feature curves", FileName=[files[1]])
    for reader in (surface, curves):
        reader.TimeArray = "None"

    layout = pv.CreateLayout(name="Fig. 9")
    pv.SetActiveView(None)
    left = layout.SplitHorizontal(0, 0.5)
    # The second part of a split has the number after the first one's.
    columns = [layout.SplitVertical(half, 0.5) for half in (left, left + 1)]
    places = (columns[0], columns[1], columns[0] + 1, columns[1] + 1)
    for scheme, place in zip((None, "Progressive", "Global", "Least squares conformal"), places):
        view = make_view(layout, place, scheme or "In space")
        if scheme is None:
            display = pv.Show(surface, view)
            display.ColorArrayName = ["POINTS", ""]
            display.AmbientColor = display.DiffuseColor = [0.86, 0.86, 0.83]
            display = pv.Show(curves, view)
            display.Position = [0.0, 0.0, 0.3]  # in front of the surface's edges
            color_wires(display)
        else:
            flat = pv.WireWarping(
                registrationName=scheme, Input=surface, Curves=curves, Scheme=scheme)
            color_homogeneity(pv.Show(pv.OutputPort(flat, 0), view))
            color_wires(pv.Show(pv.OutputPort(flat, 1), view))
        look_at(view)
    pv.RenderAllViews()
    return layout


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--plugin", help="the plugin, where ParaView has not loaded it")
    parser.add_argument("--png", help="write a picture of the four views")
    options, _ = parser.parse_known_args()  # in the window the arguments are ParaView's own
    if options.plugin:
        pv.LoadPlugin(options.plugin, remote=False)
    layout = show_figure()
    if options.png:
        layout.SetSize(1200, 1000)
        pv.SaveScreenshot(options.png, layout, ImageResolution=[1200, 1000])


main()
