# SPDX-License-Identifier: GPL-3.0-or-later
"""Poses from rotations as other libraries hold them."""

from typing import Any, Optional

import numpy
from numpy.typing import ArrayLike, NDArray

Numbers = NDArray[numpy.float64]


def poses(
    translation: ArrayLike,
    *,
    rotation: Any = None,
    quaternion_wxyz: Optional[ArrayLike] = None,
    quaternion_xyzw: Optional[ArrayLike] = None,
    matrix: Optional[ArrayLike] = None,
) -> Numbers:
    """Poses (n, 7), px,py,pz,qw,qx,qy,qz, of translations (n, 3) or (3,), m, and of one kind of
    rotation (of none: unturned): a scipy.spatial.transform.Rotation, quaternions with the scalar
    first or last, (n, 4) or (4,), or matrices, (n, 3, 3) or (3, 3). A single one is (7,).
    """
    given = {
        "rotation": rotation,
        "quaternion_wxyz": quaternion_wxyz,
        "quaternion_xyzw": quaternion_xyzw,
        "matrix": matrix,
    }
    kinds = [name for name, value in given.items() if value is not None]
    if len(kinds) > 1:
        raise ValueError("give one kind of rotation, not " + " and ".join(kinds))
    at = _numbers("translation", translation, 3)
    if rotation is not None:
        if not hasattr(rotation, "as_quat"):
            raise ValueError("rotation must have as_quat(), as scipy's Rotation does")
        quaternion_xyzw = rotation.as_quat()
    if quaternion_xyzw is not None:
        name = kinds[0]
        q = _numbers(name, quaternion_xyzw, 4)[..., [3, 0, 1, 2]]
    elif quaternion_wxyz is not None:
        q = _numbers("quaternion_wxyz", quaternion_wxyz, 4)
    elif matrix is not None:
        q = _quaternion(_numbers("matrix", matrix, 3, 3))
    else:
        q = numpy.array([1.0, 0.0, 0.0, 0.0])
    norm = numpy.linalg.norm(q, axis=-1, keepdims=True)
    if not numpy.all(numpy.abs(norm - 1) <= 1e-3):
        raise ValueError("a quaternion has a length other than 1, by more than 0.001")
    q = q / norm
    if at.ndim == 2 and q.ndim == 2 and 1 not in (len(at), len(q)) and len(at) != len(q):
        raise ValueError(f"{len(at)} translations and {len(q)} rotations")
    shape = numpy.broadcast_shapes(at.shape[:-1], q.shape[:-1])
    return numpy.concatenate(
        [numpy.broadcast_to(at, (*shape, 3)), numpy.broadcast_to(q, (*shape, 4))], axis=-1
    )


def _numbers(name: str, given: ArrayLike, *last: int) -> Numbers:
    array = numpy.asarray(given)
    if array.dtype.kind not in "fiu":
        raise ValueError(f"{name} must be real numbers, not of type {array.dtype}")
    wanted = len(last)
    if array.ndim not in (wanted, wanted + 1) or array.shape[-wanted:] != last:
        shape = ", ".join(map(str, last))
        raise ValueError(f"{name} must be of shape ({shape}{',' * (wanted == 1)}) or (n, {shape})")
    array = array.astype(float)
    if not numpy.all(numpy.isfinite(array)):
        raise ValueError(f"{name} holds a number that is not finite")
    return array


def _quaternion(matrix: Numbers) -> Numbers:
    off = numpy.swapaxes(matrix, -1, -2) @ matrix - numpy.eye(3)
    if not (numpy.all(numpy.abs(off) <= 1e-3) and numpy.all(numpy.linalg.det(matrix) > 0)):
        raise ValueError("matrix is no rotation: its columns must be square to each other, of "
                         "length 1 and right-handed")
    # Of four forms the one that divides by the largest number (Shepperd, 1978).
    m = matrix.reshape(-1, 3, 3)
    xx, yy, zz = m[:, 0, 0], m[:, 1, 1], m[:, 2, 2]
    a, b, c = m[:, 2, 1] - m[:, 1, 2], m[:, 0, 2] - m[:, 2, 0], m[:, 1, 0] - m[:, 0, 1]
    d, e, f = m[:, 1, 0] + m[:, 0, 1], m[:, 0, 2] + m[:, 2, 0], m[:, 2, 1] + m[:, 1, 2]
    forms = numpy.stack(
        [
            numpy.stack([1 + xx + yy + zz, a, b, c], axis=-1),
            numpy.stack([a, 1 + xx - yy - zz, d, e], axis=-1),
            numpy.stack([b, d, 1 - xx + yy - zz, f], axis=-1),
            numpy.stack([c, e, f, 1 - xx - yy + zz], axis=-1),
        ],
        axis=1,
    )
    best = numpy.argmax(numpy.abs(numpy.diagonal(forms, axis1=1, axis2=2)), axis=1)
    q = forms[numpy.arange(len(m)), best]
    q = q / numpy.linalg.norm(q, axis=-1, keepdims=True)
    turned: Numbers = numpy.where(q[:, :1] < 0, -q, q).reshape(*matrix.shape[:-2], 4)
    return turned
