# Installs BUILD and moves the result to PREFIX, as an installation must not depend on its place.
file(REMOVE_RECURSE "${PREFIX}" "${PREFIX}.new")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}.new" --config "${CONFIG}"
  COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
file(RENAME "${PREFIX}.new" "${PREFIX}")

# No file of the package may know the trees that it was built from, nor the targets that make the library.
file(GLOB_RECURSE package "${PREFIX}/*.cmake")
if(NOT package)
  message(FATAL_ERROR "no CMake package was installed")
endif()
foreach(file IN LISTS package)
  file(READ "${file}" text)
  foreach(name IN ITEMS "${BUILD}" "medial_objects" "medial_internals")
    string(FIND "${text}" "${name}" position)
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${file} names ${name}")
    endif()
  endforeach()
endforeach()

# Programs come with manual pages and with completion, which bash looks for by their names.
foreach(program IN LISTS PROGRAMS)
  foreach(file IN ITEMS "bin/${program}" "${MAN_FOLDER}/man1/${program}.1.gz"
      "${DATA_FOLDER}/bash-completion/completions/${program}")
    if(NOT EXISTS "${PREFIX}/${file}")
      message(FATAL_ERROR "${file} was not installed")
    endif()
  endforeach()
endforeach()
