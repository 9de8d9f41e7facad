# Target docs: the comments of the public headers as HTML, by Doxygen where it is installed. Fails if
# something public has no comment, or if a comment names something that does not exist.
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
  return()
endif()

set(MEDIAL_DOCS_DIR "${PROJECT_BINARY_DIR}/docs")
get_property(headers GLOBAL PROPERTY MEDIAL_PUBLIC_HEADERS)
get_property(filters GLOBAL PROPERTY MEDIAL_FILTER_CLASSES)
list(TRANSFORM filters REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/filters/\\1.h")
set(documented ${headers} ${filters} "${PROJECT_SOURCE_DIR}/docs/CPP.md")
list(TRANSFORM documented REPLACE "(.+)" "\"\\1\"" OUTPUT_VARIABLE MEDIAL_DOCS_INPUT)
list(JOIN MEDIAL_DOCS_INPUT " " MEDIAL_DOCS_INPUT)
configure_file(docs/Doxyfile.in "${PROJECT_BINARY_DIR}/Doxyfile" @ONLY)
add_custom_target(docs
  COMMAND ${CMAKE_COMMAND} -E rm -rf "${MEDIAL_DOCS_DIR}"
  COMMAND ${CMAKE_COMMAND} -E make_directory "${MEDIAL_DOCS_DIR}"
  COMMAND Doxygen::doxygen "${PROJECT_BINARY_DIR}/Doxyfile"
  DEPENDS ${documented} "${PROJECT_BINARY_DIR}/Doxyfile"
  COMMENT "Making ${MEDIAL_DOCS_DIR}/html"
  VERBATIM)
