# SPDX-License-Identifier: GPL-3.0-or-later
"""What is asked of a pair of bodies: against boxes, whose distances and depths are known."""

import concurrent.futures
import copy
import math
import multiprocessing
import os
import pickle
import subprocess
import sys
import tempfile
import unittest
from types import SimpleNamespace

import numpy
import sonde

from shapes import CORNERS, FACES, MODELS, POSES, SOURCE, TURNED, at, box, boxes, spoon_and_cup


def turned(angle):
    """A rotation matrix about z."""
    c, s = math.cos(angle), math.sin(angle)
    return numpy.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])


def matrix_of(pose):
    w, x, y, z = pose[3:]
    out = numpy.eye(4)
    out[:3, 3] = pose[:3]
    out[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return out


def depth_of_one(pair, pose):
    return pair.depth(pose).depth[0]


class Pair(unittest.TestCase):
    def test_touch_and_distance_are_those_of_boxes(self):
        pair = boxes()
        self.assertIs(pair.touch(at(1.9)), True)
        self.assertIs(sonde.touch(pair, at(2.1)), False)
        xs = numpy.linspace(1.5, 2.5, 11)
        poses = numpy.array([at(x, 0.1, 0.2) for x in xs])
        numpy.testing.assert_array_equal(pair.touch(poses), xs <= 2)
        distance, on_probe, on_fixed = pair.distance(poses)
        numpy.testing.assert_allclose(distance, numpy.maximum(xs - 2, 0), atol=1e-14)
        apart = xs > 2
        numpy.testing.assert_allclose(on_probe[apart, 0], xs[apart] - 1, atol=1e-14)
        numpy.testing.assert_allclose(on_fixed[apart, 0], 1, atol=1e-14)
        signed = pair.signed_distance(poses)
        numpy.testing.assert_allclose(signed[apart], xs[apart] - 2, atol=1e-14)
        self.assertTrue((signed[xs < 2] < 0).all())
        self.assertAlmostEqual(pair.signed_distance(at(2.25)), 0.25)
        one, a, b = sonde.distance(pair, at(2.25))
        self.assertAlmostEqual(one, 0.25)
        self.assertEqual((a.shape, b.shape), ((3,), (3,)))

    def test_a_sweep_ends_at_the_face(self):
        free, pose, point, normal = sonde.sweep(boxes(), at(4.0), at(0.0))
        self.assertAlmostEqual(free, 0.5, delta=1e-8)
        self.assertAlmostEqual(pose[0], 2, delta=1e-7)
        self.assertAlmostEqual(point[0], 1, delta=1e-7)
        numpy.testing.assert_allclose(normal, [1, 0, 0], atol=1e-6)
        free, _, point, _ = boxes().sweep([at(4.0), at(4.0)], [at(5.0), at(1.0)])
        self.assertEqual(free[0], 1)
        self.assertTrue(numpy.isnan(point[0]).all() and not numpy.isnan(point[1]).any())

    def test_a_pair_finds_what_two_bodies_do(self):
        pair, some = spoon_and_cup(), POSES[2700:3200:100]
        ours, theirs = pair.depth(some, seed=7), sonde.depth(pair.probe, pair.fixed, some, seed=7)
        numpy.testing.assert_array_equal(ours.depth, theirs.depth)
        numpy.testing.assert_array_equal(ours.pose, theirs.pose)
        for row, pose in enumerate(some):
            one = pair.separate(pose, seed=7)
            self.assertEqual((one.status, one.depth), (ours.status[row], ours.depth[row]))

    def test_poses_are_rows_matrices_and_of_any_real_type(self):
        pair, pose = boxes(), numpy.array([1.9, 0.3, 0.2, *TURNED])
        expected = pair.depth(pose).depth[0]
        wide = numpy.zeros((3, 14))
        wide[:, ::2] = pose
        for given in (list(pose), [pose], wide[:, ::2], wide[0, ::2], pose[None]):
            self.assertEqual(pair.depth(given).depth[0], expected)
        matrix = matrix_of(pose)
        for given in (matrix, [matrix], matrix.T.copy().T):
            self.assertAlmostEqual(pair.depth(given).depth[0], expected, delta=1e-6)
        single = pair.depth(pose.astype(numpy.float32)).depth[0]
        self.assertAlmostEqual(single, expected, delta=1e-4)
        self.assertEqual(pair.depth(numpy.array(at(2), int)).status[0], "penetrating")

    def test_poses_of_rotations_name_the_order_of_quaternions(self):
        w, x, y, z = TURNED
        expected = [1, 2, 3, w, x, y, z]
        rotation = SimpleNamespace(as_quat=lambda: numpy.array([x, y, z, w]))
        for given in (
            {"quaternion_wxyz": [w, x, y, z]},
            {"quaternion_xyzw": [x, y, z, w]},
            {"rotation": rotation},
            {"matrix": matrix_of(expected)[:3, :3]},
        ):
            numpy.testing.assert_allclose(sonde.poses([1, 2, 3], **given), expected, atol=1e-15)
        for q in numpy.random.default_rng(1).normal(size=(50, 4)):
            q /= numpy.linalg.norm(q) * (1 if q[0] > 0 else -1)
            pose = numpy.array([0, 0, 0, *q])
            made = sonde.poses([0, 0, 0], matrix=matrix_of(pose)[:3, :3])
            numpy.testing.assert_allclose(made, pose, atol=1e-14)
        many = sonde.poses(numpy.zeros((4, 3)), quaternion_wxyz=TURNED)
        self.assertEqual(many.shape, (4, 7))
        numpy.testing.assert_array_equal(sonde.poses([1, 2, 3]), [1, 2, 3, 1, 0, 0, 0])
        for given, reason in (
            ({"quaternion_xyzw": [1, 1, 0, 0]}, "length other than 1"),
            ({"quaternion_wxyz": [1, 0, 0]}, r"quaternion_wxyz must be of shape \(4,\)"),
            ({"matrix": -numpy.eye(3)}, "no rotation"),
            ({"rotation": 3}, "as_quat"),
            ({"matrix": numpy.eye(3), "quaternion_wxyz": TURNED}, "one kind"),
        ):
            with self.assertRaisesRegex(ValueError, reason):
                sonde.poses([0, 0, 0], **given)
        with self.assertRaisesRegex(ValueError, "2 translations and 3 rotations"):
            sonde.poses(numpy.zeros((2, 3)), quaternion_wxyz=[TURNED] * 3)

    def test_what_is_no_pose_is_refused_by_name(self):
        pair = boxes()
        for given, reason in (
            ([0, 0, 0], r"poses must be of shape \(7,\) or \(n, 7\)"),
            (numpy.eye(3), r"\(4, 4\)"),
            (numpy.array([None] * 7), "real numbers, not of type object"),
            (numpy.array([1j] * 7), "real numbers"),
            ([at(0), [0, 0, 0, 0, 0, 0, 0]], "pose 1: "),
            (at(math.nan), "pose 0: "),
            (numpy.diag([1.0, 1, -1, 1]), "pose 0: .* no rotation"),
            (numpy.diag([1.0, 1, 1, 2]), "pose 0: the last row"),
        ):
            for query in (pair.touch, pair.distance, pair.depth, pair.signed_distance):
                with self.assertRaisesRegex(ValueError, reason):
                    query(given)
        with self.assertRaisesRegex(ValueError, "start and end"):
            pair.sweep([at(4)] * 2, [at(0)] * 3)
        with self.assertRaisesRegex(ValueError, "end 0"):
            pair.sweep(at(4), at(math.nan))
        with self.assertRaisesRegex(ValueError, "pose must be one"):
            pair.separate([at(4), at(3)])

    def test_contacts_and_wrench_are_those_of_a_face_on_a_face(self):
        found = boxes().depth([at(3), at(1.9, 0.1, 0.2)], clearance=True)
        self.assertAlmostEqual(found.clearance[0], 1)
        self.assertTrue(math.isnan(found.clearance[1]))
        self.assertEqual(set(found.contact_row), {1})
        numpy.testing.assert_allclose(found.contact_point[:, 0], 1, atol=1e-8)
        numpy.testing.assert_allclose(found.contact_normal[:, 0], 1, atol=1e-6)
        self.assertAlmostEqual(found.contact_multiplier.sum(), found.depth[1], delta=1e-6)
        pair = boxes()
        felt = sonde.wrench(pair, found, k=300.0)
        self.assertEqual(felt.shape, (2, 6))
        numpy.testing.assert_array_equal(felt[0], 0)
        self.assertAlmostEqual(numpy.linalg.norm(felt[1, :3]), 300 * found.depth[1], delta=0.01)
        classic = pair.wrench(found, mode="classic", k_t=300.0, max_force=5.0)
        self.assertAlmostEqual(numpy.linalg.norm(classic[1, :3]), 5)
        with self.assertRaises(ValueError):
            pair.wrench(found, k=math.nan)
        with self.assertRaises(ValueError):
            pair.wrench(3)

    def test_dampers_are_dashpots_of_a_face_on_a_face(self):
        pair = boxes()
        before, now = pair.separate(at(1.91, 0.1, 0.2)), pair.separate(at(1.9, 0.1, 0.2))
        speed = 0.01 / 1e-3  # further in, m/s
        rates = {"before": before, "dt": 1e-3}
        for mode in ("damped", "classic"):
            gains = {"mode": mode, "k": 300.0, "k_t": 300.0, "b_t": 2.0}
            still = pair.wrench(now, **gains)
            numpy.testing.assert_allclose(still[0, 0], 300 * 0.1, rtol=1e-3)
            moving = pair.wrench(now, **gains, **rates)
            # The damped mode's fades by a thousandth of the trace of its rows, turns included.
            numpy.testing.assert_allclose((moving - still)[0, 0], 2 * speed, rtol=1e-2)
        plain = pair.wrench(now, k=300.0)
        numpy.testing.assert_array_equal(pair.wrench(now, k=300.0, b_t=2.0, **rates), plain)
        for reason, given in (
            ("together", {"before": before}),
            ("together", {"dt": 1e-3}),
            ("above 0", {"before": before, "dt": 0.0}),
            ("before must be a Separation", {"before": 3, "dt": 1e-3}),
            ("b_t", {"b_t": -1.0}),
        ):
            with self.assertRaisesRegex(ValueError, reason):
                pair.wrench(now, **given)
        with self.assertRaisesRegex(ValueError, "of must be a Separation"):
            pair.wrench(pair.depth([at(1.9)]), **rates)

    def test_derivatives_are_those_of_central_differences(self):
        pair, pose, step = boxes(), numpy.array([1.9, 0.1, 0.2, *TURNED]), 1e-6
        follower = pair.follower()
        found = follower.step(pose)
        d_depth, d_wrench, _, sides = pair.derivative(found)
        self.assertIn(sides, ("all", "two"))
        for axis in range(3):
            moved = []
            for sign in (1, -1):
                beside = pose.copy()
                beside[axis] += sign * step
                moved.append(follower.copy().step(beside).depth)
            difference = (moved[0] - moved[1]) / (2 * step)
            self.assertAlmostEqual(d_depth[axis], difference, delta=1e-3)
        self.assertEqual(d_wrench.shape, (6, 6))

    def test_a_part_of_results_is_results(self):
        found = boxes().depth([at(x) for x in (3, 1.9, 1.8, 2.5, 1.7)])
        for index in (slice(1, 4), -1, [0, 2], found.depth > 0, numpy.arange(5)[::-1]):
            part = found[index]
            rows = numpy.atleast_1d(numpy.arange(5)[index])
            numpy.testing.assert_array_equal(part.depth, found.depth[rows])
            numpy.testing.assert_array_equal(part.status, found.status[rows])
            self.assertEqual(len(part), len(rows))
            for new, old in enumerate(rows):
                numpy.testing.assert_array_equal(
                    part.contact_point[part.contact_row == new],
                    found.contact_point[found.contact_row == old],
                )
        with self.assertRaises(IndexError):
            found[5]
        self.assertIn("5 poses: 3 penetrating", repr(found))

    def test_time_and_accuracy_claim_what_they_reach(self):
        found = spoon_and_cup().depth(POSES[2900:3100:100], time=2e-3)
        self.assertFalse(numpy.isnan(found.within).any())
        with self.assertRaisesRegex(ValueError, "give no other"):
            boxes().depth(at(1.9), time=1e-3, budget_steps=3)
        with self.assertRaisesRegex(ValueError, "give time or accuracy"):
            boxes().depth(at(1.9), time=1e-3, accuracy=0.1)

    def test_a_follower_steps_and_is_copied(self):
        pair = spoon_and_cup()
        follower = pair.follower()
        follower.follow(POSES[2000:2700:5])
        other = follower.copy()
        ours = [follower.step(p) for p in POSES[2700:2900:5]]
        theirs = other.follow(POSES[2700:2900:5])
        self.assertEqual([s.depth for s in ours], list(theirs.depth))
        self.assertIn("penetrating", theirs.status)

    def test_bodies_are_asked_and_give_back_their_mesh(self):
        body = box()
        self.assertIs(body.inside([0.5, 0.5, 0.5]), True)
        numpy.testing.assert_array_equal(body.inside([[0, 0, 0], [1.5, 0, 0]]), [True, False])
        point, normal, distance = body.nearest_point([[3, 0.5, 0], [0, 0, -1.5]])
        numpy.testing.assert_allclose(point, [[1, 0.5, 0], [0, 0, -1]])
        numpy.testing.assert_allclose(normal, [[1, 0, 0], [0, 0, -1]])
        numpy.testing.assert_allclose(distance, [2, 0.5])
        point, normal, distance = body.ray([[3, 0.1, 0.2], [3, 3, 3]], [[-2, 0, 0], [1, 0, 0]])
        self.assertAlmostEqual(distance[0], 2)
        self.assertTrue(math.isnan(distance[1]))
        again = sonde.Body.from_mesh(SimpleNamespace(vertices=body.vertices, faces=body.faces))
        self.assertAlmostEqual(again.measure, 8)
        with self.assertRaisesRegex(ValueError, "vertices and .faces"):
            sonde.Body.from_mesh(3)
        with self.assertRaisesRegex(sonde.InputError, "not finite"):
            body.inside([math.nan, 0, 0])

    def test_another_norm_makes_turns_dear(self):
        body = box()
        heavy = body.with_mass(inertia=4 * body.inertia)
        numpy.testing.assert_allclose(heavy.inertia, 4 * body.inertia)
        pose = [1.9, 0.1, 0.2, *TURNED]
        self.assertGreaterEqual(
            sonde.depth(heavy, body, pose).depth[0], sonde.depth(body, body, pose).depth[0] * 0.999
        )
        with self.assertRaisesRegex(sonde.InputError, "moments"):
            body.with_mass(inertia=[-1, 1, 1])

    def test_all_of_it_is_pickled_to_the_same_bits(self):
        pair, pose = boxes(), [1.9, 0.1, 0.2, *TURNED]
        expected = depth_of_one(pair, pose)
        cup = sonde.Body.read(os.path.join(MODELS, "cup.ply"))
        for body in (pair.probe, cup, box().offset(-0.1), box().with_mass(measure=3.0)):
            again = pickle.loads(pickle.dumps(body, 0))
            self.assertEqual(
                (again.measure, again.triangles, again.offset_by),
                (body.measure, body.triangles, body.offset_by),
            )
        self.assertEqual(depth_of_one(pickle.loads(pickle.dumps(pair, 1)), pose), expected)
        found = pair.depth([pose, at(3)])
        again = copy.deepcopy(found)
        for name in ("depth", "pose", "device", "contact_point", "status"):
            numpy.testing.assert_array_equal(getattr(again, name), getattr(found, name))
        with concurrent.futures.ProcessPoolExecutor(
            2, multiprocessing.get_context("spawn")
        ) as pool:
            self.assertEqual(pool.submit(depth_of_one, pair, pose).result(), expected)

    def test_a_file_that_changed_is_not_taken_for_the_body(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "box.off")
            def write(half):
                with open(file, "w", encoding="utf-8") as out:
                    rows = [f"{x} {y} {z}" for x, y, z in half * CORNERS]
                    rows += ["3 " + " ".join(map(str, face)) for face in FACES]
                    out.write("OFF\n8 12 0\n" + "\n".join(rows) + "\n")
            write(1.0)
            pickled = pickle.dumps(sonde.Body.read(file))
            pickle.loads(pickled)
            write(2.0)
            with self.assertRaisesRegex(sonde.InputError, "not what it was"):
                pickle.loads(pickled)

    def test_progress_is_told_and_ends_the_work(self):
        pair, told = spoon_and_cup(), []
        some = numpy.repeat(POSES[2900:3100:100], 10, axis=0)
        pair.depth(some, progress=told.append)
        self.assertTrue(all(0 <= x <= 1 for x in told) and sorted(told) == told and told)
        with self.assertRaises(sonde.Cancelled):
            pair.depth(numpy.repeat(some, 50, axis=0), progress=lambda done: False)
        with self.assertRaisesRegex(ZeroDivisionError, "division"):
            pair.depth(numpy.repeat(some, 50, axis=0), progress=lambda done: 1 / 0)

    # Reference: where the faces of two boxes pass each other, and the corner of a turning square.
    def test_depths_among_fewer_motions_of_boxes_are_known(self):
        pair = boxes()
        pose = at(1.5, 0.25, 0.5)
        along = pair.depth_along([pose, at(5)], [[0, 3, 0], [0, 0, 1], [0, -1, 0]])
        self.assertEqual(along.status.tolist(), ["penetrating", "separated"])
        self.assertAlmostEqual(along.depth[0], 1.5, delta=1e-12)
        numpy.testing.assert_allclose(along.pose[0, :3], [1.5, 0.25, 2.0], atol=1e-12)
        slid = pair.depth_in_plane(pose, [1, 0, 0], turning=False)
        self.assertAlmostEqual(slid.depth[0], 1.5, delta=2e-4)
        rolled = pair.depth_in_plane(pose, [1, 0, 0])
        self.assertLessEqual(rolled.depth[0], 1.5 + 2e-4)
        self.assertEqual(rolled.pose[0, 0], 1.5)
        # Hinged at its lower corner on the other's side: up and away by the angle at which the
        # upper corner of that side, a chord of length 2, is beside the other's face.
        hinge = [0.95, 0.0, 0.0]
        about = pair.depth_about(at(1.9), hinge, [0, 0, 2])
        self.assertEqual(about.status[0], "failed", "the hinge itself is within the other")
        hinge = [1.1, -1.0, 0.0]
        tilted = sonde.poses([0.0, 0.0, 0.0], matrix=turned(0.2))
        tilted[:3] = numpy.array(hinge) + turned(0.2) @ [1.0, 1.0, 0.0]
        about = pair.depth_about(tilted, hinge, [0, 0, 2])
        angle = 0.2 - math.asin(0.1 / 2)
        half = 2 * math.sin(angle / 2)
        self.assertAlmostEqual(about.depth[0], half * math.sqrt(2 + 8 / 12), delta=1e-10)
        self.assertFalse(pair.touch(about.pose[0]))
        for wrong in ([0, 0, 0], [math.nan, 0, 1]):
            with self.assertRaises(sonde.InputError):
                pair.depth_along(pose, wrong)
        with self.assertRaisesRegex(ValueError, "axis must be one"):
            pair.depth_about(pose, hinge, [[0, 0, 1], [0, 1, 0]])

    def test_a_pair_that_is_kept_answers_to_the_bit(self):
        pair = spoon_and_cup()
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "spoon-in-cup.pair")
            pair.write(file)
            again = sonde.Pair.read(file, pair.probe, pair.fixed)
            some = POSES[2900:2920]
            numpy.testing.assert_array_equal(again.depth(some).pose, pair.depth(some).pose)
            with self.assertRaisesRegex(sonde.InputError, "another probe"):
                sonde.Pair.read(file, pair.fixed, pair.probe)

    def test_a_body_that_python_has_let_go_of_lives_as_long_as_its_pair(self):
        follower = boxes().follower()
        self.assertEqual(follower.step(at(3)).status, "separated")
        self.assertEqual(follower.follow([at(2.5), at(1.9)]).status[1], "penetrating")

    def test_the_gripper_example_draws_its_clearance(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = os.path.join(folder, "clearance.png")
            example = os.path.join(SOURCE, "app", "python", "gripper_clearance.py")
            run = subprocess.run(
                [sys.executable, example, os.path.join(MODELS, "cup.ply"), picture],
                capture_output=True, text=True, check=True,
            )
            self.assertRegex(run.stdout, r"free down to [0-9.]+ mm")
            with open(picture, "rb") as file:
                self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n", run.stderr)


if __name__ == "__main__":
    unittest.main()
