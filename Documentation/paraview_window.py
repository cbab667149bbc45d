# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView's window shows in the README: the front of a shirt with its curves, flattened. Started by
make_pictures.py as `paraview --script`."""

import os

import paraview.simple as pv

DATA = os.path.join(os.environ["FLATTENING_SOURCE"], "Data")

surface, curves = (pv.OpenDataFile(os.path.join(DATA, name)) for name in
                   ("shirt_front.vtp", "shirt_front_curves.vtp"))
pv.RenameSource("shirt", surface)
pv.RenameSource("curves", curves)
view = pv.GetActiveViewOrCreate("RenderView")
view.UseColorPaletteForBackground = 0
view.Background = [1.0, 1.0, 1.0]
view.OrientationAxesLabelColor = [0.0, 0.0, 0.0]
flattening = pv.FlattenSurfaceWireWarping(registrationName="flat", Input=surface, Curves=curves)
for port in (0, 2):
    display = pv.Show(pv.OutputPort(flattening, port), view)
    pv.ColorBy(display, ("CELLS", "HomogeneityOfDistortion"))
    display.SetScalarBarVisibility(view, False)
pv.Show(pv.OutputPort(flattening, 1), view).SetScalarBarVisibility(view, True)
bar = pv.GetScalarBar(pv.GetColorTransferFunction("WireKind"), view)
bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
pv.SetActiveSource(flattening)
view.ResetActiveCameraToNegativeZ()
pv.Render(view)
