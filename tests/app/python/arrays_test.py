# SPDX-License-Identifier: GPL-3.0-or-later
"""Work on large arrays: an interrupt ends it soon, and other threads run meanwhile."""

import signal
import sys
import threading
import time
import unittest

import numpy

from shapes import POSES, counted_during, spoon_and_cup


def inside_bounds(body, count):
    """Points for which the tree of a body is descended."""
    corners = body.vertices.min(axis=0), body.vertices.max(axis=0)
    return numpy.random.default_rng(1).uniform(*corners, (count, 3))


def works(pair, rows):
    """What is done with so many rows: for two million of them each takes over a second, most several.
    A point is the quickest of them, so there are more."""
    cup, points = pair.fixed, inside_bounds(pair.fixed, 5 * rows)
    path = numpy.resize(POSES[2000:3200], (rows, 7))
    return {
        "touch": lambda: pair.touch(path),
        "distance": lambda: pair.distance(path),
        "sweep": lambda: pair.sweep(path, path[::-1]),
        "depth": lambda: pair.depth(path[: rows // 20]),
        "signed_distance": lambda: pair.signed_distance(path[: rows // 20]),
        "follow": lambda: pair.follower().follow(path[: rows // 20]),
        "inside": lambda: cup.inside(points),
        "nearest_point": lambda: cup.nearest_point(points),
        "ray": lambda: cup.ray(points, points),
    }


class Arrays(unittest.TestCase):
    def interrupted(self, work):
        """The third of three interrupts ends the work. Each is sent once the last was heeded, so that
        work that heeds none until its end is not ended. None is sent once the work is over: one that
        was too short fails, and is not taken for interrupted. How long the last took to end it, s."""
        heeded, over, sent = threading.Event(), threading.Event(), []
        still_to_heed = [1, 2, 3]

        def heed(*_):
            # Told by what was heeded, not by what was sent: the next may be sent before this looks.
            still_to_heed.pop()
            heeded.set()
            if not still_to_heed and not over.is_set():
                raise KeyboardInterrupt

        def interrupt():
            while len(sent) < 3 and not over.wait(0.05):
                heeded.clear()
                sent.append(time.perf_counter())
                signal.pthread_kill(threading.main_thread().ident, signal.SIGINT)
                heeded.wait(60)

        before = signal.signal(signal.SIGINT, heed)
        other = threading.Thread(target=interrupt)
        other.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                work()
                over.set()
            return time.perf_counter() - sent[-1]
        finally:
            over.set()
            heeded.set()
            other.join()
            signal.signal(signal.SIGINT, before)

    def test_an_interrupt_ends_work_on_any_array(self):
        for name, work in works(spoon_and_cup(), 2_000_000).items():
            with self.subTest(name):
                took = self.interrupted(work)
                print(f"{name}: interrupted after {1e3 * took:.0f} ms", file=sys.stderr)

    def test_other_threads_run_meanwhile(self):
        pair = spoon_and_cup()
        for rows, names in (
            (1_000, ("distance",)),
            (5_000, ("touch", "sweep")),
            (20_000, ("inside", "nearest_point", "ray")),
        ):
            for name in names:
                with self.subTest(name):
                    self.assertGreater(counted_during(works(pair, rows)[name]), 2)

    def test_rows_of_an_array_are_those_of_one_by_one(self):
        pair = spoon_and_cup()
        poses, points = POSES[2700:3200:9], inside_bounds(pair.fixed, 70)
        for query, rows in (
            (lambda x: (pair.touch(x),), poses),
            (pair.distance, poses),
            (lambda x: pair.sweep(x, poses[:1].repeat(numpy.size(x) // 7, 0)), poses),
            (lambda x: (pair.fixed.inside(x),), points),
            (pair.fixed.nearest_point, points),
            (lambda x: pair.fixed.ray(x, numpy.ones_like(x)), points),
        ):
            together = query(rows)
            for i in range(len(rows)):
                for ours, theirs in zip(query(rows[i : i + 1]), together):
                    numpy.testing.assert_array_equal(ours[0], theirs[i])


if __name__ == "__main__":
    unittest.main()
