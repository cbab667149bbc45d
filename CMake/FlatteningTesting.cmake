# What every folder of tests uses. Include after CTest.
include(GoogleTest)
find_package(GTest REQUIRED)

# Where memory ends, OpenBLAS waits for ever for some to be given back; so what tests that end runs with
# Debian's reference BLAS, also where OpenBLAS is installed beside it.
find_path(FLATTENING_REFERENCE_BLAS_DIR libblas.so.3
  PATHS "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/blas" NO_DEFAULT_PATH
  DOC "Folder of the reference BLAS")
mark_as_advanced(FLATTENING_REFERENCE_BLAS_DIR)
set(flattening_memory_environment)
if (FLATTENING_REFERENCE_BLAS_DIR)
  set(flattening_memory_environment "LD_LIBRARY_PATH=${FLATTENING_REFERENCE_BLAS_DIR}")
endif ()

# Baselines are committed as they are; ExternalData only hands them to VTK's test functions.
set(ExternalData_SOURCE_ROOT "${CMAKE_SOURCE_DIR}")
set(ExternalData_BINARY_ROOT "${CMAKE_BINARY_DIR}/ExternalData")
set(ExternalData_OBJECT_STORES "${CMAKE_BINARY_DIR}/ExternalData/Objects")
include("${VTK_DIR}/vtkModuleTesting.cmake")
