# SPDX-License-Identifier: BSD-3-Clause
"""The paper's Fig. 9 in four views: the upper front of a wetsuit in space, and its flat piece by the
progressive scheme, the global scheme and, for comparison, the least squares conformal map.

Wires have the colors of flat_beside.py. In the window: start ParaView with the plugin in the folder of the
project, or name that folder in the environment variable SURFACEFLATTENING, and run this with View > Python
Shell > Run Script or `paraview --script=Examples/ParaView/figure9.py`. Without a window:

    pvpython figure9.py --plugin SurfaceFlattening.so --png figure9.png
"""

import argparse
import os
import sys

import paraview.simple as pv

if "SURFACEFLATTENING" in os.environ:
    ROOT = os.environ["SURFACEFLATTENING"]
elif "__file__" in globals():
    ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
else:
    ROOT = os.getcwd()
sys.path.insert(0, os.path.join(ROOT, "Examples", "ParaView"))
from flat_beside import color_wires, show_flat  # noqa: E402, after the folder is known


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


def show_figure():
    files = [os.path.join(ROOT, "Data", name)
             for name in ("wetsuit_upper_front.vtp", "wetsuit_upper_front_curves.vtp")]
    for file in files:
        if not os.path.isfile(file):
            raise RuntimeError(f"no file {file}: set SURFACEFLATTENING to the folder of the project")
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
            # In front of the surface's edges; ParaView 5.13 has another name for it.
            moved = "Translation" if "Translation" in display.ListProperties() else "Position"
            setattr(display, moved, [0.0, 0.0, 0.3])
            color_wires(display, "CurveType")
        else:
            inputs = {"registrationName": scheme, "Input": surface, "Curves": curves}
            flat = (pv.LeastSquaresConformalMap(**inputs) if scheme == "Least squares conformal"
                    else pv.FlattenSurfaceWireWarping(**inputs, Scheme=scheme, DartLegs="Free"))
            show_flat(flat, view, preset="Flattening: homogeneity as in Fig. 9e of the paper")
        view.InteractionMode = "2D"
        pv.ResetCamera(view)
        view.CameraParallelScale *= 0.85  # as large as the title below allows
    pv.RenderAllViews()
    return layout


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--plugin", help="the plugin, where ParaView has not loaded it")
    parser.add_argument("--png", help="write a picture of the four views")
    options, _ = parser.parse_known_args()  # in the window the arguments are ParaView's own
    if options.plugin:
        pv.LoadPlugin(options.plugin, remote=False)
    if not hasattr(pv, "FlattenSurfaceWireWarping"):
        raise RuntimeError(
            "ParaView has not loaded the plugin SurfaceFlattening: start by build-paraview/bin/paraview or pvpython or "
            "by `surfaceflattening-paraview`, or name the plugin's file with --plugin")
    layout = show_figure()
    if options.png:
        layout.SetSize(1200, 1000)
        pv.SaveScreenshot(options.png, layout, ImageResolution=[1200, 1000])


main()
