# SPDX-License-Identifier: BSD-3-Clause
# The algorithms for numpy arrays; see Extension/Module.cxx.
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from ._curves import CurveRow, Surface

_Progress = Optional[Callable[[float], Any]]

def flatten(
    points: NDArray[np.float64],
    corners: NDArray[np.int64],
    offsets: Optional[NDArray[np.int64]],
    curves: Sequence[CurveRow],
    owner: str,
    options: Mapping[str, Any],
    progress: _Progress,
) -> Dict[str, Any]: ...
def price_keys(
    points: NDArray[np.float64],
    corners: NDArray[np.int64],
    offsets: Optional[NDArray[np.int64]],
    curves: Sequence[CurveRow],
    owner: str,
    options: Mapping[str, Any],
    progress: _Progress,
) -> Dict[str, Any]: ...
def suggest(
    points: NDArray[np.float64],
    corners: NDArray[np.int64],
    offsets: Optional[NDArray[np.int64]],
    curves: Sequence[CurveRow],
    weights: Optional[NDArray[np.float64]],
    owner: str,
    options: Mapping[str, Any],
    progress: _Progress,
) -> Dict[str, Any]: ...
def make_flattenable(
    points: NDArray[np.float64],
    corners: NDArray[np.int64],
    offsets: Optional[NDArray[np.int64]],
    curves: Sequence[CurveRow],
    body: Optional[Surface],
    owner: str,
    options: Mapping[str, Any],
    progress: _Progress,
) -> Dict[str, Any]: ...
def describe_idle(owner: str, options: Mapping[str, Any], given: Sequence[str]) -> str: ...
def options_of(owner: str) -> List[Tuple[str, str]]: ...
def materials() -> Dict[str, Any]: ...
def remedy_sentence(name: str) -> str: ...
