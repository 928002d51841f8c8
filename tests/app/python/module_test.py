# SPDX-License-Identifier: GPL-3.0-or-later
"""The module against the headless program, to the bit, and against boxes whose depth is known."""

import csv
import math
import os
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy
import sonde

SOURCE = os.environ["SOURCE"]
MODELS = os.path.join(SOURCE, "resources", "models")
PATH = os.path.join(SOURCE, "resources", "scenes", "spoon-in-cup.path.csv")
POSES = numpy.loadtxt(PATH, delimiter=",", skiprows=1)[:, 1:8]

CORNERS = [[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
FACES = [
    [0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
    [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5],
]  # fmt: skip
IDENTITY = [1, 0, 0, 0]


def spoon_and_cup():
    return (sonde.Body.read(os.path.join(MODELS, name)) for name in ("spoon.ply", "cup.ply"))


def box(half=1.0):
    return sonde.Body(half * numpy.array(CORNERS), FACES, name="box")


def query(poses, *flags):
    """What `sonde query` answers, by column."""
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "poses.csv")
        numpy.savetxt(
            file, poses, "%.17g", ",", header="px,py,pz,qw,qx,qy,qz", comments=""
        )
        meshes = ["--probe", MODELS + "/spoon.ply", "--fixed", MODELS + "/cup.ply"]
        command = [os.environ["SONDE"], "query", *meshes, "--poses", file, "--quiet", *flags]
        text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    rows = list(csv.DictReader(text.splitlines()))
    return {name: [row[name] for row in rows] for name in rows[0]}


class Module(unittest.TestCase):
    def same_bits(self, ours, theirs):
        self.assertEqual(list(ours.status), theirs["status"])
        for name in ("depth", "sigma", "lower_bound", "residual"):
            numpy.testing.assert_array_equal(
                getattr(ours, name), [float(x) if x else math.nan for x in theirs[name]], name
            )
        for column, name in enumerate(("px", "py", "pz", "qw", "qx", "qy", "qz")):
            numpy.testing.assert_array_equal(ours.pose[:, column], [float(x) for x in theirs[name]])
        for name in ("contacts", "iterations"):
            self.assertEqual(list(getattr(ours, name)), [int(x) for x in theirs[name]])

    def test_depth_has_the_bits_of_query_at_any_number_of_threads(self):
        some = POSES[2700:3200:100]
        theirs = query(some, "--seed", "7")
        self.assertIn("penetrating", theirs["status"])
        for threads in (1, 2, 4):
            ours = sonde.depth(*spoon_and_cup(), some, seed=7, threads=threads)
            self.same_bits(ours, theirs)

    def test_translations_alone_and_a_budget_are_those_of_query(self):
        some = POSES[3000:3100:50]
        theirs = query(some, "--method", "pdt", "--budget-steps", "20")
        self.same_bits(
            sonde.depth(*spoon_and_cup(), some, method="pdt", budget_steps=20), theirs
        )

    def test_a_follower_has_the_bits_of_query_that_follows(self):
        some = POSES[2000:3000:5]
        theirs = query(some, "--mode", "coherent")
        self.assertIn("penetrating", theirs["status"])
        follower = sonde.Follower(*spoon_and_cup())
        parts = [follower.follow(some[:80]), follower.follow(some[80])]
        self.same_bits(parts[0], {name: values[:80] for name, values in theirs.items()})
        self.same_bits(parts[1], {name: values[80:81] for name, values in theirs.items()})
        follower.restart()
        self.same_bits(follower.follow(some), theirs)

    def test_boxes_are_as_deep_as_their_overlap(self):
        # Pushed 0.1 m into a face of its like: the way back out is no longer than that.
        found = sonde.depth(box(), box(), [1.9, 0, 0] + IDENTITY)
        self.assertEqual(len(found), 1)
        self.assertEqual(found.status[0], "penetrating")
        self.assertLessEqual(found.depth[0], 0.1 * (1 + 1e-3))
        self.assertLessEqual(found.lower_bound[0], found.depth[0])
        whole = sonde.depth(box(), box(), [1.9, 0, 0] + IDENTITY, whole_bound=True)
        self.assertGreaterEqual(whole.lower_bound[0], found.lower_bound[0])
        self.assertLessEqual(whole.lower_bound[0], found.depth[0])
        self.assertEqual(sonde.depth(box(), box(), [2.1, 0, 0] + IDENTITY).depth[0], 0)

    def test_a_body_says_what_it_is(self):
        body = box(0.5)
        self.assertTrue(body.solid)
        self.assertEqual(body.triangles, 12)
        self.assertAlmostEqual(body.measure, 1, delta=1e-14)  # a cube's volume
        numpy.testing.assert_allclose(body.centre_of_mass, 0, atol=1e-15)
        numpy.testing.assert_allclose(body.inertia, 1 / 6, rtol=1e-13)  # side²/6

    def test_what_is_no_body_is_refused_with_the_reason(self):
        for faces, reason in (
            ([[0, 1, 8]], "face 0: there is no vertex 8"),
            ([[0, -1, 2]], "no vertex -1"),
            (numpy.zeros((0, 3)), "no triangles"),
        ):
            with self.assertRaisesRegex(sonde.InputError, reason):
                sonde.Body(CORNERS, faces)
        with self.assertRaisesRegex(sonde.InputError, "not finite"):
            sonde.Body([[0, 0, math.nan]] + CORNERS[1:], FACES)
        with self.assertRaisesRegex(sonde.InputError, "nowhere.off"):
            sonde.Body.read("nowhere.off")
        with self.assertRaisesRegex(ValueError, r"\(n, 3\)"):
            sonde.Body([1, 2, 3], FACES)

    def test_what_is_no_pose_is_refused_with_the_reason(self):
        for poses, reason in (
            ([0, 0, 0], r"\(7,\) or \(n, 7\)"),
            ([[0, 0, 0, 1, 0, 0, 0], [0, 0, 0, 0, 0, 0, 0]], "pose 1: "),
            ([0, 0, math.nan, 1, 0, 0, 0], "pose 0: "),
        ):
            with self.assertRaisesRegex(ValueError, reason):
                sonde.depth(box(), box(), poses)
        for wrong in ({"method": "pdx"}, {"budget_steps": -1}):
            with self.assertRaises(ValueError):
                sonde.depth(box(), box(), [0, 0, 0] + IDENTITY, **wrong)

    def test_no_poses_are_no_results(self):
        self.assertEqual(len(sonde.depth(box(), box(), numpy.zeros((0, 7)))), 0)

    def test_other_threads_run_while_a_search_does(self):
        # Kept waiting for the lock of the interpreter, the counter would not move in between.
        counted = [0]
        done = threading.Event()

        def count():
            while not done.wait(1e-4):
                counted[0] += 1

        sonde_bodies = list(spoon_and_cup())
        counter = threading.Thread(target=count)
        counter.start()
        before = counted[0]
        sonde.depth(*sonde_bodies, POSES[2700:3200:100], threads=1)
        during = counted[0] - before
        done.set()
        counter.join()
        self.assertGreater(during, 2)

    def test_types_are_declared_for_all_that_there_is(self):
        stub = os.path.join(os.path.dirname(sonde.__file__), "__init__.pyi")
        with open(stub, encoding="utf-8") as file:
            text = file.read()
        for name in sonde.__all__:
            self.assertRegex(text, rf"(class|def) {name}\b")
            self.assertTrue(getattr(sonde, name).__doc__ or name == "InputError", name)
        for kind in (sonde.Body, sonde.Depths, sonde.Follower):
            for name in vars(kind):
                if not name.startswith("_"):
                    self.assertRegex(text, rf"def {name}\b")

    def test_the_example_draws_the_depth_along_a_path(self):
        with tempfile.TemporaryDirectory() as folder:
            path, picture = os.path.join(folder, "path.csv"), os.path.join(folder, "depth.png")
            rows = numpy.loadtxt(PATH, delimiter=",", skiprows=1)[2800:3000:20]
            header = "t,px,py,pz,qw,qx,qy,qz"
            numpy.savetxt(path, rows, "%.17g", ",", header=header, comments="")
            example = os.path.join(SOURCE, "app", "python", "depth_along_path.py")
            meshes = [os.path.join(MODELS, name) for name in ("spoon.ply", "cup.ply")]
            command = [sys.executable, example, *meshes, path, picture]
            run = subprocess.run(command, capture_output=True, text=True, check=True)
            self.assertRegex(run.stdout, r"deepest: [0-9.]+ mm of 10 poses")
            with open(picture, "rb") as file:
                self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n", run.stderr)


if __name__ == "__main__":
    unittest.main()
