# Functions for projects that use the installation at PREFIX.

# run(OUTPUT COMMAND...): runs the command and returns its standard output; if it fails, so does the test.
function(run output)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE errors)
  message(STATUS "${text}")
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "'${ARGN}' ended with ${code}:\n${errors}")
  endif()
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

# configure(SOURCE BINARY OPTION...): sets configure_code and configure_errors.
function(configure source binary)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -S "${source}" -B "${binary}" -G "${GENERATOR}"
      "-DCMAKE_PREFIX_PATH=${PREFIX}" "-DCMAKE_BUILD_TYPE=${CONFIG}"
      "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
      "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" ${ARGN}
    RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE errors)
  set(configure_code "${code}" PARENT_SCOPE)
  set(configure_errors "${errors}" PARENT_SCOPE)
endfunction()

# build_again(SOURCE OPTION...): configures and builds into WORK.
function(build_again source)
  configure("${source}" "${WORK}" ${ARGN})
  if(NOT configure_code EQUAL 0)
    message(FATAL_ERROR "configuring ${source} failed:\n${configure_errors}")
  endif()
  run(ignored "${CMAKE_COMMAND}" --build "${WORK}" --config "${CONFIG}")
endfunction()

# build_example(SOURCE OPTION...): the same, anew.
function(build_example source)
  file(REMOVE_RECURSE "${WORK}")
  build_again("${source}" ${ARGN})
endfunction()

# expect_near(WHAT VALUE EXPECTED TOLERANCE), in integers of VALUE's millionths.
function(expect_near what value expected tolerance)
  foreach(name value expected tolerance)
    if(NOT ${name} MATCHES "^(-?)([0-9]+)(\\.([0-9]*))?$")
      message(FATAL_ERROR "${what}: '${${name}}' is not a decimal number")
    endif()
    string(SUBSTRING "${CMAKE_MATCH_4}000000" 0 6 fraction)
    math(EXPR scaled "${CMAKE_MATCH_1}(${CMAKE_MATCH_2} * 1000000 + 1${fraction} - 1000000)")
    set(${name}_scaled "${scaled}")
  endforeach()
  math(EXPR difference "${value_scaled} - ${expected_scaled}")
  if(difference GREATER tolerance_scaled OR difference LESS "-${tolerance_scaled}")
    message(FATAL_ERROR "${what} is ${value}, not ${expected} within ${tolerance}")
  endif()
endfunction()
