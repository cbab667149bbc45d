# SPDX-License-Identifier: BSD-3-Clause
"""A command without VTK gives what another one gives: compare_commands.py FOLDER OWN COMMAND..."""

import json
import pathlib
import subprocess
import sys

PRECISION = 1e-9  # of the size of the pieces
SHEET = "# units: cm\n" + "".join(
    f"v {x} {y} {0.1 * x * x + 0.05 * x * y}\n" for y in range(9) for x in range(9)) + "".join(
    f"f {a} {a + 1} {a + 10}\nf {a} {a + 10} {a + 9}\n" for y in range(8) for a in range(9 * y + 1, 9 * y + 9))
CONE = "# units: cm\n" + "".join(
    f"v {x} {y} {(x - 4) ** 2 * 0.1 + (y - 4) ** 2 * 0.1}\n" for y in range(9) for x in range(9)) + SHEET[SHEET.index("f "):]
PIECES = {"Blatt": (SHEET, "key Mitte 36 44\n"), "Hügel 2": (CONE, "dart Abnäher 36 40\nkey Saum 0 1 2 3 4 5 6 7 8\n"),
          "Naht": (CONE, "seam Naht 36 44\n")}


def places(path):
    lines = path.read_text("utf-8").splitlines()
    return [[float(word) for word in line.split()[1:4]] for line in lines if line.startswith("v ")]


def run(command, words, folder):
    ran = subprocess.run([*command, *words], cwd=folder, capture_output=True, check=False)
    return ran.returncode, ran.stdout.decode("utf-8", "replace"), ran.stderr.decode("utf-8", "replace")


def main(folder, own, *other):
    folder = pathlib.Path(folder) / "Ärmel und Kragen"
    folder.mkdir(parents=True, exist_ok=True)
    worst = 0.0
    for name, (surface, curves) in PIECES.items():
        (folder / f"{name}.obj").write_text(surface, "utf-8")
        (folder / f"{name}.txt").write_text(curves, "utf-8")
        sides = []
        for place, command in (("hier", [own]), ("dort", other)):
            code, said, error = run(command, ["flatten", f"{name}.obj", f"{name}.txt", "-o", f"{name} {place}"], folder)
            assert code in (0, 1), f"{command}: {code}\n{said}{error}"
            sides.append((code, folder / f"{name} {place}"))
        (code, here), (code_there, there) = sides
        assert code == code_there, f"{name}: {code} and {code_there}"
        reports = [json.loads((side / "report.json").read_text("utf-8")) for side in (here, there)]
        flat = places_of(here), places_of(there)
        size = max(abs(value) for point in flat[0] for value in point)
        assert len(flat[0]) == len(flat[1]) > 0, name
        difference = max(abs(a - b) for p, q in zip(*flat) for a, b in zip(p, q)) / size
        worst = max(worst, difference)
        assert difference < PRECISION, f"{name}: {difference}"
        assert reports[0]["status"] == reports[1]["status"], name
        print(f"{name}: differences up to {difference:.1e}")
    for words, wanted in ((["flatten", "fehlt.obj"], "fehlt.obj"), (["flatten", "Blatt.vtp"], "Blatt.vtp"),
                          (["flatten", "Blatt.obj", "--scheme", "nein"], "nein")):
        code, said, error = run(other, words, folder)
        assert code > 1 and wanted in error, f"{words}: {code}\n{said}{error}"
    (folder / "Liste.txt").write_text("Blatt.obj\nNaht.obj\n", "utf-8")
    code, said, error = run(other, ["batch", "Liste.txt", "-o", "Stapel"], folder)
    assert code in (0, 1) and (folder / "Stapel" / "Naht").is_dir(), f"batch: {code}\n{said}{error}"
    print(f"{len(PIECES)} pieces, differences up to {worst:.1e}; refusals and the batch")


def places_of(folder):
    """Of flat.obj, or of flat.vtp of the command with VTK."""
    if (folder / "flat.obj").exists():
        return places(folder / "flat.obj")
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(folder / "flat.vtp"))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPoints().GetData()).tolist()


if __name__ == "__main__":
    main(*sys.argv[1:])
