# The example of soft bodies: they approach, sink into each other and part again, frame by frame.
include("${CMAKE_CURRENT_LIST_DIR}/consumer.cmake")
build_example("${SOURCE}" -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON)
run(output "${WORK}/soft_bodies" "${WORK}/balls")
if(NOT output MATCHES "^frame 0: separation ([0-9.]+)\n(.*)frame 59: separation ([0-9.]+)\n$")
  message(FATAL_ERROR "the bodies do not begin and end apart")
endif()
set(between "${CMAKE_MATCH_2}")
set(last "${CMAKE_MATCH_3}")
expect_near("the first separation" "${CMAKE_MATCH_1}" 0.21 0.01)
if(last STREQUAL "0.0000")
  message(FATAL_ERROR "the bodies did not part")
endif()
# They collide once, and not deeper than a ball's radius.
string(REGEX MATCHALL "depth [^\n]*\nframe [0-9]+: separation" partings "${between}depth")
list(LENGTH partings count)
if(NOT between MATCHES "depth 0\\.[0-4][0-9]+, [1-9][0-9]* points inside, [1-9][0-9]* contacts"
    OR NOT count EQUAL 1 OR between MATCHES "depth (0\\.[5-9]|[1-9n])")
  message(FATAL_ERROR "the bodies do not collide once")
endif()

# The frames are meshes that it reads itself; a turned copy of a mesh that it is given comes along.
file(GLOB frames "${WORK}/balls/a/*.obj" "${WORK}/balls/b/*.obj")
list(LENGTH frames count)
expect_near("the number of files" "${count}" 120 0)
run(output "${WORK}/soft_bodies" "${WORK}/again" 2 "${WORK}/balls/b/0059.obj")
if(NOT output MATCHES "^frame 0: separation [0-9.]+\nframe 1: ")
  message(FATAL_ERROR "unexpected output: ${output}")
endif()

# A mesh that is missing, and a folder that cannot be made, are named.
file(WRITE "${WORK}/file" "")
foreach(arguments IN ITEMS "absent.obj;${WORK}/again;2;absent.obj" "file;${WORK}/file;2")
  list(POP_FRONT arguments named)
  execute_process(COMMAND "${WORK}/soft_bodies" ${arguments}
    RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE errors)
  if(NOT code EQUAL 1 OR NOT errors MATCHES "^soft_bodies: [^\n]*${named}[^\n]*\n$")
    message(FATAL_ERROR "soft_bodies ended with ${code}:\n${errors}")
  endif()
endforeach()

run(path "${PYTHON}" "${SOURCE}/moving_copy.py" 3 1.2 0.3)
if(NOT path STREQUAL "1,0,0,0,0,1,0,0,0,0,1,1.2\n1,0,0,0,0,1,0,0,0,0,1,0.3\n1,0,0,0,0,1,0,0,0,0,1,1.2\n")
  message(FATAL_ERROR "unexpected path: ${path}")
endif()
