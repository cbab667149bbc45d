# The CMake package SurfaceFlattening, for the build tree and for the installed prefix.
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/SurfaceFlattening")
configure_package_config_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/SurfaceFlatteningConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${package_dir}/SurfaceFlatteningConfig.cmake"
  INSTALL_DESTINATION "${package_dir}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${package_dir}/SurfaceFlatteningConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${package_dir}/SurfaceFlatteningConfig.cmake"
    "${CMAKE_BINARY_DIR}/${package_dir}/SurfaceFlatteningConfigVersion.cmake"
  DESTINATION "${package_dir}"
  COMPONENT development)

foreach (place IN ITEMS "${CMAKE_INSTALL_DOCDIR}:documentation" "${CMAKE_INSTALL_DOCDIR}-dev:development")
  string(REPLACE ":" ";" place "${place}")
  list(GET place 0 folder)
  list(GET place 1 component)
  install(
    FILES "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE"
    DESTINATION "${folder}"
    RENAME copyright
    COMPONENT "${component}")
endforeach ()
install(
  FILES
    "${CMAKE_CURRENT_SOURCE_DIR}/CITATION.cff"
    "${CMAKE_CURRENT_SOURCE_DIR}/README.md"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}"
  COMPONENT documentation)
