# The Python package medial: the wrapped filters, an extension module that executes them, and
# functions over numpy arrays, all in MEDIAL_PYTHON_PACKAGES/medial.

find_package(Python3 REQUIRED COMPONENTS Interpreter)

# Debian's Python looks in this folder below /usr and below /usr/local.
set(MEDIAL_PYTHON_PACKAGES
  "lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/dist-packages"
  CACHE STRING "Folder of the Python package, relative to the prefix")
set(python_package "${MEDIAL_PYTHON_PACKAGES}/medial")
set(python_sources "${PROJECT_SOURCE_DIR}/filters/python")

vtk_module_wrap_python(
  MODULES ${modules}
  PYTHON_PACKAGE medial
  MODULE_DESTINATION "${MEDIAL_PYTHON_PACKAGES}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Medial"
  TARGET Medial::Python)

add_library(medial_execution MODULE "${python_sources}/execution.cxx")
target_link_libraries(medial_execution
  PRIVATE VTK::WrappingPythonCore VTK::CommonCore VTK::CommonExecutionModel)
set_target_properties(medial_execution PROPERTIES
  PREFIX "" OUTPUT_NAME "_execution"
  LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${python_package}")
medial_warnings(medial_execution)
install(TARGETS medial_execution LIBRARY DESTINATION "${python_package}" COMPONENT python)

set(python_files
  __init__.py
  _arrays.py
  _axis.py
  _errors.py
  _execution.pyi
  _field.py
  _mesh.py
  _options.py
  _shape.py
  _update.py
  py.typed)
foreach(file IN LISTS python_files)
  configure_file("${python_sources}/medial/${file}" "${CMAKE_BINARY_DIR}/${python_package}/${file}" COPYONLY)
  install(FILES "${python_sources}/medial/${file}" DESTINATION "${python_package}" COMPONENT python)
endforeach()
