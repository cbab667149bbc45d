# flattening_unite(<target>): the sources of a folder are compiled as a few, which takes two thirds of the time: what
# each of them instantiates of Eigen is compiled once. Names of a source's own differ from those of its neighbours
# then, which Testing/Lint tests where sources are compiled one by one.
set(flattening_united 12) # sources of a folder, at most
# gcc looks for memory to give back from some 100 MB on, which takes an eighth of its time; of so few sources nearly
# nothing can be given back.
# A class of a test may have a base of an unnamed namespace, which is as good in a united source.
set(flattening_unite_flags --param=ggc-min-heapsize=524288 --param=ggc-min-expand=100 -Wno-subobject-linkage)

function (flattening_unite target)
  if (NOT SURFACEFLATTENING_UNITE_SOURCES)
    return()
  endif ()
  set_target_properties("${target}" PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  target_compile_options("${target}" PRIVATE "$<$<COMPILE_LANG_AND_ID:CXX,GNU>:${flattening_unite_flags}>")
  get_target_property(sources "${target}" SOURCES)
  foreach (source IN LISTS sources)
    get_filename_component(folder "${source}" DIRECTORY)
    get_filename_component(folder "${folder}" NAME)
    string(MAKE_C_IDENTIFIER "${target}/${folder}" group)
    get_source_file_property(alone "${source}" SKIP_UNITY_BUILD_INCLUSION)
    if (alone OR NOT source MATCHES "\\.cxx$")
      continue()
    endif ()
    math(EXPR "${group}" "0${${group}} + 1")
    math(EXPR part "(${${group}} - 1) / ${flattening_united}")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}_${part}")
  endforeach ()
endfunction ()
