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

# Pages, pieces and examples in the folders that they have in the project, so that links hold and the
# commands of the pages work from there.
set(share_dir "${CMAKE_INSTALL_DATADIR}/surfaceflattening")
install(
  FILES CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE README.md packages.txt packages-test.txt
  DESTINATION "${share_dir}"
  COMPONENT documentation)
install(
  FILES CMake/SurfaceFlattening.remote.cmake
  DESTINATION "${share_dir}/CMake"
  COMPONENT documentation)
install(
  DIRECTORY Data Documentation Examples
  DESTINATION "${share_dir}"
  COMPONENT documentation
  FILES_MATCHING
    REGEX "\\.(md|txt|png|svg|vtp|cxx|h|py)$"
    REGEX "Examples/(CMakeLists.txt|Cxx/CMakeLists.txt)$" EXCLUDE # parts of the project's build
    REGEX "Documentation/(CMakeLists.txt|[^/]*\\.py)$" EXCLUDE
    REGEX "Data/Generate" EXCLUDE
    REGEX "__pycache__" EXCLUDE)
install(
  FILES
    "${CMAKE_CURRENT_SOURCE_DIR}/CITATION.cff"
    "${CMAKE_CURRENT_SOURCE_DIR}/README.md"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}"
  COMPONENT documentation)
