# The other role of the build, SURFACEFLATTENING_PARAVIEW: the module against the VTK inside ParaView,
# and the plugin that shows it there. ./test-paraview makes such a build tree on Debian.
set(SURFACEFLATTENING_BUILD_APPLICATIONS OFF)
set(SURFACEFLATTENING_BUILD_EXAMPLES OFF)
set(SURFACEFLATTENING_BUILD_INTERACTION OFF)
set(SURFACEFLATTENING_WRAP_PYTHON OFF)
set(flattening_plugin_testing "${BUILD_TESTING}")
set(BUILD_TESTING OFF) # the module's own tests are those of the first build tree

find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager RemotingViews)
if (EXISTS "${ParaView_DIR}/vtk")
  set(VTK_DIR "${ParaView_DIR}/vtk") # its own, and no other VTK will do; Debian's since 6.1 has that of the system
endif ()
include(FlatteningFindVTK)
include(FlatteningModule)

# Library and plugin are neighbours, where ParaView keeps its own plugins.
set(plugin_dir "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}")
set(CMAKE_INSTALL_RPATH "$ORIGIN")
set(flattening_library_dir "${plugin_dir}/SurfaceFlattening")
flattening_build_module()
add_subdirectory(Wrapping/Options)

paraview_plugin_scan(
  PLUGIN_FILES     "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS plugins
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME plugin) # of the list of plugins, which has no option for it
paraview_plugin_build(
  PLUGINS              ${plugins}
  AUTOLOAD             ${plugins} # where PV_PLUGIN_CONFIG_FILE names the list
  PLUGINS_FILE_NAME    SurfaceFlattening.xml
  RUNTIME_DESTINATION  "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION  "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_COMPONENT    plugin)

# ParaView's programs with the plugin.
foreach (program IN ITEMS paraview pvpython pvbatch pvserver)
  configure_file(Plugin/start.in "${CMAKE_BINARY_DIR}/bin/${program}" @ONLY
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endforeach ()

# Of an installed plugin: the same in one command, and scripts.
configure_file(Plugin/start-installed.in "${CMAKE_BINARY_DIR}/surfaceflattening-paraview" @ONLY)
install(
  PROGRAMS "${CMAKE_BINARY_DIR}/surfaceflattening-paraview"
  DESTINATION "${CMAKE_INSTALL_BINDIR}"
  COMPONENT plugin)
install(
  FILES
    Examples/ParaView/figure9.py
    Examples/ParaView/flat_beside.py
    Examples/ParaView/flatten_collection.py
  DESTINATION "${CMAKE_INSTALL_DATADIR}/surfaceflattening-paraview"
  COMPONENT plugin)

if (flattening_plugin_testing)
  enable_testing()
  add_subdirectory(Testing/ParaView)
endif ()

include(FlatteningDebian)
