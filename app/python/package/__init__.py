# SPDX-License-Identifier: GPL-3.0-or-later
"""Generalized penetration depth of two polygon soups, over NumPy arrays.

>>> probe, fixed = sonde.Body.read("spoon.ply"), sonde.Body.read("cup.ply")
>>> sonde.depth(probe, fixed, [0, 0, 0.03, 1, 0, 0, 0]).depth
"""

from ._sonde import Body, Depths, Follower, InputError, __version__, depth

__all__ = ["Body", "Depths", "Follower", "InputError", "depth"]
