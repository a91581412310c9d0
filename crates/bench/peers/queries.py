"""Answers queries with SciPy, and prints what that took as JSON.

    queries.py versions
    queries.py QUESTION POINTS ASKED VALUES NUMBER check|time

QUESTION is locate, nearest, ten-nearest, voronoi, linear or clough-tocher. The files hold little-endian
doubles: the points, those that are asked about, of which the first NUMBER are, and a value for each point.
Only `check` sums up the answers. The packages: scipy and numpy.
"""

import os

# One thread, as all others; read when numpy is loaded.
os.environ["OPENBLAS_NUM_THREADS"] = "1"

import numpy

from clock import begin, under_the_clock

PACKAGES = ["scipy"]

# So many answers are summed up.
COMPARED = 20_000

# Cells are summed up whose corners are all farther from the border than this part of the width.
MARGIN = 0.0731


def after(first, last):
    """Returns what first and then last took."""
    total = {key: first[key] + last[key] for key in ("seconds", "user", "system")}
    memories = first["memory"], last["memory"]
    total["memory"] = None
    if None not in memories:
        peak = max(memory["peak"] for memory in memories)
        total["memory"] = {"before": memories[0]["before"], "peak": peak, "after": memories[1]["after"]}
    return total


def triangulate(points):
    """Returns a triangulation that is ready for queries; SciPy makes it so at the first one."""
    from scipy.spatial import Delaunay

    mesh = Delaunay(points)
    mesh.transform
    return mesh


def locate(points, asked, values):
    mesh, build = under_the_clock(lambda: triangulate(points))
    found, work = under_the_clock(lambda: mesh.find_simplex(asked))
    return build, work, lambda: (found[:COMPARED] >= 0).sum()


def near(number):
    def answer(points, asked, values):
        from scipy.spatial import cKDTree

        tree, build = under_the_clock(lambda: cKDTree(points))
        (_, found), work = under_the_clock(lambda: tree.query(asked, number))

        def total():
            ways = points[found.reshape(len(asked), -1)[:COMPARED]] - asked[:COMPARED, None]
            return (ways * ways).sum()

        return build, work, total

    return answer


def voronoi(points, asked, values):
    from scipy.spatial import Voronoi

    diagram, work = under_the_clock(lambda: Voronoi(points))
    return None, work, lambda: area_amid(points, diagram)


def area_amid(points, diagram):
    """Sums up the areas of the cells amid the bounds of the points."""
    bounded = [region for region in diagram.regions if region and min(region) >= 0]
    lengths = numpy.array([len(region) for region in bounded])
    starts = numpy.cumsum(lengths) - lengths
    corners = diagram.vertices[numpy.concatenate(bounded)]
    following = numpy.arange(1, len(corners) + 1)
    following[starts + lengths - 1] = starts
    low, high = points.min(axis=0), points.max(axis=0)
    share = (corners - low) / (high - low)
    is_amid = ((share >= MARGIN) & (share < 1 - MARGIN)).all(axis=1)
    origin = numpy.repeat(corners[starts], lengths, axis=0)
    p, q = corners - origin, corners[following] - origin
    areas = 0.5 * numpy.abs(numpy.add.reduceat(p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0], starts))
    return areas[numpy.logical_and.reduceat(is_amid, starts)].sum()


def surface(name):
    def answer(points, asked, values):
        import scipy.interpolate

        kind = getattr(scipy.interpolate, name)
        mesh, built = under_the_clock(lambda: triangulate(points))
        interpolate, build = under_the_clock(lambda: kind(mesh, values, fill_value=0.0))
        found, work = under_the_clock(lambda: interpolate(asked))
        return after(built, build), work, lambda: found[:COMPARED].sum()

    return answer


QUESTIONS = {
    "locate": locate,
    "nearest": near(1),
    "ten-nearest": near(10),
    "voronoi": voronoi,
    "linear": surface("LinearNDInterpolator"),
    "clough-tocher": surface("CloughTocher2DInterpolator"),
}


def main(question, points, asked, values, number, mode):
    points, asked = (numpy.fromfile(path, "<f8").reshape(-1, 2) for path in (points, asked))
    asked = asked[: int(number)]
    build, work, total = QUESTIONS[question](points, asked, numpy.fromfile(values, "<f8"))
    return {
        "build": build,
        "work": work,
        "number": len(points if question == "voronoi" else asked),
        "sum": float(total()) if mode == "check" else None,
    }


if __name__ == "__main__":
    begin(PACKAGES, main)
