# The examples in Python, with the package from the installation.
include("${CMAKE_CURRENT_LIST_DIR}/consumer.cmake")
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
set(ENV{PYTHONPATH} "${PACKAGES}")
run(output "${PYTHON}" "${SOURCE}/medial_axis.py" "${BOX}" "${WORK}/axis.vtp" "${WORK}/field.vti")
if(NOT output MATCHES "^[0-9]+ cells, computed by the engine [^\n]+")
  message(FATAL_ERROR "unexpected output: ${output}")
endif()
run(figures "${CHECK}" "${WORK}/axis.vtp" "${WORK}/field.vti")
run(where "${PYTHON}" -c "print(__import__('medial').__file__)")
string(STRIP "${where}" where)
if(NOT where STREQUAL "${PACKAGES}/medial/__init__.py")
  message(FATAL_ERROR "the package came from ${where}")
endif()

# The box is 2 x 1.5 x 1. From each corner a seam leads to the middle sheet of 1 x 0.5, and four more
# are around it: 8 * sqrt(3) / 2 + 3.
run(output "${PYTHON}" "${SOURCE}/measure_part.py" "${BOX}" "${WORK}/axis.npz")
if(NOT output MATCHES "volume ([0-9.]+)\nlargest ball inside: radius ([0-9.]+) at .* (-?[0-9.]+)\n([0-9]+) seams, ([0-9.]+) long")
  message(FATAL_ERROR "unexpected output: ${output}")
endif()
set(z "${CMAKE_MATCH_3}")
set(seams "${CMAKE_MATCH_4}")
set(length "${CMAKE_MATCH_5}")
set(radius "${CMAKE_MATCH_2}")
expect_near("the volume" "${CMAKE_MATCH_1}" 3 0.15)
expect_near("the largest radius" "${radius}" 0.5 0.001)
expect_near("the height of its centre" "${z}" 0 0.001)
expect_near("the number of seams" "${seams}" 12 0)
expect_near("the length of the seams" "${length}" 9.93 1)
if(NOT EXISTS "${WORK}/axis.npz")
  message(FATAL_ERROR "there is no axis.npz")
endif()

# Without a file to read, or a folder to write to, they say so in one line.
foreach(arguments IN ITEMS
    "absent.stl;measure_part.py;absent.stl;absent.npz"
    "absent.stl;medial_axis.py;absent.stl;absent.vtp;absent.vti"
    "absent/axis.npz;measure_part.py;${BOX};absent/axis.npz"
    "absent/axis.vtp;medial_axis.py;${BOX};absent/axis.vtp;field.vti"
    "absent/field.vti;medial_axis.py;${BOX};axis.vtp;absent/field.vti")
  list(POP_FRONT arguments file script)
  execute_process(COMMAND "${PYTHON}" "${SOURCE}/${script}" ${arguments}
    WORKING_DIRECTORY "${WORK}" RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE errors)
  if(NOT code EQUAL 1 OR NOT errors MATCHES "(^|\n)${script}: [^\n]*${file}[^\n]*\n$"
      OR EXISTS "${WORK}/absent.vtp")
    message(FATAL_ERROR "${script} ended with ${code}:\n${errors}")
  endif()
endforeach()

# Below the prefixes that Debian's Python knows the folder of the package is one where it looks. It
# leaves out those that do not exist.
run(folders "${PYTHON}" -c "print('', *__import__('site').getsitepackages(), '')")
file(RELATIVE_PATH relative "${PREFIX}" "${PACKAGES}")
foreach(prefix IN ITEMS "/usr" "/usr/local")
  if(NOT folders MATCHES " ${prefix}/${relative} ")
    message(FATAL_ERROR "Python does not look in ${prefix}/${relative}, but in${folders}")
  endif()
endforeach()
