# Builds the VTK module in this folder as Medial::Filters and, if wanted, wraps it for Python. Included,
# not added: VTK adds this folder itself. Without COMPONENTS, find_package(VTK) looks for everything that
# VTK was ever built with.
set(MEDIAL_VTK_COMPONENTS CommonCore CommonDataModel CommonExecutionModel CommonMath CommonMisc
  CommonTransforms FiltersCore FiltersGeneral ParallelCore)
set(wrapping)
if(MEDIAL_BUILD_PYTHON)
  set(wrapping Python WrappingPythonCore)
endif()
find_package(VTK 9.1 REQUIRED COMPONENTS ${MEDIAL_VTK_COMPONENTS} ImagingCore IOCore ${wrapping})

set(export)
if(MEDIAL_INSTALL)
  set(export INSTALL_EXPORT MedialFiltersTargets)
endif()
set(BUILD_SHARED_LIBS ON)
vtk_module_find_modules(module_files "${CMAKE_CURRENT_LIST_DIR}")
vtk_module_scan(
  MODULE_FILES ${module_files}
  PROVIDES_MODULES modules
  WANT_BY_DEFAULT ON
  HIDE_MODULES_FROM_CACHE ON)
vtk_module_build(
  MODULES ${modules}
  PACKAGE Medial
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  INSTALL_HEADERS ${MEDIAL_INSTALL}
  ${export}
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Medial"
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/medial/filters"
  ENABLE_WRAPPING ${MEDIAL_BUILD_PYTHON}
  TEST_DIRECTORY_NAME NONE)
medial_warnings(Filters)
target_precompile_headers(Filters PRIVATE
  <algorithm> <array> <cmath> <functional> <memory> <string> <vector>
  <vtkCellArray.h> <vtkImageData.h> <vtkInformation.h> <vtkNew.h> <vtkPointData.h> <vtkPolyData.h>)
# All of VTK puts a semicolon after vtkTypeMacro(), which -Wpedantic calls one too many.
target_compile_options(Filters PUBLIC $<BUILD_INTERFACE:-Wno-pedantic>)

add_subdirectory(filters/files)
if(MEDIAL_BUILD_PYTHON)
  add_subdirectory(filters/python)
endif()
