# Installs the build, moves the prefix, and uses library, Python package and command from there.
function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if (result)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "Failed (${result}): ${command}")
  endif ()
endfunction ()

file(REMOVE_RECURSE "${folder}")
file(MAKE_DIRECTORY "${folder}")
run("${CMAKE_COMMAND}" --install "${build}" --prefix "${folder}/first")
file(RENAME "${folder}/first" "${folder}/prefix")
set(prefix "${folder}/prefix")

set(share "${prefix}/share/surfaceflattening")
function (build source)
  run("${CMAKE_COMMAND}" -S "${source}" -B "${folder}/build" -G "${generator}"
    "-DCMAKE_BUILD_TYPE=${build_type}"
    "-DCMAKE_CXX_COMPILER=${compiler}"
    "-DCMAKE_CXX_COMPILER_LAUNCHER=${launcher}"
    "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DVTK_DIR=${vtk_dir}")
  run("${CMAKE_COMMAND}" --build "${folder}/build")
endfunction ()

# The project that is installed, on pieces that are.
build("${share}/Examples/Project")
set(picture "${folder}/shirt.png")
execute_process(
  COMMAND "${folder}/build/FlattenAndDraw" "${share}/Data/shirt_front.vtp"
    "${share}/Data/shirt_front_curves.vtp" "${picture}"
  RESULT_VARIABLE result OUTPUT_VARIABLE output)
message("${output}")
if (result OR NOT output MATCHES "piece 1: Ok, largest length error of an edge [0-9.]+e-1[0-9]")
  message(FATAL_ERROR "The project does not flatten (${result})")
endif ()
file(SIZE "${picture}" size)
if (size LESS 10000)
  message(FATAL_ERROR "The picture has ${size} bytes")
endif ()
if (UNIX AND NOT APPLE)
  # Without an X server it says so, or draws where VTK needs none; it is never ended by VTK.
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -E env --unset=DISPLAY "${folder}/build/FlattenAndDraw"
      "${share}/Data/shirt_front.vtp"
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE error)
  if (NOT result STREQUAL 1 OR NOT output MATCHES "piece 1: Ok" OR NOT error MATCHES "DISPLAY")
    message(FATAL_ERROR "Without a display: ${result} ${output} ${error}")
  endif ()
endif ()

# The snippets of the classes' pages compile with what is installed.
file(REMOVE_RECURSE "${folder}/build")
build("${snippets}")

# The libraries without VTK, which a program finds where there is no VTK.
if (EXISTS "${prefix}/include/SurfaceFlattening/Pattern")
  file(REMOVE_RECURSE "${folder}/build")
  set(vtk_dir "${folder}/none")
  build("${snippets}/../libraries")
  run("${folder}/build/Cone")
endif ()

# Nothing that was installed knows where it was built.
file(GLOB_RECURSE installed "${prefix}/*.cmake")
foreach (file IN LISTS installed)
  file(STRINGS "${file}" places REGEX "${build}|${folder}/first")
  if (places)
    message(FATAL_ERROR "${file} names a build directory: ${places}")
  endif ()
endforeach ()

if (python)
  run("${python}" "${links}" "${share}")
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${prefix}/${python_destination}"
    "${python}" -c "import surfaceflattening; surfaceflattening.vtkSurfaceDevelopability()")
  # Below /usr/local Python starts from the folder of its version.
  file(GLOB version_dir "${prefix}/lib/python3.*/dist-packages")
  run("${python}" -c "import site; site.addsitedir('${version_dir}'); import surfaceflattening")
endif ()
if (wirewarp)
  run("${prefix}/${bindir}/wirewarp" "${data}/shirt_front.vtp" --output "${folder}/flat" --quiet)
endif ()
