#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of pictures, without light on its way and with it, in which a reader tells the nearer of two marks.

    light_pairs.py LIMN DATA FOLDER [SEED]

For each of four views of five volumes of the shared data two places are chosen by chance: both on opaque tissue, off
edges, 60 to 160 pixels apart, and 6 to 30 mm apart in depth. FOLDER gets `off-NN.png` (a headlight, no shadow),
`on-NN.png` (Soft studio) with the same marks, A red and B cyan, and, apart, `answers/answers.txt`: which mark is
nearer, and by how many mm. The order of the pairs is shuffled. Judge all of `off`, then all of `on`, then open the answers.

Depth is what the program itself tells of the volume: the picture in white without light under linear fog is darker by
the mean distance of what is seen, in 1/255 of 300 mm; nothing of light enters it.
"""
import json
import random
import struct
import subprocess
import sys
import zlib
from pathlib import Path

VOLUMES = [("cta_brain_avm/cta_brain_avm_uint8.nii.gz", 0), ("mr_t1_head/mr_t1_head.nii.gz", 1),
           ("ct_head_cranium/ct_head_cranium.nii.gz", 2), ("classic/engine.nii.gz", 3), ("classic/bonsai.nii.gz", 4)]
SIZE = 384
RANGE_MM = 300.0


def read_png(path):
    """Width, height, rows of (r, g, b), and the texts in it; 8 bits, RGB or RGBA."""
    data = path.read_bytes()
    at, packed, texts = 8, b"", []
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            assert depth == 8 and color in (2, 6), path
        elif kind == b"IDAT":
            packed += body
        elif kind in (b"tEXt", b"iTXt", b"zTXt"):
            texts.append((kind, body))
        at += 12 + length
    each = 3 if color == 2 else 4
    raw, rows, before = zlib.decompress(packed), [], bytearray(width * each)
    for y in range(height):
        start = y * (width * each + 1)
        filtered, row = raw[start], bytearray(raw[start + 1:start + 1 + width * each])
        for i in range(len(row)):
            left = row[i - each] if i >= each else 0
            corner = before[i - each] if i >= each else 0
            if filtered == 1:
                row[i] = (row[i] + left) & 255
            elif filtered == 2:
                row[i] = (row[i] + before[i]) & 255
            elif filtered == 3:
                row[i] = (row[i] + (left + before[i]) // 2) & 255
            elif filtered == 4:
                guess = left + before[i] - corner
                off = (abs(guess - left), abs(guess - before[i]), abs(guess - corner))
                best = left if off[0] <= off[1] and off[0] <= off[2] else before[i] if off[1] <= off[2] else corner
                row[i] = (row[i] + best) & 255
        rows.append([tuple(row[each * x:each * x + 3]) for x in range(width)])
        before = row
    return rows, texts


def write_png(path, rows):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    raw = b"".join(b"\0" + bytes(c for pixel in row for c in pixel) for row in rows)
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
                     chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))


def scene_in(texts):
    for kind, body in texts:
        text = body.split(b"\0", 1)[1]
        if kind == b"iTXt":
            packed, text = text[0], text[2:].split(b"\0", 2)[2]
            text = zlib.decompress(text) if packed else text
        elif kind == b"zTXt":
            text = zlib.decompress(text[1:])
        if b"limn_scene" in text:
            return json.loads(text)
    raise SystemExit("no scene in the picture")


def mark(rows, place, color):
    x0, y0 = place
    for y in range(y0 - 9, y0 + 10):
        for x in range(x0 - 9, x0 + 10):
            away = ((x - x0) ** 2 + (y - y0) ** 2) ** 0.5
            if 0 <= y < len(rows) and 0 <= x < len(rows[0]) and 4.5 <= away <= 8.5:
                rows[y][x] = color if 5.5 <= away <= 7.5 else (0, 0, 0)


def main():
    limn, data, folder = sys.argv[1], Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve()
    chance = random.Random(int(sys.argv[4]) if len(sys.argv) > 4 else 34)
    (folder / "answers").mkdir(parents=True, exist_ok=True)
    scratch = folder / "scratch"
    scratch.mkdir(exist_ok=True)

    def render(source, name, *options):
        out = scratch / name
        subprocess.run([limn, "render", str(source), "--quiet", "--engine", "cpu", "--size", f"{SIZE}x{SIZE}", *options,
                        "-o", str(out)], check=True, stdout=subprocess.DEVNULL)
        return read_png(out)

    pairs = []
    for volume, number in VOLUMES:
        views, found = iter(range(9)), 0
        while found < 4:  # thin vessels may have no such places
            turn = f"{(8 * next(views) + number + 1) % 36}/36"
            off, texts = render(data / volume, "off.png", "--light", "headlight", "--turn", turn)
            on, _ = render(data / volume, "on.png", "--light", "soft-studio", "--turn", turn)
            scene = scene_in(texts)
            scene["volume"] = str(data / volume)
            for point in scene["transfer_function"]["points"]:
                point["color"] = [1, 1, 1]
            scene["shading"]["model"] = "none"
            scene["image"]["background"] = [0, 0, 0]
            camera = scene["camera"]
            away = sum((a - b) ** 2 for a, b in zip(camera["position"], camera["target"])) ** 0.5
            plain, fogged = scratch / "plain.json", scratch / "fogged.json"
            plain.write_text(json.dumps(scene))
            scene["fog"] = {"mode": "linear", "color": [0, 0, 0], "start_mm": max(0.0, away - RANGE_MM / 2),
                            "end_mm": max(0.0, away - RANGE_MM / 2) + RANGE_MM}
            fogged.write_text(json.dumps(scene))
            alpha, _ = render(plain, "alpha.png")
            fog, _ = render(fogged, "fog.png")

            def depth(x, y):
                return RANGE_MM * (1.0 - fog[y][x][0] / alpha[y][x][0]) if alpha[y][x][0] >= 242 else None

            def steady(x, y):
                around = [depth(x + i, y + j) for i in (-4, 0, 4) for j in (-4, 0, 4)]
                return None not in around and max(around) - min(around) < 5.0

            for _ in range(200000):
                a, b = [(chance.randrange(20, SIZE - 20), chance.randrange(20, SIZE - 20)) for _ in range(2)]
                apart = ((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5
                if not 60 <= apart <= 160 or not steady(*a) or not steady(*b):
                    continue
                nearer = depth(*b) - depth(*a)
                if 6.0 <= abs(nearer) <= 30.0:
                    pairs.append((off, on, a, b, nearer, f"{volume} {turn}"))
                    found += 1
                    break
            print(volume, turn, len(pairs), flush=True)
    chance.shuffle(pairs)
    lines = []
    for number, (off, on, a, b, nearer, what) in enumerate(pairs, 1):
        for name, rows in (("off", off), ("on", on)):
            rows = [list(row) for row in rows]
            mark(rows, a, (255, 60, 60))
            mark(rows, b, (60, 230, 255))
            write_png(folder / f"{name}-{number:02}.png", rows)
        lines.append(f"{number:02} {'A' if nearer > 0 else 'B'} {abs(nearer):.1f} mm {what}")
    (folder / "answers" / "answers.txt").write_text("\n".join(lines) + "\n")


main()
