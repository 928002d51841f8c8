# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies and poses of the tests: boxes, whose depths are known, and a spoon in a cup."""

import os
import threading

import numpy
import sonde

SOURCE = os.environ["SOURCE"]
MODELS = os.path.join(SOURCE, "resources", "models")
PATH = os.path.join(SOURCE, "resources", "scenes", "spoon-in-cup.path.csv")
POSES = numpy.loadtxt(PATH, delimiter=",", skiprows=1)[:, 1:8]
CORNERS = numpy.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], float)
FACES = [
    [0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
    [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5],
]  # fmt: skip
IDENTITY = [1, 0, 0, 0]
TURNED = numpy.array([0.36, 0.48, 0.8, 0.0])  # unit


def box(half=1.0):
    return sonde.Body(half * CORNERS, FACES, name="box")


def boxes():
    return sonde.Pair(box(), box())


def spoon_and_cup():
    return sonde.Pair(*(sonde.Body.read(os.path.join(MODELS, f)) for f in ("spoon.ply", "cup.ply")))


def at(x, y=0.0, z=0.0):
    return [x, y, z, *IDENTITY]


def counted_during(work):
    """How far another thread counts while the work is done."""
    counted, done = [0], threading.Event()

    def count():
        while not done.wait(1e-4):
            counted[0] += 1

    counter = threading.Thread(target=count)
    counter.start()
    before = counted[0]
    work()
    during = counted[0] - before
    done.set()
    counter.join()
    return during
