# SPDX-License-Identifier: BSD-3-Clause
"""The recipes for other systems' builds have the form that those read, and name what is there."""

import os
import re
import unittest

import yaml

SOURCE = os.environ["SOURCE"]
WORKFLOWS = os.path.join(SOURCE, ".github", "workflows")


def load(*path):
    with open(os.path.join(SOURCE, *path), encoding="utf-8") as file:
        return yaml.safe_load(file)


def version_of_project():
    with open(os.path.join(SOURCE, "CMakeLists.txt"), encoding="utf-8") as file:
        return re.search(r"project\(SurfaceFlattening\s+VERSION ([0-9.]+)", file.read()).group(1)


class Recipes(unittest.TestCase):
    def test_workflows_have_jobs_of_steps(self):
        names = sorted(os.listdir(WORKFLOWS))
        self.assertEqual(names, ["debian.yml", "release.yml", "wheels.yml"])
        for name in names:
            workflow = load(".github", "workflows", name)
            self.assertLessEqual(set(workflow), {"name", True, "jobs"}, name)  # YAML 1.1 reads `on` as true
            for title, job in workflow["jobs"].items():
                with self.subTest(name=name, job=title):
                    if "uses" in job:
                        self.assertTrue(os.path.exists(os.path.join(SOURCE, job["uses"])))
                        continue
                    self.assertLessEqual(set(job), {
                        "strategy", "runs-on", "container", "steps", "needs", "environment", "permissions"})
                    self.assertIn("runs-on", job)
                    self.assertIn(job.get("needs"), [None, *workflow["jobs"]])
                    for step in job["steps"]:
                        self.assertEqual(len({"uses", "run"} & set(step)), 1, step)
                        self.assertLessEqual(set(step), {"uses", "run", "with", "name"}, step)
                        if "uses" in step:
                            self.assertRegex(step["uses"], r"^[\w-]+/[\w-]+@v\d[\w.]*$")
                        for program in re.findall(r"(?:^|\s)\./([\w/-]+)", step.get("run", "")):
                            self.assertTrue(os.access(os.path.join(SOURCE, program), os.X_OK), program)

    def test_values_of_a_matrix_are_there(self):
        for name in os.listdir(WORKFLOWS):
            for job in load(".github", "workflows", name)["jobs"].values():
                matrix = job.get("strategy", {}).get("matrix", {})
                used = set(re.findall(r"matrix\.(\w+)", str(job)))
                self.assertEqual(used, set(matrix), name)

    def test_the_recipe_of_conda_is_of_this_version(self):
        recipe = load("packaging", "conda", "recipe.yaml")
        self.assertEqual(recipe["schema_version"], 1)
        self.assertEqual(recipe["context"]["version"], version_of_project())
        for name, pattern in (("CITATION.cff", r"^version: (.*)$"), ("CHANGELOG.md", r"^## (\S+)$")):
            with open(os.path.join(SOURCE, name), encoding="utf-8") as file:
                self.assertEqual(re.search(pattern, file.read(), re.M).group(1), version_of_project(), name)
        self.assertLessEqual({"package", "source", "build", "requirements", "tests", "about"}, set(recipe))
        self.assertEqual(set(recipe["requirements"]), {"build", "host", "run"})
        place = os.path.normpath(os.path.join(SOURCE, "packaging", "conda", recipe["source"]["path"]))
        self.assertEqual(place, os.path.normpath(SOURCE))
        self.assertTrue(os.path.exists(os.path.join(place, recipe["about"]["license_file"])))


if __name__ == "__main__":
    unittest.main()
