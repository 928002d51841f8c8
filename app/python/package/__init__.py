# SPDX-License-Identifier: GPL-3.0-or-later
"""Generalized penetration depth of two polygon soups, over NumPy arrays.

>>> probe, fixed = sonde.Body.read("spoon.ply"), sonde.Body.read("cup.ply")
>>> pair = sonde.Pair(probe, fixed)
>>> pair.touch([0, 0, 0.03, 1, 0, 0, 0])
>>> pair.depth([0, 0, 0.03, 1, 0, 0, 0]).depth
"""

from ._sonde import (
    Body,
    Cancelled,
    Depths,
    Follower,
    InputError,
    Pair,
    Separation,
    __version__,
    depth,
    derivative,
    distance,
    principal_stiffnesses,
    signed_distance,
    sweep,
    touch,
    wrench,
)
from .poses import poses

__all__ = [
    "Body",
    "Cancelled",
    "Depths",
    "Follower",
    "InputError",
    "Pair",
    "Separation",
    "depth",
    "derivative",
    "distance",
    "poses",
    "principal_stiffnesses",
    "signed_distance",
    "sweep",
    "touch",
    "wrench",
]
