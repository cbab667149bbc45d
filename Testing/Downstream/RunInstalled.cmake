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

run("${CMAKE_COMMAND}" -S "${project}" -B "${folder}/build" -G "${generator}"
  "-DCMAKE_BUILD_TYPE=${build_type}"
  "-DCMAKE_CXX_COMPILER=${compiler}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${launcher}"
  "-DCMAKE_PREFIX_PATH=${prefix}"
  "-DVTK_DIR=${vtk_dir}")
run("${CMAKE_COMMAND}" --build "${folder}/build")
run("${folder}/build/Downstream")

# Nothing that was installed knows where it was built.
file(GLOB_RECURSE installed "${prefix}/*.cmake")
foreach (file IN LISTS installed)
  file(STRINGS "${file}" places REGEX "${build}|${folder}/first")
  if (places)
    message(FATAL_ERROR "${file} names a build directory: ${places}")
  endif ()
endforeach ()

if (python)
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${prefix}/${python_destination}"
    "${python}" -c "import surfaceflattening; surfaceflattening.vtkSurfaceDevelopability()")
  # Below /usr/local Python starts from the folder of its version.
  file(GLOB version_dir "${prefix}/lib/python3.*/dist-packages")
  run("${python}" -c "import site; site.addsitedir('${version_dir}'); import surfaceflattening")
endif ()
if (wirewarp)
  run("${prefix}/${bindir}/wirewarp" --help)
endif ()
