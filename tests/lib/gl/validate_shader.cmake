# Run as a script: compiles SHADER of STAGE by VALIDATOR; TEMPORARY is a file for its whole text.
include("${CMAKE_CURRENT_LIST_DIR}/../../../cmake/ShaderText.cmake")
medial_shader_text("${SHADER}" text)
file(WRITE "${TEMPORARY}" "${text}")
execute_process(COMMAND "${VALIDATOR}" -S ${STAGE} "${TEMPORARY}" RESULT_VARIABLE result OUTPUT_VARIABLE output)
file(REMOVE "${TEMPORARY}")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${output}")
endif()
