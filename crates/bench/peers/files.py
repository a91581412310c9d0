"""Writes and reads files with meshio and laspy, and prints what that took as JSON.

    files.py versions
    files.py write FILE     the mesh in mesh.npy and mesh.points.npy beside it
    files.py read FILE      a mesh
    files.py points FILE    a cloud of points

The packages: numpy; meshio; laspy and lazrs.
"""

import contextlib
import pathlib
import sys

import numpy

from clock import begin, under_the_clock

PACKAGES = ["meshio", "laspy"]

# What meshio calls the formats whose endings do not say it. It reads all of Gmsh's by one name.
READ = {".msh": "gmsh", ".msh2": "gmsh", ".mesh": "medit"}
WRITTEN = READ | {".msh2": "gmsh22"}


def write(file):
    import meshio

    points = numpy.load(file.parent / "mesh.points.npy")[:, :2]
    triangles = numpy.load(file.parent / "mesh.npy")
    # Nearly all of its formats want space.
    points = numpy.column_stack([points, numpy.zeros(len(points))])
    mesh = meshio.Mesh(points, [("triangle", triangles)])
    _, cost = under_the_clock(lambda: mesh.write(file, file_format=WRITTEN.get(file.suffix)))
    return cost, len(points), len(triangles)


def read(file):
    import meshio

    mesh, cost = under_the_clock(lambda: meshio.read(file, file_format=READ.get(file.suffix)))
    return cost, len(mesh.points), sum(len(cells.data) for cells in mesh.cells if cells.type == "triangle")


def points(file):
    import laspy

    found, cost = under_the_clock(lambda: laspy.read(file).xyz)
    return cost, len(found), 0


def main(deed, file):
    deeds = {"write": write, "read": read, "points": points}
    # meshio prints what it thinks of a file.
    with contextlib.redirect_stdout(sys.stderr):
        cost, number, triangles = deeds[deed](pathlib.Path(file))
    return {**cost, "points": number, "triangles": triangles}


if __name__ == "__main__":
    begin(PACKAGES, main)
