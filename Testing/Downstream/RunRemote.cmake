# Lays the sources out as they lie in VTK's folder Remote and builds them together with a module of VTK's.
function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if (result)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "Failed (${result}): ${command}")
  endif ()
endfunction ()

file(REMOVE_RECURSE "${folder}/source")
file(COPY "${project}/" DESTINATION "${folder}/source")
file(COPY "${source}/CMake/SurfaceFlattening.remote.cmake" DESTINATION "${folder}/source/Remote")
foreach (part IN ITEMS CMakeLists.txt vtk.module Data Examples Figures Filters Testing)
  file(COPY "${source}/${part}" DESTINATION "${folder}/source/Remote/SurfaceFlattening")
endforeach ()
# A module of VTK's beside it. Written here, because the project may hold one vtk.module only.
set(neighbour "${folder}/source/Neighbour")
file(WRITE "${neighbour}/vtk.module" "NAME\n  VTK::Neighbour\nLIBRARY_NAME\n  vtkNeighbour\n")
file(WRITE "${neighbour}/CMakeLists.txt"
  "vtk_module_add_module(VTK::Neighbour SOURCES Neighbour.cxx HEADERS Neighbour.h)\n")
file(WRITE "${neighbour}/Neighbour.h" "int neighbour();\n")
file(WRITE "${neighbour}/Neighbour.cxx" "#include \"Neighbour.h\"\nint neighbour() { return 1; }\n")

run("${CMAKE_COMMAND}" -S "${folder}/source" -B "${folder}/build" -G "${generator}"
  -DCMAKE_BUILD_TYPE=None # no optimization, and assertions stay on
  "-DCMAKE_CXX_COMPILER=${compiler}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${launcher}"
  "-DVTK_DIR=${vtk_dir}")
if (complete)
  run("${CMAKE_COMMAND}" --build "${folder}/build" --target vtkFiltersFlatteningCxxTests)
  run("${CMAKE_CTEST_COMMAND}" --test-dir "${folder}/build" --output-on-failure --no-tests=error
    -R TestSurfaceDevelopability)
else ()
  run("${CMAKE_COMMAND}" --build "${folder}/build" --target vtkFiltersFlattening-hierarchy)
endif ()
