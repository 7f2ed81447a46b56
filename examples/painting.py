# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of values on surfaces, drawn point by point and written as PNG: no window, no library."""

import math
import struct
import zlib

FINER = 2  # points to a pixel, along either direction


class Canvas:
    """Holds, for every point of a picture, the value of the surface that is nearest there."""

    def __init__(self, width: int, height: int):
        self.width, self.height = FINER * width, FINER * height
        self.depths = [-math.inf] * (self.width * self.height)
        self.values = [None] * (self.width * self.height)

    def draw(self, grid):
        """A surface as a grid of (x, y, depth, value): pixels right and down, larger depths nearer."""
        for row, next_row in zip(grid, grid[1:]):
            for k in range(len(row) - 1):
                self._triangle(row[k], row[k + 1], next_row[k])
                self._triangle(next_row[k + 1], next_row[k], row[k + 1])

    def _triangle(self, a, b, c):
        (ax, ay), (bx, by), (cx, cy) = ((FINER * p[0], FINER * p[1]) for p in (a, b, c))
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if area == 0.0:
            return
        for y in range(max(0, math.ceil(min(ay, by, cy))), min(self.height - 1, math.floor(max(ay, by, cy))) + 1):
            for x in range(max(0, math.ceil(min(ax, bx, cx))), min(self.width - 1, math.floor(max(ax, bx, cx))) + 1):
                s = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / area
                t = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / area
                if s < 0.0 or t < 0.0 or s + t > 1.0:
                    continue
                depth = s * a[2] + t * b[2] + (1.0 - s - t) * c[2]
                place = y * self.width + x
                if depth > self.depths[place]:
                    self.depths[place] = depth
                    self.values[place] = s * a[3] + t * b[3] + (1.0 - s - t) * c[3]

    def write(self, path: str, colour):
        """The picture; colour(value) is red, green and blue from 0 to 255, and nothing is white."""
        colours = [(255, 255, 255) if value is None else colour(value) for value in self.values]
        lines = bytearray()
        for y in range(0, self.height, FINER):
            lines.append(0)  # the line is not filtered
            for x in range(0, self.width, FINER):
                points = [colours[(y + i) * self.width + x + j] for i in range(FINER) for j in range(FINER)]
                lines.extend(round(sum(point[k] for point in points) / len(points)) for k in range(3))
        header = struct.pack(">IIBBBBB", self.width // FINER, self.height // FINER, 8, 2, 0, 0, 0)
        with open(path, "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\n")
            for kind, data in ((b"IHDR", header), (b"IDAT", zlib.compress(bytes(lines), 9)), (b"IEND", b"")):
                file.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)))


def seen(point, turn: float, tilt: float):
    """A point (x, y, z) seen from outside, turned and tilted by degrees: right, up, nearer."""
    x, y, z = point
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    x, y = c * x - s * y, s * x + c * y
    c, s = math.cos(math.radians(tilt)), math.sin(math.radians(tilt))
    return x, c * z + s * y, s * z - c * y


BLUE, GREY, RED = (20, 60, 200), (222, 222, 222), (205, 30, 30)


def heat(share: float):
    """Blue, grey, red for -1, 0, 1 and what lies between; beyond as there."""
    share = max(-1.0, min(1.0, share))
    end = RED if share > 0.0 else BLUE
    return tuple(round(middle + abs(share) * (far - middle)) for middle, far in zip(GREY, end))
