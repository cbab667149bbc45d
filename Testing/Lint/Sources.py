# SPDX-License-Identifier: BSD-3-Clause
"""The files of the repository, for the checks of this folder."""

import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
CXX_SUFFIXES = {".h", ".cxx"}


def tracked_files():
    """Files under version control or about to be; without git all files outside build folders."""
    listing = subprocess.run(
        ["git", "-C", str(ROOT), "ls-files", "-z"], capture_output=True, text=True, check=False)
    if listing.returncode == 0:
        names = [name for name in listing.stdout.split("\0") if name]
    else:
        names = [str(path.relative_to(ROOT)) for path in ROOT.rglob("*")
                 if path.is_file() and not path.relative_to(ROOT).parts[0].startswith("build")]
    return sorted(name for name in names if (ROOT / name).is_file())


def cxx_files(*folders):
    return [name for name in tracked_files()
            if pathlib.PurePath(name).suffix in CXX_SUFFIXES
            and (not folders or name.startswith(folders))]


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")
