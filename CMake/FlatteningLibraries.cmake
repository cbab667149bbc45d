# Core and Pattern as static libraries without VTK, for whoever needs no VTK: the components Core and Pattern of
# the package SurfaceFlattening, with their headers in folders of their own.
find_package(Eigen3 REQUIRED CONFIG) # of any version: Filters/Core has looked at it
find_package(superlu CONFIG)
set(flattening_libraries Core)
if (TARGET FlatteningPattern)
  add_library(FlatteningPatternArchive STATIC $<TARGET_OBJECTS:FlatteningPattern>)
  set_target_properties(FlatteningPatternArchive PROPERTIES LINKER_LANGUAGE CXX)
  get_target_property(pattern_libraries FlatteningPattern INTERFACE_LINK_LIBRARIES)
  target_link_libraries(FlatteningPatternArchive INTERFACE FlatteningCoreArchive ${pattern_libraries})
  target_include_directories(FlatteningPatternArchive INTERFACE "$<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/IO/Pattern>")
  list(APPEND flattening_libraries Pattern)
endif ()
set(source_of_Core Filters/Core)
set(source_of_Pattern IO/Pattern)
foreach (library IN LISTS flattening_libraries)
  set_target_properties(Flattening${library}Archive PROPERTIES
    EXPORT_NAME ${library}
    OUTPUT_NAME Flattening${library})
  target_include_directories(Flattening${library}Archive
    INTERFACE "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/SurfaceFlattening/${library}>")
  install(TARGETS Flattening${library}Archive
    EXPORT SurfaceFlatteningLibraries
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
  install(DIRECTORY "${source_of_${library}}/"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/SurfaceFlattening/${library}"
    COMPONENT development
    FILES_MATCHING PATTERN "*.h")
endforeach ()
install(EXPORT SurfaceFlatteningLibraries
  NAMESPACE SurfaceFlattening::
  FILE SurfaceFlattening-libraries.cmake
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/SurfaceFlattening"
  COMPONENT development)
# The objects of this tree, for SURFACEFLATTENING_OBJECTS_OF of another one.
if (TARGET FlatteningPattern AND NOT SURFACEFLATTENING_OBJECTS_OF)
  export(TARGETS FlatteningCore FlatteningPattern FILE "${CMAKE_BINARY_DIR}/SurfaceFlattening-objects.cmake")
endif ()
