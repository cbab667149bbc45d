# Builds the command as where none of cairo, FriBidi, qpdf and Clipper is installed: it flattens, draws what
# needs none of them, and refuses the rest by name.
function (run expected_result expected_words)
  execute_process(COMMAND ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  list(JOIN ARGN " " command)
  if (NOT result EQUAL expected_result)
    message(FATAL_ERROR "Ended with ${result}, not ${expected_result}: ${command}\n${output}")
  endif ()
  foreach (word IN LISTS expected_words)
    if (NOT output MATCHES "${word}")
      message(FATAL_ERROR "Does not say \"${word}\": ${command}\n${output}")
    endif ()
  endforeach ()
endfunction ()

file(REMOVE_RECURSE "${folder}")
run(0 "without CAIRO and FRIBIDI and QPDF: PDF is refused;without CLIPPER: seam allowances are refused"
  "${CMAKE_COMMAND}" -S "${source}" -B "${folder}" -G "${generator}"
  -DCMAKE_BUILD_TYPE=None
  "-DCMAKE_CXX_COMPILER=${compiler}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${launcher}"
  "-DVTK_DIR=${vtk_dir}"
  -DBUILD_TESTING=OFF
  -DSURFACEFLATTENING_BUILD_EXAMPLES=OFF
  -DSURFACEFLATTENING_WRAP_PYTHON=OFF
  -DSURFACEFLATTENING_PATTERN_LIBRARIES=OFF)
run(0 "" "${CMAKE_COMMAND}" --build "${folder}" --target wirewarp)

set(draw "${folder}/bin/wirewarp" pattern "${source}/Data/shirt_front.vtp"
  "${source}/Data/shirt_front_curves.vtp" --unit cm --output "${folder}/result")
run(0 "" ${draw} -o "${folder}/result/pattern.svg" -o "${folder}/result/pattern.dxf" --allowance 0)
foreach (file IN ITEMS flat.vtp pattern.svg pattern.dxf)
  if (NOT EXISTS "${folder}/result/${file}")
    message(FATAL_ERROR "There is no ${file}")
  endif ()
endforeach ()
run(3 "made without Clipper" ${draw} -o "${folder}/result/pattern.svg")
run(3 "made without cairo, FriBidi or qpdf" ${draw} -o "${folder}/result/pattern.pdf" --allowance 0)
