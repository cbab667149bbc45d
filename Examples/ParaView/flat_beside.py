# SPDX-License-Identifier: BSD-3-Clause
"""Shows the flat pieces of a Wire Warping filter in a view of their own, beside the surface.

In ParaView's window: keep this with Macros > Import New Macro; select an applied filter and call it.

Surface and pieces are coloured by the homogeneity of distortion, blue where ideal, red where a triangle
grew or shrank to half its area. Outlines are black, accessory curves green, key curves red, darts blue,
seams violet.
"""

import paraview.simple as pv

WIRE_COLORS = {  # CurveType: name and colour
    -1: ("boundary", (0.0, 0.0, 0.0)),
    0: ("accessory", (0.0, 0.6, 0.1)),
    1: ("key", (0.85, 0.0, 0.0)),
    2: ("dart", (0.0, 0.2, 0.9)),
    3: ("seam", (0.6, 0.0, 0.75)),
}


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
    """Blue at 1 to red at 0.5, as in Fig. 9e of the paper."""
    pv.ColorBy(display, ("CELLS", "HomogeneityOfDistortion"))
    colors = pv.GetColorTransferFunction("HomogeneityOfDistortion")
    colors.RGBPoints = [0.5, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0]
    colors.ColorSpace = "HSV"
    colors.AutomaticRescaleRangeMode = "Never"
    display.Ambient, display.Diffuse = 1.0, 0.0


def show_flat(flattening, view):
    """Flat pieces and wires in a view that looks at the plane."""
    color_homogeneity(pv.Show(pv.OutputPort(flattening, 0), view))
    color_wires(pv.Show(pv.OutputPort(flattening, 1), view))
    view.InteractionMode = "2D"
    pv.ResetCamera(view)


def show_beside(flattening):
    """Splits the active view: the cut surface stays, the flat pieces get the right half."""
    if flattening is None or flattening.GetXMLName() not in ("WireWarping", "LeastSquaresConformalMap"):
        raise RuntimeError("select a Wire Warping filter first")
    space = pv.GetActiveViewOrCreate("RenderView")
    for port in (0, 1):
        pv.Hide(pv.OutputPort(flattening, port), space)
    pv.Hide(flattening.Input, space)
    color_homogeneity(pv.Show(pv.OutputPort(flattening, 2), space))
    if pv.GetLayout(space) is None:  # without a window a view has none
        pv.AssignViewToLayout(view=space)
    layout = pv.GetLayout(space)
    left = layout.SplitHorizontal(layout.GetViewLocation(space), 0.5)
    plane = pv.CreateRenderView()
    pv.AssignViewToLayout(view=plane, layout=layout, hint=left + 1)
    show_flat(flattening, plane)
    pv.RenderAllViews()
    return space, plane


if __name__ in ("__main__", "__vtkconsole__"):  # the latter is the name that ParaView runs macros under
    show_beside(pv.GetActiveSource())
