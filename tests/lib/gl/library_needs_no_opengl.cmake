# The library loads no OpenGL when a program starts: libepoxy opens it when it is first called.
execute_process(COMMAND "${READELF}" -d "${LIBRARY}" OUTPUT_VARIABLE entries RESULT_VARIABLE code)
if(NOT code EQUAL 0 OR NOT entries MATCHES "NEEDED")
  message(FATAL_ERROR "${READELF} -d ${LIBRARY} ended with ${code}:\n${entries}")
endif()
if(entries MATCHES "NEEDED[^\n]*lib(EGL|GL|GLX|OpenGL|GLESv2|GLEW)\\.so[^\n]*")
  message(FATAL_ERROR "${LIBRARY}: ${CMAKE_MATCH_0}")
endif()
