"""Refines one domain with a peer that Python can reach, and prints what that took as JSON.

    refine.py versions
    refine.py triangle|cgal|gmsh DOMAIN.json ANGLE AREA check|time

ANGLE is the smallest angle in degrees, AREA the largest area, 0 for no bound. The domain has points,
segments that run with the domain on their left (each outline before its holes), and a point in each
hole. Only `check` counts and measures triangles. The packages: triangle, cgal, gmsh; and numpy.

What is timed begins with arrays (for gmsh: with its own geometry) and ends with the peer's own result.
Triangle is called in C, beside its Python module, so no conversion is timed. CGAL's points are inserted
one by one, as its module offers nothing else.
"""

import ctypes
import json
import math

from clock import begin, under_the_clock

PACKAGES = ["triangle", "cgal", "gmsh"]

# An angle or area that misses its bound by less is counted as rounding.
SLACK = 1e-9


def quality(corners, angle, area):
    """Measures triangles, given as an array of n triples of points."""
    import numpy

    sides = numpy.roll(corners, -1, axis=1) - corners
    behind = -numpy.roll(sides, 1, axis=1)
    cross = sides[:, :, 0] * behind[:, :, 1] - sides[:, :, 1] * behind[:, :, 0]
    dot = (sides * behind).sum(axis=2)
    angles = numpy.degrees(numpy.arctan2(cross, dot)).min(axis=1)
    areas = 0.5 * cross[:, 0]
    return {
        "triangles": len(corners),
        "min_angle": float(angles.min()),
        "max_area": float(areas.max()),
        "area": float(areas.sum()),
        "skinny": int((angles < angle * (1 - SLACK)).sum()),
        "oversized": int((areas > area * (1 + SLACK)).sum()) if area else 0,
        "unexcused": None,
        "hash": None,
    }


class TriangleIo(ctypes.Structure):
    """`struct triangulateio`, as Triangle's manual describes it."""

    _fields_ = [
        ("pointlist", ctypes.POINTER(ctypes.c_double)),
        ("pointattributelist", ctypes.POINTER(ctypes.c_double)),
        ("pointmarkerlist", ctypes.POINTER(ctypes.c_int)),
        ("numberofpoints", ctypes.c_int),
        ("numberofpointattributes", ctypes.c_int),
        ("trianglelist", ctypes.POINTER(ctypes.c_int)),
        ("triangleattributelist", ctypes.POINTER(ctypes.c_double)),
        ("trianglearealist", ctypes.POINTER(ctypes.c_double)),
        ("neighborlist", ctypes.POINTER(ctypes.c_int)),
        ("numberoftriangles", ctypes.c_int),
        ("numberofcorners", ctypes.c_int),
        ("numberoftriangleattributes", ctypes.c_int),
        ("segmentlist", ctypes.POINTER(ctypes.c_int)),
        ("segmentmarkerlist", ctypes.POINTER(ctypes.c_int)),
        ("numberofsegments", ctypes.c_int),
        ("holelist", ctypes.POINTER(ctypes.c_double)),
        ("numberofholes", ctypes.c_int),
        ("regionlist", ctypes.POINTER(ctypes.c_double)),
        ("numberofregions", ctypes.c_int),
        ("edgelist", ctypes.POINTER(ctypes.c_int)),
        ("edgemarkerlist", ctypes.POINTER(ctypes.c_int)),
        ("normlist", ctypes.POINTER(ctypes.c_double)),
        ("numberofedges", ctypes.c_int),
    ]


class Triangle:
    def __init__(self, domain, angle, area):
        import numpy
        import triangle.core

        self.library = ctypes.CDLL(triangle.core.__file__)
        self.points = numpy.array(domain["points"], dtype=numpy.float64)
        self.segments = numpy.array(domain["segments"], dtype=numpy.int32)
        self.holes = numpy.array(domain["holes"], dtype=numpy.float64).reshape(-1, 2)
        double, integer = (ctypes.POINTER(t) for t in (ctypes.c_double, ctypes.c_int))
        self.input = TriangleIo(
            pointlist=self.points.ctypes.data_as(double),
            numberofpoints=len(self.points),
            segmentlist=self.segments.ctypes.data_as(integer),
            numberofsegments=len(self.segments),
            holelist=self.holes.ctypes.data_as(double),
            numberofholes=len(self.holes),
        )
        self.output = TriangleIo()
        # Triangle reads no exponents.
        self.switches = f"pzQq{angle:.6f}" + (f"a{area:.20f}" if area else "")

    def refine(self):
        self.library.triangulate(
            self.switches.encode(), ctypes.byref(self.input), ctypes.byref(self.output), None
        )

    def corners(self):
        import numpy

        output = self.output
        points = numpy.ctypeslib.as_array(output.pointlist, (output.numberofpoints, 2))
        triangles = numpy.ctypeslib.as_array(output.trianglelist, (output.numberoftriangles, 3))
        return points[triangles]


class Cgal:
    def __init__(self, domain, angle, area):
        from CGAL import CGAL_Mesh_2
        from CGAL.CGAL_Kernel import Point_2

        self.module = CGAL_Mesh_2
        self.points = [Point_2(x, y) for x, y in domain["points"]]
        self.segments = domain["segments"]
        self.seeds = [Point_2(x, y) for x, y in domain["holes"]]
        # Its size bound is for edges: the edge of the equilateral triangle.
        edge = math.sqrt(4 * area / math.sqrt(3))
        bound = math.sin(math.radians(angle)) ** 2
        self.criteria = CGAL_Mesh_2.Delaunay_mesh_size_criteria_2(bound, edge)

    def refine(self):
        self.mesh = self.module.Mesh_2_Constrained_Delaunay_triangulation_2()
        vertices = [self.mesh.insert(point) for point in self.points]
        for a, b in self.segments:
            self.mesh.insert_constraint(vertices[a], vertices[b])
        self.module.refine_Delaunay_mesh_2(self.mesh, self.seeds, self.criteria)

    def corners(self):
        import numpy

        faces = [face for face in self.mesh.finite_faces() if face.is_in_domain()]
        points = [face.vertex(k).point() for face in faces for k in range(3)]
        return numpy.array([(p.x(), p.y()) for p in points]).reshape(-1, 3, 2)


class Gmsh:
    def __init__(self, domain, angle, area):
        import gmsh

        self.module = gmsh
        gmsh.initialize(interruptible=False)
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("General.NumThreads", 1)
        # The edge of the equilateral triangle; inside, sizes follow the pieces of the border.
        edge = math.sqrt(4 * area / math.sqrt(3)) if area else math.inf
        gmsh.option.setNumber("Mesh.MeshSizeMax", min(edge, 1e22))
        self.draw(domain, edge)

    def draw(self, domain, edge):
        """Draws the domain; segments are cut into pieces no longer than `edge`."""
        geometry = self.module.model.geo
        points, segments = domain["points"], domain["segments"]
        tags = [geometry.addPoint(x, y, 0) for x, y in points]
        surfaces, ring, twice_area = [], [], 0.0
        for a, b in segments:
            line = geometry.addLine(tags[a], tags[b])
            pieces = max(1, math.ceil(math.dist(points[a], points[b]) / edge))
            geometry.mesh.setTransfiniteCurve(line, pieces + 1)
            ring.append(line)
            twice_area += points[a][0] * points[b][1] - points[a][1] * points[b][0]
            if len(ring) == 1:
                first = a
            if b == first:
                loop = geometry.addCurveLoop(ring)
                if twice_area > 0:
                    surfaces.append([])
                surfaces[-1].append(loop)
                ring, twice_area = [], 0.0
        for loops in surfaces:
            geometry.addPlaneSurface(loops)
        geometry.synchronize()

    def refine(self):
        self.module.model.mesh.generate(2)

    def corners(self):
        import numpy

        tags, points, _ = self.module.model.mesh.getNodes()
        place = numpy.zeros((int(tags.max()) + 1, 2))
        place[tags] = points.reshape(-1, 3)[:, :2]
        _, nodes = self.module.model.mesh.getElementsByType(2)
        return place[nodes.reshape(-1, 3)]


def main(peer, path, angle, area, mode):
    with open(path) as file:
        domain = json.load(file)
    angle, area = float(angle), float(area)
    engine = {"triangle": Triangle, "cgal": Cgal, "gmsh": Gmsh}[peer](domain, angle, area)
    _, answer = under_the_clock(engine.refine)
    answer["quality"] = quality(engine.corners(), angle, area) if mode == "check" else None
    return answer


if __name__ == "__main__":
    begin(PACKAGES, main)
