# SPDX-License-Identifier: GPL-3.0-or-later
"""Results: of which pair they are, what they are after pickling, and what is made of them."""

import concurrent.futures
import copy
import multiprocessing
import os
import pickle
import tempfile
import unittest

import numpy
import sonde

from shapes import CORNERS, FACES, POSES, TURNED, at, box, boxes, spoon_and_cup

TILTED = [1.9, 0.1, 0.2, *TURNED]
OF_ONE = [name for name in vars(sonde.Separation) if name[0] != "_"]
OF_MANY = [name for name in vars(sonde.Depths) if name[0] != "_"]


def separated(pair, pose):
    return pair.separate(pose, clearance=True)


def far_away():
    """A pair and a pose at which nothing can be told."""
    fixed = sonde.Body(1e3 * CORNERS + [1e16, 0, 0], FACES)
    return sonde.Pair(box(), fixed), at(1e16)


class Results(unittest.TestCase):
    def same(self, ours, theirs, names):
        for name in names:
            a, b = getattr(ours, name), getattr(theirs, name)
            numpy.testing.assert_array_equal(a, b, name)
            self.assertIs(type(a), type(b))

    def test_results_of_another_pair_are_refused(self):
        pair = boxes()
        others = (
            sonde.Pair(box(0.5), box()),
            sonde.Pair(box(), box(0.5)),
            sonde.Pair(box().with_mass(inertia=[1, 1, 1]), box()),
            sonde.Pair(box(), sonde.Body(CORNERS, FACES, "surface")),
        )
        for other in others:
            for of in (
                other.depth(TILTED),
                other.depth([TILTED] * 3)[1:],
                other.separate(TILTED),
                other.separate(at(3)),
                other.follower().step(TILTED),
                other.follower().follow(TILTED),
                sonde.Follower(other.probe, other.fixed).step(TILTED),
                other.depth_along(TILTED, [1, 0, 0]),
                pickle.loads(pickle.dumps(other.separate(TILTED))),
                pickle.loads(pickle.dumps(other.depth(TILTED))),
            ):
                calls = [pair.wrench, lambda of: sonde.wrench(pair, of)]
                if isinstance(of, sonde.Separation):
                    calls += [pair.derivative, lambda of: sonde.derivative(pair, of)]
                for call in calls:
                    with self.assertRaisesRegex(ValueError, "^of must be a result of this pair"):
                        call(of)

    def test_results_of_the_same_pair_made_again_are_taken(self):
        pair = boxes()
        named = sonde.Pair(box(), sonde.Body(CORNERS, FACES, name="another name"))
        for other in (boxes(), named, pickle.loads(pickle.dumps(pair))):
            self.assertEqual(pair.wrench(other.depth([TILTED, at(3)])).shape, (2, 6))
            self.assertEqual(pair.derivative(other.separate(TILTED))[1].shape, (6, 6))
        found = sonde.depth(pair.probe, pair.fixed, TILTED)
        numpy.testing.assert_array_equal(pair.wrench(found), pair.wrench(pair.separate(TILTED)))
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "boxes.pair")
            pair.write(file)
            again = sonde.Pair.read(file, box(), box())
        again.wrench(found)

    def test_a_separation_is_pickled_to_the_same_bits(self):
        pair = spoon_and_cup()
        deep = next(p for p in POSES[2700:] if pair.touch(p))
        follower = pair.follower()
        follower.step(deep)
        for found in (separated(pair, deep), separated(pair, POSES[0]), follower.step(deep)):
            protocols = range(pickle.HIGHEST_PROTOCOL + 1)
            for again in [pickle.loads(pickle.dumps(found, p)) for p in protocols] + [
                copy.deepcopy(found)
            ]:
                self.same(again, found, OF_ONE)
                self.assertEqual(repr(again), repr(found))
                numpy.testing.assert_array_equal(pair.wrench(again), pair.wrench(found))
                for ours, theirs in zip(pair.derivative(again), pair.derivative(found)):
                    numpy.testing.assert_array_equal(ours, theirs)
        far, pose = far_away()
        failed = pickle.loads(pickle.dumps(far.separate(pose)))
        self.assertEqual(failed.status, "failed")
        self.assertRegex(failed.reason, "too far")
        with concurrent.futures.ProcessPoolExecutor(
            1, multiprocessing.get_context("spawn")
        ) as pool:
            there = pool.submit(separated, pair, deep).result()
        self.same(there, separated(pair, deep), OF_ONE)
        numpy.testing.assert_array_equal(pair.wrench(there), pair.wrench(separated(pair, deep)))

    def test_depths_are_pickled_to_the_same_bits(self):
        pair = spoon_and_cup()
        far, pose = far_away()
        for found in (
            pair.depth(POSES[2800:3000:20], clearance=True),
            pair.depth(POSES[:0]),
            far.depth([pose, at(3)]),
            pair.depth(POSES[2900], time=1e-3),
        ):
            again = pickle.loads(pickle.dumps(found))
            self.same(again, found, OF_MANY)
            self.same(again[::-1][::-1], found, OF_MANY)
            self.assertEqual(repr(again), repr(found))
        for wrong in ((), (1, 2, ["separated"], [], []), (1, 2, [], [], [numpy.zeros(2)] * 17)):
            with self.assertRaises(Exception):
                sonde.Depths.__new__(sonde.Depths).__setstate__(wrong)

    def test_what_failed_is_said_by_all_ways_to_ask(self):
        pair, pose = far_away()
        for status, reason in (
            (pair.depth(pose).status[0], pair.depth(pose).reason[0]),
            (pair.separate(pose).status, pair.separate(pose).reason),
            (pair.follower().step(pose).status, pair.follower().step(pose).reason),
        ):
            self.assertEqual(status, "failed")
            self.assertRegex(reason, "too far")

    def test_an_array_is_made_once(self):
        found = boxes().depth([TILTED, at(3)])
        for name in OF_MANY:
            if name != "reason":
                self.assertIs(getattr(found, name), getattr(found, name))
        self.assertEqual(found.status.dtype, numpy.dtype("U11"))
        self.assertEqual(found.pose.shape, (2, 7))
        self.assertTrue(found.pose.flags.c_contiguous)

    def test_functions_of_a_pair_are_its_methods(self):
        pair, poses = boxes(), [at(1.9), at(2.5)]
        numpy.testing.assert_array_equal(
            sonde.signed_distance(pair, poses, seed=3), pair.signed_distance(poses, seed=3)
        )
        found = pair.separate(TILTED)
        for ours, theirs in zip(sonde.derivative(pair, found), pair.derivative(found)):
            numpy.testing.assert_array_equal(ours, theirs)

    # Reference: NumPy's eigenvectors.
    def test_principal_stiffnesses_are_those_of_the_symmetric_blocks(self):
        pair = boxes()
        _, *sides, which = pair.derivative(pair.separate(TILTED))
        self.assertNotEqual(which, "none")
        for d_wrench in sides:
            found = sonde.principal_stiffnesses(d_wrench, k=500.0)
            for block, values, directions in ((slice(3), *found[:2]), (slice(3, 6), *found[2:])):
                stiffness = -500.0 * d_wrench[block, block]
                stiffness = (stiffness + stiffness.T) / 2
                expected = numpy.linalg.eigvalsh(stiffness)[::-1]
                scale = numpy.abs(expected).max()
                numpy.testing.assert_allclose(values, expected, atol=1e-12 * scale)
                numpy.testing.assert_allclose(directions @ directions.T, numpy.eye(3), atol=1e-12)
                for value, direction in zip(values, directions):
                    numpy.testing.assert_allclose(
                        stiffness @ direction, value * direction, atol=1e-10 * scale
                    )
        for wrong, words in (
            (numpy.zeros((6, 5)), r"d_wrench must be of shape \(6, 6\)"),
            (numpy.full((6, 6), numpy.nan), "d_wrench must be finite"),
            (numpy.zeros((6, 6), complex), "d_wrench must be real numbers"),
        ):
            with self.assertRaisesRegex(ValueError, words):
                sonde.principal_stiffnesses(wrong)
        with self.assertRaisesRegex(ValueError, "k must be finite"):
            sonde.principal_stiffnesses(numpy.zeros((6, 6)), k=numpy.inf)

    def test_contacts_are_of_parts_with_a_name(self):
        pair = boxes()
        found = pair.separate(TILTED)
        self.assertEqual(pair.fixed.part_at(found.contact_point[0]), "box")
        names = pair.fixed.part_at(found.contact_point)
        self.assertEqual(names, ["box"] * len(found.contact_point))
        with self.assertRaisesRegex(sonde.InputError, "not finite"):
            pair.fixed.part_at([numpy.nan, 0, 0])


if __name__ == "__main__":
    unittest.main()
