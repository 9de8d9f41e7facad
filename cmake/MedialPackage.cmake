# Installs what find_package(Medial CONFIG COMPONENTS Core Filters) reads, and leaves the same in the
# build tree.
include(CMakePackageConfigHelpers)

set(MEDIAL_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/Medial")
set(MEDIAL_BUILD_CMAKE_DIR "${PROJECT_BINARY_DIR}/${MEDIAL_CMAKE_DIR}")

configure_package_config_file(cmake/MedialConfig.cmake.in
  "${MEDIAL_BUILD_CMAKE_DIR}/MedialConfig.cmake"
  INSTALL_DESTINATION "${MEDIAL_CMAKE_DIR}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${MEDIAL_BUILD_CMAKE_DIR}/MedialConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${MEDIAL_BUILD_CMAKE_DIR}/MedialConfig.cmake"
    "${MEDIAL_BUILD_CMAKE_DIR}/MedialConfigVersion.cmake"
  DESTINATION "${MEDIAL_CMAKE_DIR}" COMPONENT development)

# The targets of the VTK module are exported by vtk_module_build(), in Medial-targets.cmake.
export(EXPORT MedialCoreTargets NAMESPACE Medial::
  FILE "${MEDIAL_BUILD_CMAKE_DIR}/MedialCoreTargets.cmake")
install(EXPORT MedialCoreTargets NAMESPACE Medial:: DESTINATION "${MEDIAL_CMAKE_DIR}"
  COMPONENT development)
