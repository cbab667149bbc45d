"""Write meshes and their curves as VTK XML polydata with double precision points."""
import os

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray


def toPoints(x):
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(x, dtype=np.float64), deep=True))
    return points


def toCells(cells):
    offsets = np.concatenate([[0], np.cumsum([len(c) for c in cells])]).astype(np.int64)
    connectivity = np.concatenate([np.asarray(c, np.int64) for c in cells])
    array = vtk.vtkCellArray()
    array.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(connectivity, deep=True)
    )
    return array


def write(data, path):
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    writer.SetFileName(path)
    # Within the elements: Debian's ParaView 5.11 cannot read appended data with the Expat of today.
    writer.SetDataModeToBinary()
    writer.SetCompressorTypeToZLib()
    if not writer.Write():
        raise OSError(f"cannot write {path}")


def writeSurface(mesh, path):
    data = vtk.vtkPolyData()
    data.SetPoints(toPoints(mesh.points))
    data.SetPolys(toCells(mesh.triangles))
    for name, values in mesh.arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values, dtype=np.float64), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    write(data, path)


def writeCurves(mesh, curves, path):
    """Polylines over just the points they use, with CurveType and CurveName."""
    used = sorted({int(v) for c in curves for v in c.vertices})
    index = {v: k for k, v in enumerate(used)}
    data = vtk.vtkPolyData()
    data.SetPoints(toPoints(mesh.points[used]))
    data.SetLines(toCells([[index[int(v)] for v in c.vertices] for c in curves]))
    kind = numpy_to_vtk(np.array([c.kind for c in curves], np.int32), deep=True)
    kind.SetName("CurveType")
    data.GetCellData().AddArray(kind)
    names = vtk.vtkStringArray()
    names.SetName("CurveName")
    for c in curves:
        names.InsertNextValue(c.name)
    data.GetCellData().AddArray(names)
    write(data, path)


def writePiece(mesh, name, folder, sets=None):
    """Surface and curve files; `sets` maps a suffix to the curves of an alternative set."""
    writeSurface(mesh, os.path.join(folder, f"{name}.vtp"))
    writeCurves(mesh, mesh.curves, os.path.join(folder, f"{name}_curves.vtp"))
    for suffix, curves in (sets or {}).items():
        writeCurves(mesh, curves, os.path.join(folder, f"{name}_curves_{suffix}.vtp"))
