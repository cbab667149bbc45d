# What every folder of tests uses. Include after CTest.
include(GoogleTest)
find_package(GTest REQUIRED)

# Baselines are committed as they are; ExternalData only hands them to VTK's test functions.
set(ExternalData_SOURCE_ROOT "${CMAKE_SOURCE_DIR}")
set(ExternalData_BINARY_ROOT "${CMAKE_BINARY_DIR}/ExternalData")
set(ExternalData_OBJECT_STORES "${CMAKE_BINARY_DIR}/ExternalData/Objects")
include("${VTK_DIR}/vtkModuleTesting.cmake")
