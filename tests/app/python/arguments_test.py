# SPDX-License-Identifier: GPL-3.0-or-later
"""What is refused is named, in a line; and what was never made is refused, not read."""

import pathlib
import pickle
import unittest

import numpy
import sonde

from shapes import CORNERS, FACES, at, box, boxes


class Arguments(unittest.TestCase):
    def refused(self, error, words, call):
        with self.assertRaisesRegex(error, words) as caught:
            call()
        self.assertLess(len(str(caught.exception)), 100)
        self.assertNotIn("\n", str(caught.exception))

    def test_a_progress_that_cannot_be_called_is_refused(self):
        pair = boxes()
        for call in (
            lambda: pair.depth(at(3), progress=3),
            lambda: pair.depth(at(1.9), progress=3),
            lambda: pair.signed_distance(at(3), progress=3),
            lambda: pair.depth_along(at(3), [0, 0, 1], progress=3),
            lambda: sonde.depth(box(), box(), at(3), progress=3),
            lambda: sonde.Body(CORNERS, FACES, progress=3),
        ):
            self.refused(TypeError, "^progress must be a function or None, not int$", call)

    def test_numbers_and_words_are_refused_by_the_argument(self):
        pair = boxes()
        searches = (
            lambda **wrong: pair.depth(at(3), **wrong),
            lambda **wrong: pair.signed_distance(at(3), **wrong),
            lambda **wrong: pair.depth_in_plane(at(3), [0, 0, 1], **wrong),
            lambda **wrong: sonde.depth(box(), box(), at(3), **wrong),
        )
        for search in searches:
            for name in ("threads", "seed"):
                self.refused(ValueError, f"^{name} is -1", lambda: search(**{name: -1}))
                self.refused(ValueError, f"^{name} is 1844", lambda: search(**{name: 1 << 64}))
                for wrong in (None, 1.5, "1"):
                    kind = type(wrong).__name__
                    self.refused(
                        TypeError,
                        f"^{name} must be an integer, not {kind}$",
                        lambda: search(**{name: wrong}),
                    )
        for call, words in (
            (lambda: pair.separate(at(3), seed=None), "seed must be an integer"),
            (lambda: pair.follower(seed=None), "seed must be an integer"),
            (lambda: sonde.Follower(box(), box(), seed=None), "seed must be an integer"),
            (lambda: pair.follower().step(at(3), budget_steps="x"), "budget_steps must be an int"),
            (lambda: pair.depth(at(3), method=3), "method must be a str, not int"),
            (lambda: pair.depth(at(3), time="x"), "time must be a number or None, not str"),
            (lambda: pair.depth(at(3), clearance="x"), "clearance must be True or False, not str"),
            (lambda: pair.wrench(pair.depth(at(3)), k="x"), "k must be a number, not str"),
            (lambda: sonde.Body.read(3), "file must be a str or a path, not int"),
            (lambda: pair.write(3), "file must be a str or a path, not int"),
            (lambda: sonde.Body(CORNERS, FACES, name=3), "name must be a str"),
            (lambda: box().offset("x"), "by must be a number"),
            (lambda: box().with_mass(measure=None), "measure must be a number"),
        ):
            self.refused(TypeError, words, call)
        self.refused(
            ValueError, "of must be a Separation", lambda: pair.derivative(pair.depth(at(3)))
        )
        for vertices in ("x", None, numpy.array(CORNERS) + 1j, numpy.array(CORNERS).astype(str)):
            self.refused(
                ValueError, "vertices must be real numbers", lambda: sonde.Body(vertices, FACES)
            )
        masked = numpy.ma.array(at(3), mask=numpy.ones_like(at(3)))
        self.refused(ValueError, "poses is a masked array", lambda: pair.touch(masked))
        for wrong, words in (
            ({"time": 0.0}, "^time must be above 0 and finite"),
            ({"time": numpy.inf}, "^time must be above 0 and finite"),
            ({"accuracy": 0.0}, "^accuracy must be above 0 and below 1"),
            ({"sure": 1.0}, "^sure must be above 0 and below 1"),
            ({"time": 1.0, "accuracy": 0.1}, "give time or accuracy"),
            ({"budget_steps": -1}, "^budget_steps must be 0"),
            ({"budget_us": numpy.nan}, "^budget_us must be 0"),
        ):
            self.refused(ValueError, words, lambda: pair.depth(at(1.9), **wrong))
        for name in ("k", "k_t", "k_r", "b_t", "b_r", "max_force", "max_torque"):
            self.refused(
                ValueError,
                f"^{name} must be",
                lambda: pair.wrench(pair.depth(at(1.9)), **{name: -1.0}),
            )
        for seed, threads in ((numpy.int64(1), numpy.uint8(1)), (True, 1)):
            self.assertEqual(len(pair.depth(at(1.9), seed=seed, threads=threads)), 1)
        with self.assertRaisesRegex(sonde.InputError, "nowhere.ply"):
            sonde.Body.read(pathlib.Path("nowhere.ply"))

    def test_what_was_not_made_is_refused(self):
        def unmade(kind):
            return kind.__new__(kind)

        for call in (
            lambda: unmade(sonde.Body).inside([0, 0, 0]),
            lambda: unmade(sonde.Body).name,
            *[
                lambda kind=kind, way=way: way(unmade(kind))
                for kind in (sonde.Body, sonde.Pair, sonde.Depths, sonde.Separation)
                for way in (
                    lambda x: x.__reduce__(),
                    lambda x: x.__reduce_ex__(0),
                    lambda x: pickle.dumps(x, 1),
                )
            ],
            lambda: repr(unmade(sonde.Body)),
            lambda: sonde.Pair(unmade(sonde.Body), box()),
            lambda: unmade(sonde.Pair).depth(at(3)),
            lambda: unmade(sonde.Pair).touch(at(3)),
            lambda: unmade(sonde.Pair).probe,
            lambda: unmade(sonde.Pair).__getstate__(),
            lambda: unmade(sonde.Follower).step(at(3)),
            lambda: unmade(sonde.Depths).depth,
            lambda: unmade(sonde.Depths)[0],
            lambda: len(unmade(sonde.Depths)),
            lambda: unmade(sonde.Separation).depth,
            lambda: unmade(sonde.Separation).contact_point,
            lambda: boxes().wrench(unmade(sonde.Depths)),
            lambda: boxes().wrench(unmade(sonde.Separation)),
            lambda: boxes().derivative(unmade(sonde.Separation)),
        ):
            self.refused(TypeError, r"sonde\.\w+\.__init__ was not called", call)
        self.assertEqual(boxes().probe.name, "box")  # which the pair made, without an __init__


if __name__ == "__main__":
    unittest.main()
