#!/usr/bin/env python3
"""Draws assets/textures/*.png and assets/models/vase.obj, byte for byte the same every time.

Run from anywhere: python3 tests/tools/make_textures.py. Needs nothing but Python 3; the build does not run it.
The pictures tile (they repeat without a seam) and are light in colour, so that coloured lights show on them.
"""
import math
import multiprocessing
import struct
import zlib
from pathlib import Path

ASSETS = Path(__file__).resolve().parents[2] / "assets"


def hashed(x, y, seed):
    """A number in [0, 1) that depends on three integers and nothing else."""
    h = (x * 374761393 + y * 668265263 + seed * 1442695041) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
    return ((h ^ (h >> 16)) & 0xFFFFFF) / 0x1000000


def noise(u, v, columns, rows, seed):
    """Smooth noise in [0, 1) over the unit square, periodic in both directions."""
    x, y = u * columns, v * rows
    i, j = math.floor(x), math.floor(y)
    fx, fy = x - i, y - j
    fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)

    def at(a, b):
        return hashed((i + a) % columns, (j + b) % rows, seed)

    top = at(0, 0) + (at(1, 0) - at(0, 0)) * fx
    bottom = at(0, 1) + (at(1, 1) - at(0, 1)) * fx
    return top + (bottom - top) * fy


def turbulence(u, v, columns, rows, seed, octaves=4):
    """Noise of several scales, in [0, 1)."""
    total, weight, sum_of_weights = 0.0, 1.0, 0.0
    for octave in range(octaves):
        total += weight * noise(u, v, columns << octave, rows << octave, seed + octave)
        sum_of_weights += weight
        weight /= 2
    return total / sum_of_weights


def steps(value, count):
    """Few shades keep the files small."""
    return min(max(math.floor(value * count), 0), count - 1) / (count - 1)


def mix(a, b, t):
    return tuple(p + (q - p) * t for p, q in zip(a, b))


def checker(u, v):
    return (0.95, 0.92, 0.85) if (math.floor(u * 8) + math.floor(v * 8)) % 2 == 0 else (0.28, 0.36, 0.52)


def bricks(u, v):
    rows, columns = 8, 4
    row = math.floor(v * rows)
    shifted = (u + (0.5 / columns if row % 2 else 0)) % 1
    column = math.floor(shifted * columns)
    x, y = shifted * columns - column, v * rows - row
    grain = steps(turbulence(u, v, 32, 32, 5, 2), 8)
    if min(x, 1 - x) < 0.03 or min(y, 1 - y) < 0.06:
        return mix((0.80, 0.78, 0.74), (0.90, 0.88, 0.84), grain)
    tint = steps(hashed(column, row, 11), 6)
    return mix(mix((0.72, 0.46, 0.36), (0.88, 0.66, 0.52), tint), (1, 0.85, 0.75), 0.25 * grain)


def wood(u, v):
    bend = turbulence(u, v, 2, 3, 21, 3)
    ring = 0.5 + 0.5 * math.sin(2 * math.pi * (6 * u + 2.2 * bend))
    fibre = noise(u, v, 64, 4, 31)
    shade = 0.7 * ring**1.5 + 0.3 * fibre
    return mix((0.93, 0.78, 0.56), (0.66, 0.45, 0.26), steps(shade, 24))


def marble(u, v):
    cloud = turbulence(u, v, 3, 3, 41, 5)
    vein = abs(math.sin(math.pi * (2 * u + 2 * v + 3.0 * cloud)))
    return mix((0.52, 0.56, 0.64), (0.98, 0.97, 0.95), steps(vein**0.45, 32))


def tiles(u, v):
    count = 4
    column, row = math.floor(u * count), math.floor(v * count)
    x, y = u * count - column, v * count - row
    edge = min(x, 1 - x, y, 1 - y)
    if edge < 0.04:
        return (0.62, 0.62, 0.60)
    base = (0.93, 0.93, 0.90) if (column + row) % 2 == 0 else (0.70, 0.78, 0.84)
    spot = steps(turbulence(u, v, 16, 16, 51, 3), 10)
    bevel = 0.88 if edge < 0.08 else 1
    return tuple(bevel * channel for channel in mix(base, (0.80, 0.82, 0.82), 0.35 * spot))


def chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))


def softened(rows, sigma):
    """The picture blurred by a Gaussian of `sigma` texels, periodically. A float32 texture coordinate is good to about
    1e-4 of a texel: across a hard edge between two texels that alone would be an error of 1e-4 in the picture."""
    side, reach = len(rows), math.ceil(2.8 * sigma)
    weights = [math.exp(-0.5 * (k / sigma) ** 2) for k in range(-reach, reach + 1)]
    total = sum(weights)

    def along(line):
        channels = []
        for channel in zip(*line):
            wrapped = channel[-reach:] + channel + channel[:reach]
            channels.append([sum(w * wrapped[i + k] for k, w in enumerate(weights)) / total for i in range(side)])
        return list(zip(*channels))

    across = [along(row) for row in rows]
    columns = [along([across[y][x] for y in range(side)]) for x in range(side)]
    return [[columns[x][y] for x in range(side)] for y in range(side)]


LEFT, ABOVE = 1, 2  # PNG's filters "Sub" and "Up"


def filtered(kind, row, above, size):
    """A row as PNG stores it, less the pixels to the left or above; `size`: bytes a pixel."""
    guesses = [0] * size + row[:-size] if kind == LEFT else above
    return bytes([kind]) + bytes((level - guess) & 255 for level, guess in zip(row, guesses))


def png(pixel, side, sigma, kind):
    """A PNG of pixel(u, v), u to the right, v downwards: of up to 256 colours, by their number, the darkest first.

    Rows are stored under one filter: those that look at more pixels hide repetition from how the page is packed."""
    picture = [[bytes(round(255 * c) for c in colour) for colour in row] for row in softened(
        [[pixel((x + 0.5) / side, (y + 0.5) / side) for x in range(side)] for y in range(side)], sigma)]
    colours = sorted({colour for row in picture for colour in row}, key=lambda colour: (sum(colour), colour))
    palette = len(colours) <= 256
    number = {colour: bytes([i & 255]) if palette else colour for i, colour in enumerate(colours)}
    rows = [list(b"".join(number[colour] for colour in row)) for row in picture]
    above = [[0] * len(rows[0]), *rows[:-1]]
    stored = b"".join(filtered(kind, *near, 1 if palette else 3) for near in zip(rows, above))
    header = struct.pack(">IIBBBBB", side, side, 8, 3 if palette else 2, 0, 0, 0)
    table = chunk(b"PLTE", b"".join(colours)) if palette else b""
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + table + chunk(b"IDAT", zlib.compress(stored, 9))
            + chunk(b"IEND", b""))


def vase():
    """A turned vase with a wall that has a thickness: a closed mesh of triangles, without normals.

    Its quads are split here: computed normals weigh whole faces, and scenes and figures show it by those of triangles.

    Rings at a sharp edge (foot, lip) stand twice in the profile: computed normals are not smoothed across it.
    """
    outside = [(0.0, 0.0), (0.36, 0.0), (0.36, 0.0), (0.40, 0.05), (0.50, 0.22), (0.60, 0.45), (0.62, 0.66),
               (0.54, 0.90), (0.38, 1.12), (0.28, 1.28), (0.27, 1.42), (0.34, 1.56), (0.43, 1.64), (0.43, 1.64)]
    inside = [(0.36, 1.64), (0.36, 1.64), (0.27, 1.54), (0.22, 1.42), (0.23, 1.28), (0.33, 1.10), (0.48, 0.88),
              (0.55, 0.66), (0.52, 0.45), (0.40, 0.22), (0.0, 0.12)]
    profile, segments = outside + inside, 32
    lines = ["# A vase, turned about the y axis. Made by tests/tools/make_textures.py.", "o vase"]
    first = {}  # index of the first v of each ring; the two ends are single points
    count = 1
    for i, (radius, height) in enumerate(profile):
        first[i] = count
        around = segments if radius > 0 else 1
        for j in range(around):
            angle = 2 * math.pi * j / segments
            lines.append(f"v {radius * math.cos(angle):.6f} {height:.6f} {radius * math.sin(angle):.6f}")
        count += around
    last = len(profile) - 1
    along = [0.0]  # the profile's length up to each ring: the texture is stretched alike everywhere
    for one, next_one in zip(profile, profile[1:]):
        along.append(along[-1] + math.dist(one, next_one))
    for length in along:
        lines += [f"vt {j / segments:.6f} {length / along[last]:.6f}" for j in range(segments + 1)]

    def corner(i, j):
        single = profile[i][0] == 0
        return f"{first[i] + (0 if single else j % segments)}/{i * (segments + 1) + j + 1}"

    for i in range(last):
        if profile[i] == profile[i + 1]:
            continue
        for j in range(segments):
            corners = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)]
            if profile[i][0] == 0:
                corners.pop(3)
            elif profile[i + 1][0] == 0:
                corners.pop(2)
            lines += [f"f {corners[0]} {corners[k]} {corners[k + 1]}" for k in range(1, len(corners) - 1)]
    return "\n".join(lines) + "\n"


# Side and blur in texels: each is to have a texel a pixel where scenes show it at 1920x1080, and to be as sharp as float32
# coordinates can hold within 2e-5. Then the filter of filtered() that packs best.
TEXTURES = ((checker, 512, 4, LEFT), (bricks, 256, 2.5, LEFT), (wood, 1024, 5.5, ABOVE), (marble, 1024, 7, LEFT),
            (tiles, 512, 2.5, LEFT))


def write_texture(texture):
    path = ASSETS / "textures" / f"{texture[0].__name__}.png"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(png(*texture))


def main():
    with multiprocessing.Pool() as pool:
        pool.map(write_texture, TEXTURES, 1)
    model = ASSETS / "models" / "vase.obj"
    model.parent.mkdir(parents=True, exist_ok=True)
    model.write_text(vase())


if __name__ == "__main__":
    main()
