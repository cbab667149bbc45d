# SPDX-License-Identifier: BSD-3-Clause
"""Shows the flat pieces of a Wire Warping filter in a view of their own, beside the surface.

In ParaView's window: Macros > Import New Macro keeps this file in the menu; select an applied filter and call it there.

Surface and pieces are colored by the homogeneity of distortion, light where ideal, dark where a triangle
grew or shrank to half its area. Outlines are black, accessory curves green, key curves red, darts blue,
seams violet; connectors, which join loose curves and keep no length, thin and grey. The pieces of a
collection's blocks lie beside each other.
"""

import paraview.simple as pv

WIRE_COLORS = {  # WireKind or CurveType: name and color
    -2: ("connector", (0.7, 0.7, 0.7)),
    -1: ("boundary", (0.0, 0.0, 0.0)),
    0: ("accessory", (0.0, 0.6, 0.1)),
    1: ("key", (0.85, 0.0, 0.0)),
    2: ("dart", (0.0, 0.2, 0.9)),
    3: ("seam", (0.6, 0.0, 0.75)),
}


def color_wires(display, array="WireKind"):
    """Colors of an array of types, as categories."""
    pv.ColorBy(display, ("CELLS", array))
    colors = pv.GetColorTransferFunction(array)
    colors.InterpretValuesAsCategories = 1
    colors.AnnotationsInitialized = 1
    colors.Annotations = [text for value, (name, _) in WIRE_COLORS.items() for text in (str(value), name)]
    colors.IndexedColors = [part for _, color in WIRE_COLORS.values() for part in color]
    display.LineWidth = 3
    display.Ambient, display.Diffuse = 1.0, 0.0


def color_homogeneity(display, preset="Flattening: homogeneity and aspect ratio, 0.5 to 1"):
    """By a preset of the plugin, with the preset's range."""
    pv.ColorBy(display, ("CELLS", "HomogeneityOfDistortion"))
    colors = pv.GetColorTransferFunction("HomogeneityOfDistortion")
    colors.AutomaticRescaleRangeMode = "Never"
    colors.ApplyPreset(preset, False)
    display.Ambient, display.Diffuse = 1.0, 0.0


def show_wires(flattening, view):
    """The wires; connectors apart, where there are any, since they are drawn thinner."""
    wires = pv.OutputPort(flattening, 1)
    kinds = wires.GetDataInformation().GetCellDataInformation().GetArrayInformation("WireKind")
    lowest, highest = kinds.GetComponentRange(0) if kinds else (0, 0)
    if lowest > -2:
        color_wires(pv.Show(wires, view))
        return
    for name, low, high, width in (("Connectors", -2, -2, 1), ("Wires", -1, max(highest, -1), 3)):
        part = pv.Threshold(registrationName=name, Input=wires, Scalars=["CELLS", "WireKind"],
                            LowerThreshold=low, UpperThreshold=high)
        display = pv.Show(part, view)
        color_wires(display)
        display.LineWidth = width


def show_flat(flattening, view, **colors):
    """Flat pieces and wires in a view that looks at the plane."""
    color_homogeneity(pv.Show(pv.OutputPort(flattening, 0), view), **colors)
    show_wires(flattening, view)
    view.InteractionMode = "2D"
    pv.ResetCamera(view)


def color_drawn_curves(view):
    """Those that are seen in the view get the colors of their types."""
    for display in list(view.Representations):
        if not display.GetProperty("Input") or not display.Visibility:
            continue
        arrays = display.Input.GetDataInformation().GetCellDataInformation()
        if arrays.GetArrayInformation("CurveType"):
            color_wires(display, "CurveType")
            display.SetScalarBarVisibility(view, False)


def show_legend(display, view):
    """Below the pieces, which are about as wide as the view."""
    display.SetScalarBarVisibility(view, True)
    bar = pv.GetScalarBar(pv.GetColorTransferFunction("HomogeneityOfDistortion"), view)
    bar.Title = "homogeneity"
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Lower Center"
    bar.RangeLabelFormat = "%.1f"
    view.CameraParallelScale *= 1.35  # room for it


def show_beside(flattening):
    """Splits the active view: the cut surface stays, the flat pieces get the right half."""
    if not hasattr(pv, "FlattenSurfaceWireWarping"):
        raise RuntimeError("ParaView has not loaded the plugin SurfaceFlattening: start it by "
                           "build-paraview/bin/paraview or surfaceflattening-paraview, or Tools > Manage Plugins")
    if flattening is None or flattening.GetXMLName() not in ("WireWarping", "LeastSquaresConformalMap"):
        raise RuntimeError("select a Wire Warping filter first")
    space = pv.GetActiveViewOrCreate("RenderView")
    for port in (0, 1):
        pv.Hide(pv.OutputPort(flattening, port), space)
    pv.Hide(flattening.Input, space)
    color_homogeneity(pv.Show(pv.OutputPort(flattening, 2), space))
    color_drawn_curves(space)
    pv.ResetCamera(space)  # the flat pieces lay beside the surface
    if pv.GetLayout(space) is None:  # without a window a view has none
        pv.AssignViewToLayout(view=space)
    layout = pv.GetLayout(space)
    left = layout.SplitHorizontal(layout.GetViewLocation(space), 0.5)
    plane = pv.CreateRenderView()
    pv.AssignViewToLayout(view=plane, layout=layout, hint=left + 1)
    show_flat(flattening, plane)
    show_legend(pv.GetDisplayProperties(pv.OutputPort(flattening, 0), plane), plane)
    pv.SetActiveSource(flattening)
    pv.RenderAllViews()
    return space, plane


if __name__ in ("__main__", "__vtkconsole__"):  # the latter is the name that ParaView runs macros under
    show_beside(pv.GetActiveSource())
