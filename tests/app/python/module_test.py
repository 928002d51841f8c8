# SPDX-License-Identifier: GPL-3.0-or-later
"""The module against the headless program, to the bit, and against boxes whose depth is known."""

import ast
import csv
import inspect
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import unittest
from typing import List, Optional, Union, get_args, get_origin

import numpy
import sonde
from numpy.typing import NDArray

from shapes import FACES, IDENTITY, MODELS, PATH, POSES, SOURCE, box, counted_during
from shapes import CORNERS as CORNER_ROWS

CORNERS = CORNER_ROWS.tolist()


def spoon_and_cup():
    return (sonde.Body.read(os.path.join(MODELS, name)) for name in ("spoon.ply", "cup.ply"))


def fit(by):
    """A box that touches another, taken larger by a length: how deep it is then."""
    return sonde.depth(box().offset(by), box(), [2.0, 0, 0, *IDENTITY])


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


def declarations():
    with open(os.path.join(os.path.dirname(sonde.__file__), "__init__.pyi"), encoding="utf-8") as f:
        return ast.parse(f.read()).body


# What the compiled module says, and the words for it.
DECLARED = {
    "numpy.ndarray[numpy.float64]": "ArrayLike",
    "os.PathLike": "Union[str, os.PathLike[str]]",
}
# What is parsed by the module itself, which says no more of it.
PARSED = ("object", "tuple", "function")


def signature_in(node):
    """Names, defaults and types of a declared function; what is told by name alone comes last."""
    types = {arg.arg: arg.annotation for arg in node.args.args + node.args.kwonlyargs}
    types["return"] = node.returns
    words = {
        name: DECLARED.get(ast.unparse(kind), ast.unparse(kind).replace("sonde._sonde.", ""))
        for name, kind in types.items()
        if kind and name != "self"
    }
    defaults = [ast.unparse(d) for d in node.args.defaults + node.args.kw_defaults if d]
    return list(words.items()), defaults, [arg.arg for arg in node.args.kwonlyargs]


def signature_of(function):
    """What the compiled module says of it: the first line of its words."""
    return signature_in(ast.parse(f"def {function.__doc__.splitlines()[0]}: ...").body[0])


def as_declared(declared, compiled):
    """The declaration, without the types of which the compiled module says no more."""
    types, defaults, alone = declared
    there = dict(compiled[0])
    said = [
        (name, there.get(name) if there.get(name) in PARSED else kind.replace("NDArray[numpy.float64]", "ArrayLike"))
        for name, kind in types
    ]
    return said, defaults, alone


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

    def test_boxes_that_touch_are_apart_with_an_allowance(self):
        self.assertEqual(list(fit(0.0).status), ["penetrating"])
        self.assertEqual(list(fit(-1e-5).status), ["separated"])
        self.assertLessEqual(fit(1e-3).depth[0], 1.001e-3)
        self.assertGreater(fit(1e-3).depth[0], 0.9e-3)
        smaller = box().offset(-0.25)
        self.assertEqual(smaller.offset_by, -0.25)
        self.assertEqual(smaller.measure, box().measure)
        with self.assertRaisesRegex(sonde.InputError, "inside out"):
            box().offset(-1.5)

    def test_a_body_says_what_it_is(self):
        body = box(0.5)
        self.assertTrue(body.solid)
        self.assertEqual(body.triangles, 12)
        self.assertAlmostEqual(body.measure, 1, delta=1e-14)  # a cube's volume
        numpy.testing.assert_allclose(body.centre_of_mass, 0, atol=1e-15)
        numpy.testing.assert_allclose(body.inertia, 1 / 6, rtol=1e-13)  # side²/6

    def test_a_sheet_with_a_closed_part_has_its_mass_by_area(self):
        cube = box(0.05)
        for side in (1.0, 2.0, 7.0):
            corners = numpy.array([[0, 0, 0], [side, 0, 0], [side, side, 0], [0, side, 0]]) + 1
            points = numpy.vstack([cube.vertices, corners])
            faces = numpy.vstack([cube.faces, [[8, 9, 10], [8, 10, 11]]])
            body = sonde.Body(points, faces)
            self.assertTrue(body.solid)
            self.assertFalse(body.by_volume)
            self.assertAlmostEqual(body.measure, side**2 + 0.06, delta=1e-12)
            self.assertRegex(body.mass_why, "^by area: .* of the area belongs to open parts$")
        self.assertTrue(cube.by_volume)
        self.assertEqual(cube.mass_why, "")

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
        for faces in (numpy.array(FACES) + 0.9, numpy.array(FACES, float), [["a", "b", "c"]]):
            with self.assertRaisesRegex(ValueError, "faces must be integers"):
                sonde.Body(CORNERS, faces)
        with self.assertRaisesRegex(ValueError, "inhomogeneous|sequence"):
            sonde.Body(CORNERS, [[0, 1, 2], [0, 1]])
        for kind in (numpy.int8, numpy.uint32, numpy.int64):
            self.assertEqual(sonde.Body(CORNERS, numpy.array(FACES, kind)).triangles, 12)

    def test_a_file_may_be_named_by_a_path(self):
        file = pathlib.Path(MODELS) / "cup.ply"
        self.assertEqual(sonde.Body.read(file).triangles, sonde.Body.read(str(file)).triangles)

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
        probe, fixed = spoon_and_cup()
        follower = sonde.Follower(probe, fixed)
        for work in (
            lambda: sonde.depth(probe, fixed, POSES[2700:3200:100], threads=1),
            lambda: follower.follow(POSES[2000:3000:2]),
        ):
            self.assertGreater(counted_during(work), 2)

    def test_a_follower_refuses_a_second_thread(self):
        follower = sonde.Follower(*spoon_and_cup())
        refused, begun = [], threading.Event()

        def follow():
            begun.set()
            follower.follow(POSES[2000:3000:2])

        first = threading.Thread(target=follow)
        first.start()
        begun.wait()
        while first.is_alive() and not refused:
            try:
                follower.restart()
            except RuntimeError as error:
                refused.append(str(error))
        first.join()
        self.assertRegex(refused[0], "another thread")
        follower.restart()
        self.assertEqual(len(follower.follow(POSES[2000])), 1)

    def test_all_that_there_is_has_words_and_a_declaration(self):
        declared = {node.name: node for node in declarations() if hasattr(node, "name")}
        for name in sonde.__all__:
            self.assertIn(name, declared)
            self.assertTrue(getattr(sonde, name).__doc__, name)
        special = {"__len__", "__getitem__"}
        for kind in (sonde.Body, sonde.Depths, sonde.Separation, sonde.Pair, sonde.Follower):
            methods = {node.name for node in declared[kind.__name__].body}
            there = {name for name in vars(kind) if name[0] != "_" or name in special}
            self.assertEqual(methods - {"__init__"}, there)
            for name in there - special:
                words = getattr(kind, name).__doc__.split("\n\n", 1)  # behind the signature
                self.assertTrue(words[-1].strip() and "->" not in words[-1], name)

    def test_functions_are_declared_as_they_are(self):
        functions = [node for node in declarations() if isinstance(node, ast.FunctionDef)]
        written = inspect.signature(sonde.poses)  # in Python
        [poses] = [node for node in functions if node.name == "poses"]
        self.assertEqual(
            [arg.arg for arg in poses.args.args + poses.args.kwonlyargs], list(written.parameters)
        )
        pairs = [(node, getattr(sonde, node.name)) for node in functions if node is not poses]
        for kind in (node for node in declarations() if isinstance(node, ast.ClassDef)):
            pairs += [
                (node, getattr(getattr(sonde, kind.name), node.name))
                for node in kind.body
                if isinstance(node, ast.FunctionDef)
                and "property" not in map(ast.unparse, node.decorator_list)
            ]
        self.assertEqual(len(pairs), 39)
        for node, function in pairs:
            compiled = signature_of(function)
            self.assertEqual(as_declared(signature_in(node), compiled), compiled, node.name)

    def test_a_body_says_what_was_mended(self):
        over = [face[::-1] for face in FACES]
        away = [[x + 5, y, z] for x, y, z in CORNERS]
        both = FACES + [[8 + i for i in face] for face in over]
        body = sonde.Body(CORNERS + away, both)
        self.assertEqual(body.mended, ["1 part of 2 inside out, turned"])
        self.assertAlmostEqual(body.measure, 16)
        self.assertAlmostEqual(body.centre_of_mass[0], 2.5)
        self.assertEqual(box().mended, [])
        self.assertTrue(sonde.Body(CORNERS, FACES[:11], "solid").solid)
        self.assertFalse(sonde.Body(CORNERS, FACES[:11], repair="none").solid)

    def test_values_are_of_the_types_that_are_declared(self):
        body = sonde.Body(CORNERS, [f[::-1] for f in FACES])  # inside out: something is mended
        pair = sonde.Pair(body, box())
        values = {
            "Body": body,
            "Pair": pair,
            "Depths": sonde.depth(body, box(), [1.9, 0, 0] + IDENTITY),
            "Separation": pair.separate([1.9, 0, 0] + IDENTITY),
        }
        names = {"numpy": numpy, "NDArray": NDArray, "List": List, "Optional": Optional}
        names["Body"] = sonde.Body
        checked = 0
        for kind in (node for node in declarations() if isinstance(node, ast.ClassDef)):
            for node in kind.body:
                if "property" not in map(ast.unparse, getattr(node, "decorator_list", [])):
                    continue
                value, checked = getattr(values[kind.name], node.name), checked + 1
                declared = eval(ast.unparse(node.returns), names)
                if get_origin(declared) is numpy.ndarray:
                    scalar = get_args(get_args(declared)[1])[0]
                    self.assertTrue(numpy.issubdtype(value.dtype, scalar), node.name)
                elif get_origin(declared) is list:
                    self.assertEqual({type(v) for v in value}, set(get_args(declared)), node.name)
                elif get_origin(declared) is Union:
                    self.assertIn(type(value), get_args(declared), node.name)
                else:
                    self.assertIs(type(value), declared, node.name)
        self.assertEqual(checked, 50)

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
