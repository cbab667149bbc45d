# SPDX-License-Identifier: BSD-3-Clause
"""CMake/setup.sh installs packages while another program holds apt's locks."""

import os
import subprocess
import sys
import tempfile
import unittest

SETUP = os.path.join(os.environ["SOURCE"], "CMake", "setup.sh")
# The fake one keeps what it was asked, and is locked out as often as the file `held` has lines.
APT_GET = """#!/bin/bash
echo "$*" >>"$FOLDER/asked"
if [[ -s $FOLDER/held ]]; then
  head -n 1 "$FOLDER/held" >&2
  sed -i 1d "$FOLDER/held"
  exit 100
fi
"""
HELD = "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 1 (apt-get)\n"


class Setup(unittest.TestCase):
    def install(self, held, packages="debootstrap # makes a root\n", known=""):
        """Result, and what was asked of apt-get, of a list of packages of which apt knows some."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("apt-get", APT_GET), ("sudo", '#!/bin/bash\n"$@"\n'),
                               ("dpkg-query", "#!/bin/bash\n"),
                               ("apt-cache", f'#!/bin/bash\n[[ " {known} " == *" $2 "* ]]\n')):
                path = os.path.join(folder, name)
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
                os.chmod(path, 0o755)
            for name, text in (("held", held), ("packages", packages)):
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write(text)
            run = subprocess.run(
                ["bash", "-c", f'source "{SETUP}"; install_packages "$FOLDER/packages"'],
                env={**os.environ, "PATH": folder + ":" + os.environ["PATH"], "FOLDER": folder,
                     "APT_PAUSE": "0"},
                capture_output=True, text=True, check=False)
            asked = os.path.join(folder, "asked")
            if not os.path.exists(asked):
                return run.returncode, []
            with open(asked, encoding="utf-8") as file:
                return run.returncode, file.read().splitlines()

    def test_packages_are_asked_for_once(self):
        code, asked = self.install("")
        self.assertEqual(code, 0)
        self.assertEqual([line.split()[-1] for line in asked], ["update", "debootstrap"])
        for line in asked:  # dpkg's own locks apt-get waits for itself
            self.assertIn("DPkg::Lock::Timeout=", line)

    def test_a_held_lock_is_waited_for(self):
        code, asked = self.install(3 * HELD)
        self.assertEqual(code, 0)
        self.assertEqual([line.split()[-1] for line in asked], 4 * ["update"] + ["debootstrap"])

    def test_what_a_system_may_lack_is_installed_where_it_is_known(self):
        packages = "one\n?two # for pages\n?three\n"
        code, asked = self.install("", packages, "one three")
        self.assertEqual((code, asked[-1].split()[-2:]), (0, ["one", "three"]))
        code, asked = self.install("", packages)
        self.assertEqual((code, asked[-1].split()[-2:]), (0, ["--no-install-recommends", "one"]))
        self.assertEqual(self.install("", "?two\n"), (0, []))

    def test_another_fault_is_not_repeated(self):
        code, asked = self.install("E: Some index files failed to download\n")
        self.assertNotEqual(code, 0)
        self.assertEqual(len(asked), 1)


if __name__ == "__main__":
    sys.exit(unittest.main())
