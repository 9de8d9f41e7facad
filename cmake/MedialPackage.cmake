# Installs what find_package(Medial CONFIG COMPONENTS Core Filters) reads.
include(CMakePackageConfigHelpers)

set(MEDIAL_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/Medial")
configure_package_config_file(cmake/MedialConfig.cmake.in
  "${CMAKE_BINARY_DIR}/MedialConfig.cmake" INSTALL_DESTINATION "${MEDIAL_CMAKE_DIR}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/MedialConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/MedialConfig.cmake" "${CMAKE_BINARY_DIR}/MedialConfigVersion.cmake"
  DESTINATION "${MEDIAL_CMAKE_DIR}")
install(EXPORT MedialCoreTargets NAMESPACE Medial:: DESTINATION "${MEDIAL_CMAKE_DIR}")
