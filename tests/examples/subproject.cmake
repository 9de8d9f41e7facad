# A project that adds Medial as a folder gets its library, and keeps its own settings.
include("${CMAKE_CURRENT_LIST_DIR}/consumer.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/box_axis.cmake")
set(source "${CMAKE_CURRENT_LIST_DIR}/subproject")
set(options "-DMEDIAL=${MEDIAL}" "-DCMAKE_CXX_FLAGS_RELEASE=${CXX_FLAGS_RELEASE}")

# What was built before is kept.
set(ENV{CMAKE_CXX_COMPILER_LAUNCHER}
  "${PYTHON};-I;-S;${CMAKE_CURRENT_LIST_DIR}/compile_once.py;${BUILD};${WORK}/medial;${LAUNCHER}")
build_again("${source}" ${options} -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON)
expect_box_axis("${WORK}/box_axis")
run(ignored "${CMAKE_COMMAND}" --install "${WORK}" --prefix "${WORK}/prefix" --config "${CONFIG}")
file(GLOB_RECURSE installed RELATIVE "${WORK}/prefix" "${WORK}/prefix/*")
if(NOT installed STREQUAL "bin/box_axis")
  message(FATAL_ERROR "the project installs ${installed}")
endif()

# With filters it is configured only.
if(FILTERS)
  configure("${source}" "${WORK}/filters" ${options} -DMEDIAL_BUILD_FILTERS=ON)
  if(NOT configure_code EQUAL 0)
    message(FATAL_ERROR "configuring with filters failed:\n${configure_errors}")
  endif()
endif()
