#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots the penetration depth along a path: searched for, and followed from pose to pose.

    depth_along_path.py PROBE FIXED PATH.csv PICTURE
"""

import sys

import numpy

import sonde


def main(probe_file, fixed_file, path_file, picture):
    probe, fixed = sonde.Body.read(probe_file), sonde.Body.read(fixed_file)
    rows = numpy.loadtxt(path_file, delimiter=",", skiprows=1)
    time, poses = rows[:, 0], rows[:, 1:8]
    followed = sonde.Follower(probe, fixed).follow(poses)
    some = slice(None, None, max(1, len(poses) // 50))  # a search takes longer than a step
    searched = sonde.depth(probe, fixed, poses[some])
    print(f"deepest: {1e3 * numpy.nanmax(followed.depth):.3f} mm of {len(followed)} poses")
    try:
        import matplotlib
    except ImportError:
        print("no picture: matplotlib (python3-matplotlib) is missing", file=sys.stderr)
        return
    matplotlib.use("Agg")
    from matplotlib import pyplot

    pyplot.plot(time, 1e3 * followed.depth, label="held, followed from pose to pose")
    pyplot.plot(time[some], 1e3 * searched.depth, ".", label="nearest way out, searched for")
    pyplot.xlabel("time, s")
    pyplot.ylabel("depth, mm")
    pyplot.legend()
    pyplot.savefig(picture)


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
