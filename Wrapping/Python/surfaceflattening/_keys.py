# SPDX-License-Identifier: BSD-3-Clause
"""What the planar shape of each key curve costs."""

from __future__ import annotations  # help() prints hints as they are written here

from dataclasses import dataclass
from typing import Any, List, Sequence, Union

from numpy.typing import ArrayLike

from . import _core
from ._curves import Curve, curve_data, surface_data, weighted
from ._equality import ComparedByValue
from ._options import WARPING, read_options, with_options
from ._report import raise_refusal


@dataclass(frozen=True, eq=False)
class KeyTrial(ComparedByValue):
    """A flattening with some of the keys; measures are of the piece where they are largest."""

    #: "Ok", or the name of what is broken.
    status: str
    #: Mean change of area; NaN where the surface was rejected.
    E_area: float
    #: The strain on 95 % of the area; NaN where the surface was rejected.
    strain_p95: float
    #: Keys that lost their shape, since they clash with others.
    released: List[str]


@dataclass(frozen=True, eq=False)
class KeyPrice(ComparedByValue):
    """What the planar shape of one key curve costs."""

    name: str
    #: By how much E_area falls where its shape alone is given up.
    price: float
    #: With all other keys.
    without: KeyTrial
    #: With no other key.
    alone: KeyTrial


@dataclass(frozen=True, eq=False)
class KeyPrices(ComparedByValue):
    """A table of keys by decreasing cost; str() prints it."""

    all: KeyTrial
    none: KeyTrial
    keys: List[KeyPrice]

    def __repr__(self) -> str:
        prices = ", ".join(f"{key.name} {key.price:.3g}" for key in self.keys)
        return f"<KeyPrices: E_area {self.all.E_area:.3g} with all keys, {self.none.E_area:.3g} without; {prices}>"

    def __str__(self) -> str:
        rows = [("all keys", "", self.all)]
        for key in self.keys:
            rows += [(f"without {key.name}", f"{key.price:.5f}", key.without),
                     (f"{key.name} alone", "", key.alone)]
        rows.append(("no key", "", self.none))
        wide = max(len(row[0]) for row in rows)
        lines = [f"{'':{wide}}  {'price':>8}  {'E_area':>8}  {'strain p95':>10}  status"]
        for what, price, trial in rows:
            released = f", released {', '.join(trial.released)}" if trial.released else ""
            lines.append(f"{what:{wide}}  {price:>8}  {trial.E_area:8.5f}  {trial.strain_p95:10.5f}  "
                         f"{trial.status}{released}")
        return "\n".join(lines)


@with_options(WARPING)
def price_keys(
    points: ArrayLike,
    triangles: ArrayLike,
    curves: Sequence[Union[Curve, ArrayLike]],
    **options: Any,
) -> KeyPrices:
    """Flattens a surface without each of its key curves, and with each alone, to measure what they cost.

    A key that is left out keeps its lengths and is free in its shape, as an accessory curve. Where keys
    contradict each other, the trial `without` a key that causes it releases no other.

    Args:
        points, triangles: as for :func:`flatten`.
        curves: all curves of the surface, of any type; at least one is a key curve.
        options: the options of :func:`flatten`, with which all trials are made.

    Returns:
        A :class:`KeyPrices`, keys by decreasing cost: by the number of keys that are given up with it and
        not without it, then by `price`.

    Raises FlatteningError where there is no key curve, or the surface is rejected with all keys; nothing
    warns.
    """
    data = surface_data(points, triangles)
    owner, values = read_options(weighted(data, options), "price_keys", keeps_lengths=True)
    run = _core.price_keys(data, [curve_data(curves, points)], owner, values, options.get("progress"))
    raise_refusal(run)
    return KeyPrices(KeyTrial(*run["all"]), KeyTrial(*run["none"]), [
        KeyPrice(curve, price, KeyTrial(*without), KeyTrial(*alone))
        for curve, price, without, alone in run["keys"]])
