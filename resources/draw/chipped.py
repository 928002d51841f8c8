#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""chipped.py CUP.ply CHIPPED.ply: the example model of a cup, with two openings in its outer wall,
for the picture of what is mended."""
import math
import struct
import sys

source, target = sys.argv[1:]
with open(source, "rb") as file:
    data = file.read()
start = data.index(b"end_header\n") + len(b"end_header\n")
header = data[:start].decode()
vertices, triangles = [int(line.split()[2]) for line in header.splitlines()
                       if line.startswith("element")]
points = [struct.unpack_from("<3f", data, start + 12 * i) for i in range(vertices)]
first = start + 12 * vertices
faces = [struct.unpack_from("<3i", data, first + 13 * i + 1) for i in range(triangles)]


def middle(face):
    return [sum(points[i][k] for i in face) / 3 for k in range(3)]


def faces_out(face):
    (ax, ay, _), (bx, by, bz), (cx, cy, cz) = (points[i] for i in face)
    az = points[face[0]][2]
    normal = ((by - ay) * (cz - az) - (bz - az) * (cy - ay),
              (bz - az) * (cx - ax) - (bx - ax) * (cz - az))
    x, y, _ = middle(face)
    return normal[0] * x + normal[1] * y > 0


def near(face, degrees, height, by):
    """Whether a face of the outer wall is so near to a place of it, all in metres but the angle."""
    x, y, z = middle(face)
    wall = math.hypot(x, y)
    angle = math.radians(degrees)
    along = math.dist((x, y), (wall * math.cos(angle), wall * math.sin(angle)))
    return faces_out(face) and math.hypot(along, z - height) < by


holes = [(-90, 0.058), (-52, 0.035)]
faces = [face for face in faces if not any(near(face, *hole, 0.006) for hole in holes)]
with open(target, "wb") as file:
    file.write(header.replace(f"face {triangles}", f"face {len(faces)}").encode())
    file.write(data[start:first])
    for face in faces:
        file.write(struct.pack("<B3i", 3, *face))
