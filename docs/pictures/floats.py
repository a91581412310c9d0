"""Draws where rounded arithmetic gives the wrong side of a line: docs/exactness.md says what is shown.

python3 docs/pictures/floats.py FILE.png; nothing but the standard library is needed.
"""

import struct
import sys
import zlib

SIDE, SCALE = 128, 3
UNIT = 2.0**-53
BLUE, YELLOW, RED = (70, 130, 200), (250, 215, 80), (205, 70, 70)


def rounded(p, q, r):
    """The determinant as everybody writes it, in doubles."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def exact(p, q, r):
    """The same in integers: coordinates are multiples of 2^-53."""
    return rounded(*([int(c / UNIT) for c in point] for point in (p, q, r)))


def colour(determinant):
    return RED if determinant < 0 else BLUE if determinant > 0 else YELLOW


def chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))


def main():
    q, r = (12.0, 12.0), (24.0, 24.0)
    gap = [(255, 255, 255)] * 16
    rows, wrong = [], 0
    for j in reversed(range(SIDE)):
        points = [(0.5 + i * UNIT, 0.5 + j * UNIT) for i in range(SIDE)]
        left, right = ([colour(sign(p, q, r)) for p in points] for sign in (rounded, exact))
        wrong += sum(a != b for a, b in zip(left, right))
        stretched = [[c for c in half for _ in range(SCALE)] for half in (left, right)]
        line = bytes(v for c in stretched[0] + gap + stretched[1] for v in c)
        rows += [b"\0" + line] * SCALE
    width = 2 * SIDE * SCALE + len(gap)
    header = struct.pack(">IIBBBBB", width, SIDE * SCALE, 8, 2, 0, 0, 0)
    with open(sys.argv[1], "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header))
        file.write(chunk(b"IDAT", zlib.compress(b"".join(rows), 9)) + chunk(b"IEND", b""))
    print(f"{wrong} of {SIDE * SIDE} wrong")


main()
