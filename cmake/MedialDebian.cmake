# Four Debian packages, one for each component of the installation, by cpack. Meant for the preset
# "packages", which installs to /usr; scripts/check-packages builds and checks them.
set(MEDIAL_PACKAGE_RELEASE 1 CACHE STRING "Debian revision of the packages")
set(MEDIAL_PACKAGE_CONTACT "Medial developers <medial@users.invalid>"
  CACHE STRING "Maintainer of the packages: name and address")

if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  message(FATAL_ERROR
    "MEDIAL_DEBIAN_PACKAGES needs the CMAKE_INSTALL_PREFIX /usr, not ${CMAKE_INSTALL_PREFIX}")
endif()
foreach(part IN ITEMS FILTERS PYTHON APPS)
  if(NOT MEDIAL_BUILD_${part})
    message(FATAL_ERROR "MEDIAL_DEBIAN_PACKAGES needs MEDIAL_BUILD_${part}=ON")
  endif()
endforeach()

if(NOT MEDIAL_HELP2MAN OR NOT MEDIAL_GZIP)
  message(FATAL_ERROR "MEDIAL_DEBIAN_PACKAGES needs help2man and gzip, for manual pages")
endif()
set(debian_sources "${PROJECT_SOURCE_DIR}/cmake/debian")
set(debian_files "${PROJECT_BINARY_DIR}/debian")
set(library_package "libmedial${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")

# medial_compress(SOURCE TARGET): as Debian wants it, and reproducibly. Runs while CMake configures.
function(medial_compress source target)
  execute_process(COMMAND "${MEDIAL_GZIP}" -9nc "${source}"
    OUTPUT_FILE "${target}" COMMAND_ERROR_IS_FATAL ANY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
endfunction()

# medial_paragraph(TEXT VARIABLE): as a field of Debian's files has it, indented and without empty lines.
function(medial_paragraph text variable)
  string(STRIP "${text}" text)
  string(REPLACE "\n\n" "\n.\n" text "${text}")
  string(REPLACE "\n" "\n " text " ${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

# Files that every package has in its documentation folder.
file(READ "${PROJECT_SOURCE_DIR}/LICENSE" licence)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/LICENSE")
string(REGEX MATCH "Copyright \\(c\\) ([^\n]+)" ignored "${licence}")
set(MEDIAL_COPYRIGHT "${CMAKE_MATCH_1}")
string(REGEX REPLACE "^.*All rights reserved\\.\n+" "" licence "${licence}")
medial_paragraph("${licence}" MEDIAL_LICENCE)
set(MEDIAL_VTKJS_PARAGRAPHS "")
if(MEDIAL_VTKJS)
  # The file begins with a comment that has the licences.
  file(READ "${MEDIAL_VTKJS}" licence LIMIT 16384)
  string(FIND "${licence}" "\n*/" end)
  string(SUBSTRING "${licence}" 0 ${end} licence)
  string(REPLACE "/*! " "" licence "${licence}")
  medial_paragraph("${licence}" licence)
  set(MEDIAL_VTKJS_PARAGRAPHS "
Files: usr/bin/medial-axis
Copyright: ${MEDIAL_COPYRIGHT}
 2016, Kitware Inc.
 2016, Ken Martin, Will Schroeder, Bill Lorensen
License: BSD-3-Clause and vtk.js
Comment: The program contains vtk.js, for the pages that it writes.

License: vtk.js
${licence}
")
endif()
string(TIMESTAMP MEDIAL_PACKAGE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file("${debian_sources}/copyright.in" "${debian_files}/copyright" @ONLY)
configure_file("${debian_sources}/changelog.in" "${debian_files}/changelog" @ONLY)
medial_compress("${debian_files}/changelog" "${debian_files}/changelog.Debian.gz")
medial_compress("${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${debian_files}/changelog.gz")

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL runtime development tools python)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # every package has its own
set(CPACK_PACKAGE_CONTACT "${MEDIAL_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE "${MEDIAL_PACKAGE_RELEASE}")
set(CPACK_DEBIAN_PACKAGE_SOURCE medial)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# Versions of what the libraries need are read from the programs and libraries themselves.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
# The same for packages of others that use the libraries: the file shlibs.
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")

# medial_package(COMPONENT NAME SECTION SUMMARY DESCRIPTION): the other packages need the library's of
# the same version.
macro(medial_package component name section summary description)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${description}")
  if(NOT ${component} STREQUAL runtime)
    set(CPACK_COMPONENT_${upper}_DEPENDS runtime)
  endif()
  install(
    FILES
      "${debian_files}/copyright"
      "${debian_files}/changelog.gz"
      "${debian_files}/changelog.Debian.gz"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${name}" COMPONENT ${component})
endmacro()

set(about "Medial computes medial axes of triangle meshes, simplified by separation angle,
exact distance fields on regular grids, and wall thickness. It computes on the
GPU by OpenGL where there is one, and otherwise on the processor.\n")
medial_package(runtime ${library_package} libs "medial axes and distance fields of meshes - libraries"
  "${about}\nThis package holds the library, and the VTK filters as one of their own.")
# OpenGL, loaded when it is first used: the dispatch libraries, and Mesa's drivers for those who have no other.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "libegl1, libopengl0 | libgl1")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "libegl-mesa0, libgl1-mesa-dri")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${debian_sources}/triggers")

medial_package(development libmedial-dev libdevel "medial axes and distance fields of meshes - development"
  "${about}\nThis package holds the headers and the configuration for CMake. The component
Filters needs libvtk9-dev; Core, the library over plain arrays, does not.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS libvtk9-dev)

medial_package(tools medial-tools graphics "medial axes and distance fields of meshes - programs"
  "${about}\nThis package holds the commands medial-axis, which computes them from files
of meshes, medial-viewer, which shows them in a window, medial-measure, which
measures how well an axis describes a mesh, medial-proximity, which
computes the proximity of meshes that move or deform, and
medial-distance, which computes how far points are from a mesh.")

# The extension modules are those of one version of Python.
math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
medial_package(python python3-medial python "medial axes and distance fields of meshes - Python 3"
  "${about}\nThis package holds the Python package medial: functions over arrays of numpy,
and filters for VTK's pipelines.")
string(CONCAT CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), "
  "python3 (<< ${Python3_VERSION_MAJOR}.${next_python}), python3-numpy, python3-vtk9")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${debian_sources}/postinst" "${debian_sources}/prerm")

include(CPack)
