# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window, worked by mouse and keys: a curve is picked, named, made a key, flattened, saved, loaded."""

import json
import os
import subprocess
import sys
import tempfile
import time
import unittest

BINARY = os.environ["FLATTENING_BINARY"]
OUTPUT = os.environ["FLATTENING_OUTPUT"]
SHIRT = os.path.join(os.environ["FLATTENING_SOURCE"], "Data", "shirt_front.vtp")
PATIENCE = 60.0
VIEW = "#Viewport"

# What a state brings back, as ParaView's Python computes it without the window.
LOOK = """
import json, sys
import paraview.simple as pv
from paraview import servermanager
pv.LoadState(sys.argv[1])
sources = {name: proxy for (name, _), proxy in pv.GetSources().items()}
curve, flattening = sources["SurfaceCurve1"], sources["FlattenSurfaceWireWarping1"]
flattening.UpdatePipeline()
flattening.UpdatePropertyInformation()
curves = servermanager.Fetch(flattening, idx=4)
def column(name):
    array = curves.GetColumnByName(name)
    return [array.GetValue(row) for row in range(array.GetNumberOfValues())]
print("found", json.dumps({
    "name": str(curve.Name), "key": curve.Type == "Key", "offset": curve.Offset, "points": list(curve.Points),
    "status": str(flattening.Status), "bounds": servermanager.Fetch(flattening).GetBounds(),
    "curves": {name: [kind, flat] for name, kind, flat in zip(
        column("Name"), column("Type"), column("FlatLength"))}}))
"""
CAMERA = """
import sys
import paraview.simple as pv
pv.LoadState(sys.argv[1])
view = pv.GetActiveViewOrCreate("RenderView")
sources = {name: proxy for (name, _), proxy in pv.GetSources().items()}
flattening = sources["FlattenSurfaceWireWarping1"]
flattening.UpdatePipeline()
low, high = [1e300] * 3, [-1e300] * 3
for port in range(3):
    bounds = pv.OutputPort(flattening, port).GetDataInformation().GetBounds()
    low = [min(a, b) for a, b in zip(low, bounds[::2])]
    high = [max(a, b) for a, b in zip(high, bounds[1::2])]
camera = view.GetActiveCamera()
matrix = camera.GetCompositeProjectionTransformMatrix(view.ViewSize[0] / view.ViewSize[1], -1, 1)
def seen(x):
    p = matrix.MultiplyPoint((*x, 1.0))
    return max(abs(p[0] / p[3]), abs(p[1] / p[3])) < 1.0
whole = all(seen((x, y, z)) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2]))
wires = pv.GetDisplayProperties(pv.OutputPort(flattening, 1), view)
print("whole", whole, "wide", wires.LineWidth == 3.0)
"""


class ParaViewWindow:
    """The program of a user who never started it before."""

    def __init__(self, home, *words):
        environment = {**os.environ, "HOME": home, "XDG_CONFIG_HOME": home,
                       "QT_PLUGIN_PATH": os.path.join(BINARY, "Testing", "ParaView"),
                       "QT_QPA_GENERIC_PLUGINS": "WindowDriver", "QT_QPA_PLATFORM": "xcb"}
        self.said = open(os.path.join(home, "said.txt"), "w+", encoding="utf-8")
        self.process = subprocess.Popen(
            [os.path.join(BINARY, "bin", "paraview"), *words], env=environment, text=True,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.said)

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.communicate()
            self.said.close()

    def ask(self, what, widget="", **more):
        self.process.stdin.write(json.dumps({"do": what, "widget": widget, **more}) + "\n")
        self.process.stdin.flush()
        for line in self.process.stdout:
            if line.startswith("answer "):
                return json.loads(line[len("answer "):])
        self.said.seek(0)
        raise AssertionError("ParaView ended: " + self.said.read())

    def do(self, what, widget="", **more):
        if widget:
            self.wait(widget)
        said = self.ask(what, widget, **more)
        if said["wrong"]:
            self.ask("picture", file=os.path.join(OUTPUT, "window_stuck.png"))
            raise AssertionError(f"{what} {widget} {more}: {said['wrong']}")

    def wait(self, widget, **values):
        """For a widget on the screen, with these values of its properties."""
        end = time.monotonic() + PATIENCE
        while True:
            found = {name: self.ask("look", widget, property=name) for name in (values or ["visible"])}
            if all(not answer["wrong"] and answer["value"] == values.get(name, True)
                   for name, answer in found.items()):
                return
            if time.monotonic() > end:
                self.ask("picture", file=os.path.join(OUTPUT, "window_stuck.png"))
                raise AssertionError(f"waited in vain for {widget} {values}: {found}")
            time.sleep(0.05)

    def menu(self, *entries, opens=False):
        self.do("menu", "QMenuBar#menubar", entries=entries, opens=opens)

    def apply(self):
        self.wait("#propertiesDock #Accept", enabled=True)
        self.do("click", "#propertiesDock #Accept")
        self.wait("#propertiesDock #Accept", enabled=False)

    def choose(self, box, row):
        self.do("click", box)
        self.do("click", "QComboBoxPrivateContainer QListView", row=row)
        self.wait(box, currentText=row)

    def fill(self, line, text):
        self.do("double", line)  # takes what stands there
        self.do("press", keys="Ctrl+A")
        self.do("type", text=text)
        self.wait(line, text=text)

    def pick(self, x, y, key):
        self.do("click", VIEW, x=x, y=y)  # the view gets the keyboard
        self.do("press", keys=key)

    def file(self, entry, path):
        self.menu("File", entry, opens=True)
        self.fill("pqFileDialog #EntityName", path)
        self.do("click", "pqFileDialog #OK", opens=True)

    def rest(self):
        """Until the program has done what dialogs asked for."""
        end = time.monotonic() + PATIENCE
        while self.ask("look", "#pqClientMainWindow")["opened"]:
            if time.monotonic() > end:
                raise AssertionError("a dialog stays open, or its work is not done")
            time.sleep(0.05)

    def save_state(self, path):
        self.file("Save State...", path)
        self.rest()


class Window(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def start(self, *words):
        window = ParaViewWindow(tempfile.mkdtemp(dir=self.folder.name), *words)
        self.addCleanup(window.close)
        window.do("click", "pqWelcomeDialog #buttonBox QPushButton=Close")
        window.do("size", "#pqClientMainWindow", width=1270, height=1000)
        return window

    def run_program(self, text, state):
        program = os.path.join(self.folder.name, "program.py")
        with open(program, "w", encoding="utf-8") as file:
            file.write(text)
        return subprocess.run([os.path.join(BINARY, "bin", "pvpython"), program, state],
                              capture_output=True, text=True, check=False)

    def look(self, state):
        run = self.run_program(LOOK, state)
        lines = [line for line in run.stdout.splitlines() if line.startswith("found ")]
        self.assertTrue(lines, run.stdout + run.stderr)
        return json.loads(lines[0][len("found "):])

    def test_a_curve_is_picked_named_made_a_key_applied_saved_and_loaded(self):
        window, first, second, third = self.start("--data=" + SHIRT), *(
            os.path.join(self.folder.name, name + ".pvsm") for name in ("first", "second", "third"))
        window.apply()

        window.menu("Filters", "Surface Flattening", "Surface Curve")
        window.wait("#InteractivePolyLine #PointsTable")
        window.pick(0.34, 0.38, "1")
        window.pick(0.50, 0.42, "2")
        window.do("click", "#InteractivePolyLine #Add")
        window.pick(0.66, 0.38, "P")
        window.fill("pqLineEdit#CurveName", "bust line")
        window.choose("#CurveType QComboBox", "Key")
        window.apply()
        window.ask("picture", file=os.path.join(OUTPUT, "window_curve.png"))

        window.do("click", "#pipelineBrowser", x=0.5, y=0.95)
        window.do("press", keys="Up")  # from the curve to its surface
        window.menu("Filters", "Surface Flattening", "first: Flatten Surface (Wire Warping)")
        window.choose("#Curves QComboBox", "SurfaceCurve1")
        window.apply()
        window.ask("picture", file=os.path.join(OUTPUT, "window_flat.png"))
        window.save_state(first)
        # The camera sees surface and pieces whole, with wires of 3 pixels.
        self.assertIn("whole True wide True", self.run_program(CAMERA, first).stdout)
        window.close()

        # Another day, and another window.
        window = self.start()
        window.file("Load State...", first)
        window.do("click", "pqProxyWidgetDialog QPushButton=OK", opens=True)  # how files are found
        window.rest()
        window.do("click", "#pipelineBrowser", x=0.5, y=0.95)
        for key in ("Home", "Down", "Down"):  # the server, the surface, the curve
            window.do("press", keys=key)
        window.wait("pqLineEdit#CurveName", text="bust line")
        window.wait("#CurveType QComboBox", currentText="Key")
        window.ask("picture", file=os.path.join(OUTPUT, "window_loaded.png"))
        window.save_state(second)
        picked, loaded = self.look(first), self.look(second)
        self.assertEqual((picked["name"], picked["key"], picked["offset"]), ("bust line", True, 0.0))
        self.assertEqual(len(picked["points"]), 9)
        self.assertEqual(picked["status"], "Ok")
        kind, length = picked["curves"]["bust line"]
        self.assertEqual(kind, "key")
        self.assertEqual(loaded, picked)

        # The curve 2 cm to its left has another length, through the same picks.
        window.fill("#Offset pqDoubleLineEdit", "2")
        window.apply()
        window.ask("picture", file=os.path.join(OUTPUT, "window_offset.png"))
        window.save_state(third)
        moved = self.look(third)
        self.assertEqual((moved["offset"], moved["points"], moved["status"]), (2.0, picked["points"], "Ok"))
        self.assertNotAlmostEqual(moved["curves"]["bust line"][1], length, 3)


if __name__ == "__main__":
    sys.exit(unittest.main())
