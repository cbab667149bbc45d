# SPDX-License-Identifier: BSD-3-Clause
"""The Debian packages: where things lie, what they depend on, and that they run where they are
unpacked. Environment: BUILD the build tree, FOLDER a folder to work in, DATA the pieces."""

import configparser
import json
import os
import re
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree

BUILD, FOLDER, DATA = (os.environ[name] for name in ("BUILD", "FOLDER", "DATA"))
ROOT = os.path.join(FOLDER, "root")
EDITOR = os.path.exists(os.path.join(BUILD, "bin", "PatternEditor"))


def run(*command, **options):
    return subprocess.run(command, check=True, capture_output=True, text=True, **options).stdout


def field(package, name):
    return run("dpkg-deb", "-f", package, name).strip()


def names_of(depends):
    """The packages of a Depends field, without versions."""
    return {re.split(r"[ (|]", part.strip())[0] for part in depends.split(",")}


def dynamic(path, tag):
    return re.findall(rf"\({tag}\).*\[(.*)\]", run("readelf", "-d", path))


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        os.makedirs(FOLDER)
        run("cpack", "--config", os.path.join(BUILD, "CPackConfig.cmake"), "-B", FOLDER, cwd=BUILD)
        cls.packages = {}
        for file in os.listdir(FOLDER):
            if file.endswith(".deb"):
                path = os.path.join(FOLDER, file)
                run("dpkg-deb", "-x", path, ROOT)
                cls.packages[field(path, "Package")] = path
        cls.binaries = []
        for folder, _, files in os.walk(ROOT):
            for file in files:
                path = os.path.join(folder, file)
                with open(path, "rb") as stream:
                    if not os.path.islink(path) and stream.read(4) == b"\x7fELF":
                        cls.binaries.append(path)

    def test_there_are_all(self):
        editor = {"surfaceflattening-editor"} if EDITOR else set()
        self.assertEqual(set(self.packages), {"surfaceflattening", "surfaceflattening-dev"} | editor)
        self.assertEqual(len(self.binaries), 11 + len(editor))  # four libraries, command, its reader, five Python modules
        version = field(self.packages["surfaceflattening"], "Version")
        self.assertIn(f"surfaceflattening (= {version})",
                      field(self.packages["surfaceflattening-dev"], "Depends"))

    def test_places_are_those_of_debian(self):
        listing = run("dpkg-deb", "-c", self.packages["surfaceflattening"])
        for place in (r"/usr/bin/wirewarp\n", r"/usr/libexec/surfaceflattening/wirewarp-read\n", r"/usr/lib/.*libvtkFiltersFlattening\.so\.\d",
                      r"/usr/lib/.*libvtkIOFlattening\.so\.\d", r"/usr/lib/.*libvtkIOPattern\.so\.\d",
                      r"/usr/lib/python3/dist-packages/surfaceflattening/__init__\.py\n",
                      r"/usr/share/doc/surfaceflattening/copyright\n"):
            self.assertRegex(listing, place)
        self.assertNotIn("/usr/local", listing)
        listing = run("dpkg-deb", "-c", self.packages["surfaceflattening-dev"])
        for place in (r"/usr/include/SurfaceFlattening/vtkWireWarpingFilter\.h\n",
                      r"/usr/lib/.*cmake/SurfaceFlattening/SurfaceFlatteningConfig\.cmake\n",
                      r"libvtkFiltersFlattening\.so -> "):
            self.assertRegex(listing, place)
        # A header of Python's name, or of VTK's, would be found in the place of theirs.
        ours = re.compile(r"/usr/include/(SurfaceFlattening/.*)?$", re.MULTILINE)
        headers = [line for line in listing.splitlines() if "/usr/include/" in line]
        self.assertEqual([line for line in headers if not ours.search(line)], [])

    @unittest.skipUnless(EDITOR, "there is no Qt")
    def test_the_window_is_in_the_menu_and_starts(self):
        package = self.packages["surfaceflattening-editor"]
        self.assertRegex(field(package, "Depends"), r"surfaceflattening \(= .*libvtk9[\w.]*-qt")
        with open(os.path.join(ROOT, "usr", "share", "applications", "patterneditor.desktop"),
                  encoding="utf-8") as file:
            entry = configparser.ConfigParser(interpolation=None)
            entry.read_string(file.read())
        entry = entry["Desktop Entry"]
        self.assertTrue(os.path.exists(os.path.join(ROOT, "usr", "bin", entry["Exec"].split()[0])))
        icon = os.path.join(ROOT, "usr", "share", "icons", "hicolor", "scalable", "apps", entry["Icon"] + ".svg")
        self.assertEqual(xml.etree.ElementTree.parse(icon).getroot().tag, "{http://www.w3.org/2000/svg}svg")
        usage = run(os.path.join(ROOT, "usr", "bin", "PatternEditor"), "--help")
        self.assertIn("SURFACE", usage)

    def test_every_library_that_is_loaded_is_depended_on(self):
        own = {os.path.basename(path) for path in self.binaries}
        depends = names_of(field(self.packages["surfaceflattening"], "Depends"))
        if EDITOR:
            depends |= names_of(field(self.packages["surfaceflattening-editor"], "Depends"))
        files = {}
        for path in self.binaries:
            where = dict(re.findall(r"^\s+(\S+) => (/\S+)", run("ldd", path), re.M))
            files.update((library, os.path.realpath(where[library])) for library in dynamic(path, "NEEDED") if library not in own)
        self.assertGreater(len(files), 10)
        # dpkg knows files by the name they were installed under, before /lib became a link.
        names = {name for file in files.values() for name in (file, file.replace("/usr/lib", "/lib", 1))}
        found = subprocess.run(["dpkg", "-S", *names], capture_output=True, text=True, check=False).stdout
        for library, file in files.items():
            owners = {line.split(":")[0] for line in found.splitlines() if line.endswith(": " + file)
                      or line.endswith(": " + file.replace("/usr/lib", "/lib", 1))}
            self.assertTrue(owners & depends, f"{library} is in {owners}, not in Depends")
        # What Python imports is no library that is linked.
        self.assertLessEqual({"python3-vtk9", "python3-numpy"}, depends)

    def test_binaries_name_no_place_of_the_build(self):
        for path in self.binaries:
            for runpath in dynamic(path, "RUNPATH") + dynamic(path, "RPATH"):
                for entry in runpath.split(":"):
                    self.assertTrue(entry.startswith("$ORIGIN"), f"{path}: {runpath}")

    def test_the_command_runs(self):
        output = os.path.join(FOLDER, "pants")
        run(os.path.join(ROOT, "usr", "bin", "wirewarp"), os.path.join(DATA, "pants_front.vtp"),
            os.path.join(DATA, "pants_front_curves.vtp"), "--output", output)
        with open(os.path.join(output, "report.json"), encoding="utf-8") as file:
            report = json.load(file)
        self.assertEqual(report["status"], "Ok")
        self.assertLess(report["pieces"][0]["E_len_max"], 1e-9)

    def test_the_python_package_is_loaded(self):
        packages = os.path.join(ROOT, "usr", "lib", "python3", "dist-packages")
        printed = run(sys.executable, "-c",
                      "import surfaceflattening as sf; print(sf.__file__);"
                      "print(sf.vtkWireWarpingFilter().GetSchemeAsString())",
                      env={**os.environ, "PYTHONPATH": packages})
        self.assertTrue(printed.startswith(packages), printed)


if __name__ == "__main__":
    unittest.main()
