# Finds the VTK to build against. COMPONENTS are always named: without them VTK asks for Qt.
set(flattening_vtk_components # what a user of the library needs as well
  CommonCore
  CommonDataModel
  CommonExecutionModel
  FiltersCore
  IOCore
  ParallelCore
  vtksys)
set(flattening_vtk_build_components ${flattening_vtk_components})
if (SURFACEFLATTENING_BUILD_APPLICATIONS OR SURFACEFLATTENING_BUILD_EXAMPLES OR BUILD_TESTING)
  list(APPEND flattening_vtk_build_components
    CommonSystem
    FiltersGeneral
    FiltersSources
    IOGeometry
    IOImage
    IOLegacy
    IOXML
    InteractionStyle
    RenderingAnnotation
    RenderingCore
    RenderingFreeType
    RenderingOpenGL2
    TestingCore
    TestingRendering)
endif ()
if (SURFACEFLATTENING_BUILD_INTERACTION)
  set(flattening_vtk_optional InteractionWidgets RenderingOpenGL2)
  list(APPEND flattening_vtk_build_components ${flattening_vtk_optional} RenderingCore)
endif ()
if (SURFACEFLATTENING_WRAP_PYTHON)
  list(APPEND flattening_vtk_build_components
    Python
    WrappingPythonCore)
endif ()

# Qt is for PatternEditor alone.
set(flattening_vtk_optional_components)
if (SURFACEFLATTENING_BUILD_APPLICATIONS)
  list(APPEND flattening_vtk_optional_components OPTIONAL_COMPONENTS GUISupportQt)
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${flattening_vtk_build_components}
  ${flattening_vtk_optional_components})
message(STATUS "VTK ${VTK_VERSION} in ${VTK_DIR}")

if (SURFACEFLATTENING_WRAP_PYTHON)
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
  set(VTK_PYTHON_VERSION 3)
  vtk_module_python_default_destination(python_destination)
endif ()
