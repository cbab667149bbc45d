# Debian packages, made by `cpack` in the build tree: surfaceflattening has the library, the command and
# the Python package, surfaceflattening-dev what a C++ project needs. The tree of the ParaView plugin
# makes surfaceflattening-paraview.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME surfaceflattening)
set(CPACK_PACKAGE_VENDOR "The SurfaceFlattening authors")
set(CPACK_PACKAGE_CONTACT "The SurfaceFlattening authors <surfaceflattening@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)

if (SURFACEFLATTENING_PARAVIEW)
  set(CPACK_COMPONENTS_ALL plugin)
  set(CPACK_DEBIAN_PLUGIN_PACKAGE_NAME surfaceflattening-paraview)
  # ParaView's libraries have no versions of their own in the names of packages.
  math(EXPR next_minor "${ParaView_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PLUGIN_PACKAGE_DEPENDS
    "paraview (>= ${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}), paraview (<< ${ParaView_VERSION_MAJOR}.${next_minor})")
else ()
  set(CPACK_COMPONENTS_ALL runtime python development documentation)
  foreach (component IN ITEMS runtime python documentation)
    string(TOUPPER "${component}" upper)
    set("CPACK_COMPONENT_${upper}_GROUP" main)
  endforeach ()
  set(CPACK_COMPONENT_DEVELOPMENT_GROUP development)
  set(CPACK_DEBIAN_MAIN_PACKAGE_NAME surfaceflattening)
  set(CPACK_DEBIAN_MAIN_PACKAGE_DEPENDS "python3-vtk9, python3-numpy")
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME surfaceflattening-dev)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "surfaceflattening (= ${PROJECT_VERSION}), libvtk9-dev")
endif ()
include(CPack)
