"""Prints as JSON what meshio, Gmsh and VTK read in files: python read.py FILE...

Of each file and reader the points, triangles, lines, data of points and of triangles, and what Gmsh warns of.
"""

import json
import sys

import gmsh
import meshio
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def listed(values):
    return [None if np.isnan(v) else float(v) for v in np.ravel(values)]


def by_meshio(name):
    kind = {"vtk": "vtk", "vtu": "vtu"}.get(name[-3:], "gmsh")
    mesh = meshio.read(name, file_format=kind)
    found = {"points": np.asarray(mesh.points)[:, :2].tolist(), "triangles": [], "lines": [], "data": {}, "cells": {}}
    found["data"] = {key: listed(values) for key, values in mesh.point_data.items()}
    for i, block in enumerate(mesh.cells):
        kind = {"triangle": "triangles", "line": "lines"}.get(block.type)
        if kind:
            found[kind] += block.data.tolist()
        if kind == "triangles":
            for key, values in mesh.cell_data.items():
                found["cells"].setdefault(key, []).extend(listed(values[i]))
    return found


def by_gmsh(name):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.logger.start()
    gmsh.open(name)
    nodes, places, _ = gmsh.model.mesh.getNodes()
    order = np.argsort(nodes)
    found = {"points": places.reshape(-1, 3)[order, :2].tolist(), "cells": {}, "data": {}}
    for dimension, kind in [(2, "triangles"), (1, "lines")]:
        rows = {}
        for entity in gmsh.model.getEntities(dimension):
            for k, tags, corners in zip(*gmsh.model.mesh.getElements(*entity)):
                width = gmsh.model.mesh.getElementProperties(k)[3]
                for tag, row in zip(tags, corners.reshape(-1, width)):
                    rows[int(tag)] = [int(v) - 1 for v in row[: dimension + 1]]
        found[kind] = [rows[tag] for tag in sorted(rows)]
        if dimension == 2:
            found["tags"] = sorted(rows)
    groups = {}
    for dimension, tag in gmsh.model.getPhysicalGroups():
        entities = gmsh.model.getEntitiesForPhysicalGroup(dimension, tag)
        counts = [sum(map(len, gmsh.model.mesh.getElements(dimension, e)[1])) for e in entities]
        groups[gmsh.model.getPhysicalName(dimension, tag)] = [dimension, int(tag), sum(counts)]
    found["groups"] = groups
    for view in gmsh.view.getTags():
        kind, tags, values, _, _ = gmsh.view.getModelData(view, 0)
        title = gmsh.view.option.getString(view, "Name")
        rows = dict(zip(map(int, tags), (float(v[0]) for v in values)))
        if kind == "NodeData":
            found["data"][title] = [rows.get(int(n)) for n in nodes[order]]
        else:
            found["cells"][title] = [rows.get(t) for t in found["tags"]]
    found["warnings"] = [line for line in gmsh.logger.get() if line.startswith(("Warning", "Error"))]
    gmsh.logger.stop()
    gmsh.finalize()
    return found


def by_vtk(name):
    makers = {"vtk": vtk.vtkUnstructuredGridReader, "vtu": vtk.vtkXMLUnstructuredGridReader}
    reader = makers[name[-3:]]()
    reader.SetFileName(name)
    if name.endswith(".vtk"):
        reader.ReadAllFieldsOn()
        reader.ReadAllScalarsOn()
    reader.Update()
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData())[:, :2].tolist()
    cells = [grid.GetCell(i) for i in range(grid.GetNumberOfCells())]
    corners = [[int(c) for c in map(grid.GetCell(i).GetPointId, range(grid.GetCell(i).GetNumberOfPoints()))] for i in range(len(cells))]
    found = {"points": points, "data": {}, "cells": {}}
    found["triangles"] = [row[:3] for row in corners if len(row) in (3, 6)]
    found["lines"] = [row for row in corners if len(row) == 2]
    for data, into, len_ in [
        (grid.GetPointData(), found["data"], len(points)),
        (grid.GetCellData(), found["cells"], len(found["triangles"])),
    ]:
        for i in range(data.GetNumberOfArrays()):
            array = data.GetArray(i)
            into[array.GetName()] = listed(vtk_to_numpy(array)[:len_])
    return found


READERS = {"msh": (by_meshio, by_gmsh), "msh2": (by_meshio, by_gmsh), "vtk": (by_meshio, by_vtk), "vtu": (by_meshio, by_vtk)}
answers = []
for name in sys.argv[1:]:
    for reader in READERS[name.rsplit(".", 1)[1]]:
        # Data of elements must be for all of them, says meshio.
        if reader is by_meshio and "msh" in name[-4:] and "plain" not in name:
            continue
        answers.append({"file": name, "reader": reader.__name__, **reader(name)})
print(json.dumps(answers))
