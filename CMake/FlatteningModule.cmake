# Builds the modules of the project: the filters', whose vtk.module stands at the root, the readers', and the optional ones.
#
# vtk_module_build adds the folder of a module as a subdirectory of CMAKE_SOURCE_DIR. The filters' folder
# IS the source directory, and CMake refuses to enter a directory twice with the same binary directory.
# Seen from the parent folder it is a subdirectory like any other, so the parent is what the function
# is told. This leans on VTK's internals, and so does the test of _vtk_build_module in CMakeLists.txt:
# nothing else in the project does.
function (flattening_build_module)
  set(with_tests OFF)
  if (BUILD_TESTING)
    set(with_tests ON)
  endif ()
  set(files "${CMAKE_CURRENT_SOURCE_DIR}/vtk.module" "${CMAKE_CURRENT_SOURCE_DIR}/IO/Flattening/vtk.module")
  set(names SurfaceFlattening::FiltersFlattening SurfaceFlattening::IOFlattening)
  if (SURFACEFLATTENING_BUILD_PATTERN)
    list(APPEND files "${CMAKE_CURRENT_SOURCE_DIR}/IO/vtk.module")
    list(APPEND names SurfaceFlattening::IOPattern)
  endif ()
  if (SURFACEFLATTENING_BUILD_INTERACTION)
    list(APPEND files "${CMAKE_CURRENT_SOURCE_DIR}/Interaction/vtk.module")
    list(APPEND names SurfaceFlattening::InteractionFlattening)
  endif ()
  vtk_module_scan(
    MODULE_FILES      ${files}
    PROVIDES_MODULES  modules
    REQUEST_MODULES   ${names}
    ENABLE_TESTS      "${with_tests}"
    HIDE_MODULES_FROM_CACHE ON)

  # A user's project builds against the library, but nobody builds against a plugin.
  set(destination INSTALL_EXPORT SurfaceFlattening)
  if (SURFACEFLATTENING_PARAVIEW)
    set(destination
      INSTALL_HEADERS OFF
      LIBRARY_NAME_SUFFIX "pv${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}"
      LIBRARY_DESTINATION "${flattening_library_dir}"
      TARGETS_COMPONENT plugin)
  endif ()

  set(source_dir "${CMAKE_CURRENT_SOURCE_DIR}")
  get_filename_component(CMAKE_SOURCE_DIR "${source_dir}" DIRECTORY)
  vtk_module_build(
    MODULES                     ${modules}
    PACKAGE                     SurfaceFlattening
    VERSION                     "${SurfaceFlattening_VERSION}"
    SOVERSION                   "${SurfaceFlattening_VERSION_MAJOR}"
    ${destination}
    HEADERS_DESTINATION         "${CMAKE_INSTALL_INCLUDEDIR}/SurfaceFlattening"
    CMAKE_DESTINATION           "${CMAKE_INSTALL_LIBDIR}/cmake/SurfaceFlattening"
    TEST_DIRECTORY_NAME         "Testing"
    TEST_DATA_TARGET            SurfaceFlatteningData
    TEST_INPUT_DATA_DIRECTORY   "${source_dir}/Data"
    TEST_OUTPUT_DATA_DIRECTORY  "${source_dir}/Data")
  set(flattening_modules ${modules} PARENT_SCOPE)
endfunction ()
