# Put this file into the folder Remote of VTK's sources, configure VTK with
# -DVTK_ENABLE_REMOTE_MODULES=ON -DVTK_MODULE_ENABLE_VTK_FiltersFlattening=YES.
#
# Set SURFACEFLATTENING_REPOSITORY and SURFACEFLATTENING_TAG to what is to be built.
vtk_fetch_module(SurfaceFlattening
  "Flattens triangulated surfaces with wires of exact length"
  GIT_REPOSITORY "${SURFACEFLATTENING_REPOSITORY}"
  GIT_TAG "${SURFACEFLATTENING_TAG}")

# VTK exports all its modules under one namespace, so inside VTK the module's is VTK's.
set(module_file "${CMAKE_CURRENT_LIST_DIR}/SurfaceFlattening/vtk.module")
if (EXISTS "${module_file}")
  file(READ "${module_file}" text)
  string(REPLACE "SurfaceFlattening::FiltersFlattening" "VTK::FiltersFlattening" text "${text}")
  file(WRITE "${module_file}" "${text}")
endif ()
