#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts by hand against label maps that this program makes by itself, voxel by voxel, from DEFINITION section 10.

independent_cuts.py BUILD scissors VOLUME          a star drawn on an oblique view
independent_cuts.py BUILD piece VOLUME.nii.gz LOW HIGH   what hangs together in the middle (8-bit NIfTI-1)

BUILD is a build folder with limn and tests/arm64/limn_picture_difference. Each picture is drawn twice, with the cut and
with the label map in its place, and the difference is printed in levels of 255, beside that to no cut.
"""
import gzip
import json
import math
import struct
import subprocess
import sys
import tempfile
from collections import deque
from pathlib import Path

CURVE = {"unit_distance_mm": 1.0, "points": [
    {"value": 40, "color": [0.70, 0.45, 0.35], "opacity": 0},
    {"value": 200, "color": [0.85, 0.70, 0.60], "opacity": 0.08},
    {"value": 500, "color": [1.0, 1.0, 1.0], "opacity": 0.4}]}


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(v):
    return [x / math.sqrt(dot(v, v)) for x in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


class Grid:
    """Where the voxels of a volume lie, as `limn info` tells it."""

    def __init__(self, limn, volume):
        told = json.loads(subprocess.run([limn, "info", volume, "--json"], capture_output=True, check=True).stdout)
        self.dims, self.origin = told["dims"], told["origin_mm"]
        self.axes = [[told["direction"][3 * row + axis] * told["spacing_mm"][axis] for row in range(3)]
                     for axis in range(3)]

    def place(self, index):
        return [self.origin[row] + sum(self.axes[axis][row] * index[axis] for axis in range(3)) for row in range(3)]

    def middle(self):
        return self.place([(count - 1) / 2 for count in self.dims])

    def camera(self, direction):
        away = unit(direction)
        return {"projection": "perspective", "position": [m + 480 * a for m, a in zip(self.middle(), away)],
                "target": self.middle(), "up": [0.0, 0.1, 1.0], "fov_y_deg": 30.0}

    def write(self, path, marked):
        axes = " ".join("(%r,%r,%r)" % tuple(axis) for axis in self.axes)
        header = ("NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\n"
                  "sizes: %d %d %d\nspace directions: %s\nkinds: domain domain domain\nencoding: raw\n"
                  "space origin: (%r,%r,%r)\n\n" % (*self.dims, axes, *self.origin))
        Path(path).write_bytes(header.encode() + bytes(marked))


def is_inside(polygon, x, y):
    inside = False
    for (xi, yi), (xj, yj) in zip(polygon, polygon[-1:] + polygon[:-1]):
        if (yi > y) != (yj > y) and x < (xj - xi) * (y - yi) / (yj - yi) + xi:
            inside = not inside
    return inside


def cut_by_scissors(grid, camera, polygon):
    forward = unit([t - p for t, p in zip(camera["target"], camera["position"])])
    right = unit(cross(forward, camera["up"]))
    frame = [right, cross(right, forward), forward]
    half = math.tan(math.radians(camera["fov_y_deg"]) / 2)
    start = [dot([o - p for o, p in zip(grid.origin, camera["position"])], one) for one in frame]
    steps = [[dot(axis, one) for one in frame] for axis in grid.axes]
    width, height, depth = grid.dims
    marked = bytearray(width * height * depth)
    for k in range(depth):
        for j in range(height):
            row = [start[n] + steps[1][n] * j + steps[2][n] * k for n in range(3)]
            for i in range(width):
                z = (row[2] + steps[0][2] * i) * half
                if z > 0 and is_inside(polygon, (row[0] + steps[0][0] * i) / z, (row[1] + steps[0][1] * i) / z):
                    marked[(k * height + j) * width + i] = 1
    return marked


def piece_around_the_middle(grid, path, low, high):
    """The marked voxels, and the seed."""
    raw = gzip.open(path).read()
    slope, first = struct.unpack("<f", raw[112:116])[0], int(struct.unpack("<f", raw[108:112])[0])
    width, height, depth = grid.dims
    count = width * height * depth
    in_range = raw[first:first + count].translate(bytes(low <= stored * slope <= high for stored in range(256)))
    seed = in_range.find(1, ((depth // 2) * height + height // 2) * width + width // 2)

    def neighbours(voxel, most):
        x, y, z = voxel % width, voxel // width % height, voxel // (width * height)
        for c in (-1, 0, 1):
            for b in (-1, 0, 1):
                for a in (-1, 0, 1):
                    if 0 < abs(a) + abs(b) + abs(c) <= most and 0 <= x + a < width and 0 <= y + b < height \
                            and 0 <= z + c < depth:
                        yield ((z + c) * height + y + b) * width + x + a

    marked = bytearray(count)
    marked[seed] = 1
    found = [seed]
    waiting = deque(found)
    while waiting:
        for other in neighbours(waiting.popleft(), 3):
            if in_range[other] and not marked[other]:
                marked[other] = 1
                found.append(other)
                waiting.append(other)
    for voxel in found:  # grown by a ball of one voxel
        for other in neighbours(voxel, 1):
            marked[other] = 1
    return marked, grid.place([seed % width, seed // width % height, seed // (width * height)])


def main():
    build, kind, volume = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    limn = str(build / "limn")
    grid = Grid(limn, volume)
    with tempfile.TemporaryDirectory() as folder:
        def draw(name, keep):
            scene = {"limn_scene": 1, "volume": str(Path(volume).resolve()), "transfer_function": CURVE,
                     "camera": grid.camera([-0.4, -1.0, 0.5]), "quality": {"step_voxels": 0.5}, "keep": keep}
            Path(folder, name + ".json").write_text(json.dumps(scene))
            subprocess.run([limn, "render", f"{folder}/{name}.json", "--size", "512x512", "--engine", "cpu", "--quiet",
                            "-o", f"{folder}/{name}.png"], check=True)

        if kind == "scissors":
            star = [((0.55 if n % 2 else 0.25) * math.cos(0.63 * n + 0.3) + 0.1,
                     (0.55 if n % 2 else 0.25) * math.sin(0.63 * n + 0.3)) for n in range(10)]
            drawn = grid.camera([0.7, -1.0, 0.35])
            marked = cut_by_scissors(grid, drawn, star)
            cut = {"scissors": {"camera": drawn, "aspect": 1.0, "polygon": star, "remove": "inside", "depth_mm": None}}
        else:
            low, high = float(sys.argv[4]), float(sys.argv[5])
            marked, seed = piece_around_the_middle(grid, volume, low, high)
            cut = {"piece": {"seed_mm": seed, "range": [low, high], "grow_voxels": 1, "do": "hide"}}
        grid.write(f"{folder}/marked.nrrd", marked)
        draw("cut", [cut])
        draw("map", {"labels": f"{folder}/marked.nrrd", "weights": {"1": 0}})
        draw("whole", "all")
        print(f"{sum(marked)} voxels")
        for other in ("map", "whole"):
            print(f"cut and {other}:", subprocess.run(
                [str(build / "tests/arm64/limn_picture_difference"), f"{folder}/cut.png", f"{folder}/{other}.png", "0.3"],
                capture_output=True, text=True, check=False).stdout.strip())


main()
