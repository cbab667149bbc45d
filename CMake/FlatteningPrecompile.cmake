# flattening_precompile(<target> <part>...): the target reads headers of others, which most of a source's compile
# time goes into, once for all its sources. Sources include what they use all the same, which is a test of
# Testing/Lint. flattening_precompile_as(<target> <other>): the same headers as another target's, which is compiled with
# the same flags and defines no macro that this one does not, read once for both.
set(flattening_precompiled_std
  <algorithm> <array> <cmath> <complex> <cstddef> <cstdint> <functional> <limits> <map> <memory> <numeric>
  <optional> <queue> <set> <string> <string_view> <tuple> <unordered_map> <utility> <vector>)
set(flattening_precompiled_eigen <Eigen/Core> <Eigen/Geometry> <Eigen/SparseCore>)
set(flattening_precompiled_gtest <gtest/gtest.h>)
set(flattening_precompiled_vtk
  <vtkCellArray.h> <vtkCellData.h> <vtkDataArray.h> <vtkDoubleArray.h> <vtkFieldData.h> <vtkIdTypeArray.h>
  <vtkInformation.h> <vtkInformationVector.h> <vtkNew.h> <vtkObjectFactory.h> <vtkPointData.h> <vtkPoints.h>
  <vtkPolyData.h> <vtkPolyDataAlgorithm.h> <vtkSmartPointer.h> <vtkStringArray.h>)

function (flattening_precompile target)
  if (NOT SURFACEFLATTENING_PRECOMPILE_HEADERS)
    return()
  endif ()
  foreach (part IN LISTS ARGN)
    target_precompile_headers("${target}" PRIVATE ${flattening_precompiled_${part}})
  endforeach ()
endfunction ()

function (flattening_precompile_as target other)
  if (SURFACEFLATTENING_PRECOMPILE_HEADERS)
    target_precompile_headers("${target}" REUSE_FROM "${other}")
  endif ()
endfunction ()
