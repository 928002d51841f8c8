#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far two fingers of a gripper can go down over an object, and how much room is left.

    gripper_clearance.py OBJECT PICTURE

The gripper comes from above, along z. Its fingers are as long as the object is high, and as far
apart as the object is wide along x, with a tenth of that to spare.
"""

import sys

import numpy

import sonde

FACES = [
    [0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
    [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5],
]  # fmt: skip


def box(low, high):
    return [[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]


def gripper(width, height):
    """Two fingers and the palm that joins them; its origin is in the middle of the palm's foot."""
    gap, thick = 0.55 * width, 0.1 * width
    boxes = [
        box([-gap - thick, -thick, -height], [-gap, thick, 0]),
        box([gap, -thick, -height], [gap + thick, thick, 0]),
        box([-gap - thick, -thick, 0], [gap + thick, thick, thick]),
    ]
    faces = numpy.concatenate([numpy.array(FACES) + 8 * i for i in range(3)])
    return sonde.Body(numpy.concatenate(boxes), faces, name="gripper")


def main(object_file, picture):
    held = sonde.Body.read(object_file)
    low, high = held.vertices.min(axis=0), held.vertices.max(axis=0)
    middle, size = (low + high) / 2, high - low
    pair = sonde.Pair(gripper(size[0], size[2]), held)

    start, end = [middle[0], middle[1], high[2] + 1.2 * size[2]], [middle[0], middle[1], high[2]]
    free, stop, point, _ = pair.sweep(sonde.poses(start), sonde.poses(end))
    print(f"free down to {1e3 * (stop[2] - high[2]):.2f} mm above the object ({100 * free:.1f} %)")
    if not numpy.isnan(point).any():
        print("stopped at " + ", ".join(f"{1e3 * x:.2f}" for x in point) + " mm")

    heights = numpy.linspace(start[2], end[2], 60)
    poses = sonde.poses(numpy.column_stack([numpy.tile(middle[:2], (60, 1)), heights]))
    clearance = pair.signed_distance(poses)
    try:
        import matplotlib
    except ImportError:
        print("no picture: matplotlib (python3-matplotlib) is missing", file=sys.stderr)
        return
    matplotlib.use("Agg")
    from matplotlib import pyplot

    pyplot.plot(1e3 * (heights - high[2]), 1e3 * clearance)
    pyplot.axhline(0, color="grey", linewidth=0.8)
    pyplot.axvline(1e3 * (stop[2] - high[2]), linestyle="--", label="first contact")
    pyplot.xlabel("palm above the object, mm")
    pyplot.ylabel("clearance (less than 0: depth), mm")
    pyplot.legend()
    pyplot.savefig(picture)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
