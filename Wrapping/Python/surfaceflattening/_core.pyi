# SPDX-License-Identifier: BSD-3-Clause
# The algorithms for numpy arrays: what each takes and gives is in Extension/Module.cxx and Pieces.cxx.
from typing import Any

class Grading: ...

def __getattr__(name: str) -> Any: ...
