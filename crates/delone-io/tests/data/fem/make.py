"""Makes the files of this folder, and more of their kind, in the folder that is named: python make.py FOLDER

All hold the same mesh, a plate of two parts, as gmsh, meshio and VTK write it. Needs gmsh, meshio, vtk and NumPy.
"""

import os
import sys

import gmsh
import meshio
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

FOLDER = sys.argv[1]


def place(name):
    return os.path.join(FOLDER, name)


def plate(order=1):
    """Two squares side by side, with groups of curves and surfaces."""
    gmsh.clear()
    gmsh.model.add("plate")
    geo = gmsh.model.geo
    corners = [(0, 0), (2, 0), (2, 1), (0, 1), (1, 0), (1, 1)]
    p = [geo.addPoint(x, y, 0, 0.7) for x, y in corners]
    ends = [(0, 4), (4, 1), (1, 2), (2, 5), (5, 3), (3, 0), (4, 5)]
    c = [geo.addLine(p[a], p[b]) for a, b in ends]
    left = geo.addPlaneSurface([geo.addCurveLoop([c[0], c[6], c[4], c[5]])])
    right = geo.addPlaneSurface([geo.addCurveLoop([c[1], c[2], c[3], -c[6]])])
    geo.synchronize()
    gmsh.model.addPhysicalGroup(1, [c[5]], 7, "inlet")
    gmsh.model.addPhysicalGroup(1, [c[2]], 9)
    gmsh.model.addPhysicalGroup(1, [c[0], c[1], c[3], c[4], c[6]], 1, "wall")
    gmsh.model.addPhysicalGroup(2, [left], 2, "steel")
    gmsh.model.addPhysicalGroup(2, [right], 5)
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(order)


def save(name, version=4.1, binary=False, parametric=False):
    gmsh.option.setNumber("Mesh.MshFileVersion", version)
    gmsh.option.setNumber("Mesh.Binary", binary)
    gmsh.option.setNumber("Mesh.SaveParametric", parametric)
    gmsh.write(place(name))


def by_gmsh():
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    for order in (1, 2):
        plate(order)
        for parametric in (False, True):
            kind = f"{order}{'p' if parametric else ''}"
            save(f"gmsh-22-{kind}.msh", 2.2, False, parametric)
            save(f"gmsh-22b-{kind}.msh", 2.2, True, parametric)
            save(f"gmsh-40-{kind}.msh", 4.0, False, parametric)
            save(f"gmsh-41-{kind}.msh", 4.1, False, parametric)
            save(f"gmsh-41b-{kind}.msh", 4.1, True, parametric)
    plate()
    save("gmsh.vtk")
    for binary in (False, True):
        gmsh.option.setNumber("PostProcessing.Binary", binary)
        name = f"gmsh-data{'b' if binary else ''}.msh"
        save(name, 4.1, binary)
        nodes, places, _ = gmsh.model.mesh.getNodes()
        values = places.reshape(-1, 3)[:, 0] * 3 + 0.1
        pressure = gmsh.view.add("pressure")
        gmsh.view.addHomogeneousModelData(pressure, 0, "plate", "NodeData", nodes, values)
        triangles = np.concatenate(gmsh.model.mesh.getElements(2)[1])
        rows = [[float(t), 1.0, 2.0] for t in triangles]
        flux = gmsh.view.add("flux")
        gmsh.view.addModelData(flux, 0, "plate", "ElementData", triangles, rows)
        gmsh.view.write(pressure, place(name), True)
        gmsh.view.write(flux, place(name), True)
        gmsh.view.remove(pressure)
        gmsh.view.remove(flux)
    gmsh.model.mesh.partition(2)
    save("gmsh-parts.msh")
    save("gmsh-partsb.msh", binary=True)
    plate()
    gmsh.model.mesh.recombine()
    save("gmsh-quads.msh")
    gmsh.finalize()


def by_meshio(mesh):
    for name, kind, binary in [
        ("meshio-22.msh", "gmsh22", False),
        ("meshio-22b.msh", "gmsh22", True),
        ("meshio-41.msh", "gmsh", False),
        ("meshio-41b.msh", "gmsh", True),
    ]:
        mesh.write(place(name), file_format=kind, binary=binary)
    cells = [(kind, [mesh.get_cells_type(kind)]) for kind in ("line", "triangle")]
    cells = [(kind, rows[0]) for kind, rows in cells]
    k, m = (len(rows) for _, rows in cells)
    data = {"id": [np.zeros(k, np.int64), np.arange(m, dtype=np.int64)]}
    x = mesh.points[:, 0]
    plain = meshio.Mesh(
        mesh.points, cells, point_data={"t": x.astype(np.float32), "v": mesh.points * 2}, cell_data=data
    )
    for name, kind, binary in [
        ("meshio-42.vtk", "vtk42", False),
        ("meshio-42b.vtk", "vtk42", True),
        ("meshio-51.vtk", "vtk51", False),
        ("meshio-51b.vtk", "vtk51", True),
    ]:
        plain.write(place(name), file_format=kind, binary=binary)
    plain.write(place("meshio-text.vtu"), binary=False)
    for compression in (None, "zlib", "lzma"):
        plain.write(place(f"meshio-{compression}.vtu"), binary=True, compression=compression)
    return plain


def add_data(dataset, mesh):
    x = mesh.points[:, 0]
    for name, values in [("t", x.astype(np.float32)), ("v", mesh.points * 2), ("with blank", x + 1)]:
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        dataset.GetPointData().AddArray(array)
    ids = numpy_to_vtk(np.concatenate([np.ravel(d) for d in mesh.cell_data["id"]]), deep=True)
    ids.SetName("id")
    dataset.GetCellData().SetScalars(ids)
    return dataset


def as_rows(cells):
    rows = np.hstack([np.full((len(cells), 1), cells.shape[1]), cells]).ravel()
    array = vtk.vtkCellArray()
    array.ImportLegacyFormat(numpy_to_vtkIdTypeArray(rows.astype(np.int64), deep=True))
    return array


def by_vtk(mesh):
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(mesh.points, deep=True))
    lines, triangles = (cells.data for cells in mesh.cells)
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points)
    for kind, cells in [(vtk.VTK_LINE, lines), (vtk.VTK_TRIANGLE, triangles)]:
        for row in cells:
            grid.InsertNextCell(kind, len(row), [int(v) for v in row])
    add_data(grid, mesh)
    surface = vtk.vtkPolyData()
    surface.SetPoints(points)
    surface.SetLines(as_rows(lines))
    surface.SetPolys(as_rows(triangles))
    add_data(surface, mesh)
    stripper = vtk.vtkStripper()
    stripper.SetInputData(surface)
    stripper.Update()
    legacy = [
        (f"vtk-{kind}-{version}{'b' if binary else ''}.vtk", dataset, writer, version, binary)
        for kind, dataset, writer in [
            ("grid", grid, vtk.vtkUnstructuredGridWriter),
            ("poly", surface, vtk.vtkPolyDataWriter),
        ]
        for version in (42, 51)
        for binary in (False, True)
    ]
    legacy.append(("vtk-strips.vtk", stripper.GetOutput(), vtk.vtkPolyDataWriter, 51, True))
    for name, dataset, maker, version, binary in legacy:
        writer = maker()
        writer.SetInputData(dataset)
        writer.SetFileName(place(name))
        writer.SetFileVersion(version)
        (writer.SetFileTypeToBinary if binary else writer.SetFileTypeToASCII)()
        writer.Write()
    for mode in ("text", "inline", "raw", "base64"):
        for compressor in ("none", "zlib", "lz4", "lzma"):
            for header in (32, 64):
                for big in (False, True):
                    writer = vtk.vtkXMLUnstructuredGridWriter()
                    writer.SetInputData(grid)
                    order = "be" if big else "le"
                    writer.SetFileName(place(f"vtk-{mode}-{compressor}-{header}{order}.vtu"))
                    if mode == "text":
                        writer.SetDataModeToAscii()
                    elif mode == "inline":
                        writer.SetDataModeToBinary()
                    else:
                        writer.SetDataModeToAppended()
                        writer.SetEncodeAppendedData(mode == "base64")
                    kinds = {"none": "None", "zlib": "ZLib", "lz4": "LZ4", "lzma": "LZMA"}
                    getattr(writer, f"SetCompressorTypeTo{kinds[compressor]}")()
                    getattr(writer, f"SetHeaderTypeToUInt{header}")()
                    (writer.SetByteOrderToBigEndian if big else writer.SetByteOrderToLittleEndian)()
                    writer.SetBlockSize(256)
                    writer.Write()


by_gmsh()
by_vtk(by_meshio(meshio.read(place("gmsh-41-1.msh"))))
