# SPDX-License-Identifier: BSD-3-Clause
"""The scripts that build-paraview-plugin names start ParaView's Python with the plugin, from anywhere."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

BIN = os.path.join(os.environ["FLATTENING_BINARY"], "bin")
PROGRAM = """
import paraview.simple as pv
print("made", pv.FlattenSurfaceWireWarping().GetXMLName())
"""


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


class Start(unittest.TestCase):
    def test_python_finds_the_plugin(self):
        # As a user's shell is, which knows of no ParaView.
        environment = {name: value for name, value in os.environ.items()
                       if name not in ("PYTHONPATH", "PV_PLUGIN_CONFIG_FILE")}
        with tempfile.TemporaryDirectory() as folder:
            script = write(folder, "script.py", PROGRAM)
            for program in ("pvpython", "pvbatch"):
                run = subprocess.run([os.path.join(BIN, program), script], env=environment, cwd=folder,
                                     capture_output=True, text=True, check=False)
                self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
                self.assertIn("made WireWarping", run.stdout)

    def run_without_plugin(self, program, *words, folder=None):
        """What ParaView's own Python says, started as if there were no plugin."""
        environment = {name: value for name, value in os.environ.items() if name != "PV_PLUGIN_CONFIG_FILE"}
        paths = [os.environ["PARAVIEW_PYTHONPATH"], *([folder] if folder else [])]
        run = subprocess.run([program, *words], env={**environment, "PYTHONPATH": os.pathsep.join(paths)},
                             capture_output=True, text=True, check=False)
        self.assertGreater(run.returncode, 0, run.stdout + run.stderr)  # less than 0: a signal
        return run.stderr

    def test_examples_say_where_the_plugin_is_not_loaded(self):
        examples = os.path.join(os.environ["FLATTENING_SOURCE"], "Examples", "ParaView")
        for program, name, words in (("PVBATCH", "flatten_collection.py", ("a.vtm", "b.vtm")),
                                     ("PVPYTHON", "figure9.py", ()), ("PVPYTHON", "flat_beside.py", ())):
            with self.subTest(name):
                said = self.run_without_plugin(os.environ[program], os.path.join(examples, name), *words)
                self.assertIn("not loaded the plugin SurfaceFlattening", said)
                self.assertIn("build-paraview/bin/", said)

    def test_the_package_for_another_vtk_says_so_in_paraviews_python(self):
        package = os.path.join(os.environ["FLATTENING_SOURCE"], "Wrapping", "Python", "surfaceflattening")
        with tempfile.TemporaryDirectory() as folder:
            copy = os.path.join(folder, "surfaceflattening")
            shutil.copytree(package, copy)
            write(copy, "_version.py", '__version__, BUILT_FOR, BUILT_WITH_VTK = "1", "Python 3 with VTK 8.90", "8.90.0"\n')
            script = write(folder, "script.py", "import surfaceflattening\n")
            said = self.run_without_plugin(os.environ["PVPYTHON"], script, folder=folder)
        self.assertIn("this is VTK 9.", said)
        self.assertIn("paraview.simple", said)

    def test_a_plugin_that_is_not_there_is_told(self):
        with tempfile.TemporaryDirectory() as prefix:
            self.install(prefix)
            for folder, _, files in os.walk(prefix):
                if "SurfaceFlattening.so" in files:
                    os.remove(os.path.join(folder, "SurfaceFlattening.so"))
            run = subprocess.run([os.path.join(prefix, "bin", "surfaceflattening-paraview"), "pvpython", "-c", ""],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 1)
        self.assertIn("there is no plugin", run.stderr)

    @staticmethod
    def install(prefix):
        subprocess.run(["cmake", "--install", os.environ["FLATTENING_BINARY"], "--prefix", prefix,
                        "--component", "plugin"], check=True, capture_output=True)

    def test_a_start_writes_nothing_into_the_settings_of_the_user(self):
        with tempfile.TemporaryDirectory() as prefix:
            self.install(prefix)
            programs, settings = (os.path.join(prefix, name) for name in ("programs", "settings"))
            os.makedirs(programs)
            for program in ("paraview", "pvpython"):
                os.chmod(write(programs, program, "#!/bin/sh\necho started\n"), 0o755)
                run = subprocess.run([os.path.join(prefix, "bin", "surfaceflattening-paraview"), program],
                                     env={**os.environ, "XDG_CONFIG_HOME": settings,
                                          "PATH": programs + ":" + os.environ["PATH"]},
                                     capture_output=True, text=True, check=False)
                self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "started\n", ""))
            self.assertFalse(os.path.exists(settings))

    def test_what_is_installed_starts_with_one_command(self):
        with tempfile.TemporaryDirectory() as prefix:
            self.install(prefix)
            script = write(prefix, "script.py", PROGRAM)
            # ParaView itself is where the tests have it.
            path = os.path.dirname(os.environ["PVPYTHON"]) + ":" + os.environ["PATH"]
            run = subprocess.run(
                [os.path.join(prefix, "bin", "surfaceflattening-paraview"), "pvpython", script],
                env={**os.environ, "PATH": path, "PYTHONPATH": os.environ["PARAVIEW_PYTHONPATH"]},
                capture_output=True, text=True, check=False)
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
            self.assertIn("made WireWarping", run.stdout)
            shared = os.path.join(prefix, "share", "surfaceflattening-paraview")
            self.assertLessEqual({"flat_beside.py", "flatten_collection.py"}, set(os.listdir(shared)))

    def test_every_program_has_a_script(self):
        for program in ("paraview", "pvpython", "pvbatch", "pvserver"):
            self.assertTrue(os.access(os.path.join(BIN, program), os.X_OK), program)


if __name__ == "__main__":
    sys.exit(unittest.main())
