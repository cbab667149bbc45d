# Put this file into the folder Remote of VTK's sources, configure VTK with
# -DVTK_ENABLE_REMOTE_MODULES=ON -DVTK_MODULE_ENABLE_VTK_FiltersFlattening=YES.
#
# Set SURFACEFLATTENING_REPOSITORY and SURFACEFLATTENING_TAG to what is to be built.
vtk_fetch_module(SurfaceFlattening
  "Flattens triangulated surfaces with wires of exact length"
  GIT_REPOSITORY "${SURFACEFLATTENING_REPOSITORY}"
  GIT_TAG "${SURFACEFLATTENING_TAG}")

# VTK exports all its modules under one namespace, so inside VTK it is that of these modules.
file(GLOB_RECURSE module_files "${CMAKE_CURRENT_LIST_DIR}/SurfaceFlattening/vtk.module")
foreach (module_file IN LISTS module_files)
  file(READ "${module_file}" text)
  string(REPLACE "SurfaceFlattening::" "VTK::" text "${text}")
  file(WRITE "${module_file}" "${text}")
endforeach ()
