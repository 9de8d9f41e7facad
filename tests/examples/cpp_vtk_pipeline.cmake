# The example of a VTK pipeline: the axis that it writes must be that of the box that it reads.
include("${CMAKE_CURRENT_LIST_DIR}/consumer.cmake")
build_example("${SOURCE}")
run(output "${WORK}/medial_pipeline" "${BOX}" "${WORK}/axis.vtp")
if(NOT output MATCHES "^[0-9]+ cells, computed by the engine [^\n]+")
  message(FATAL_ERROR "unexpected output: ${output}")
endif()
run(figures "${CHECK}" "${WORK}/axis.vtp")

# Without a file to read there is no axis, and no file that looks like one.
execute_process(
  COMMAND "${WORK}/medial_pipeline" "${WORK}/absent.stl" "${WORK}/absent.vtp"
  RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE errors)
if(NOT code EQUAL 1 OR NOT errors MATCHES "absent.stl" OR EXISTS "${WORK}/absent.vtp")
  message(FATAL_ERROR "a missing input file ended with ${code}:\n${errors}")
endif()

# The program does not report an axis that it could not write.
execute_process(
  COMMAND "${WORK}/medial_pipeline" "${BOX}" "${WORK}/absent/axis.vtp"
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE errors)
if(NOT code EQUAL 1 OR NOT errors MATCHES "absent/axis.vtp" OR output MATCHES "cells")
  message(FATAL_ERROR "a missing output folder ended with ${code}:\n${output}${errors}")
endif()
