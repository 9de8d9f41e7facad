# medial_manual(PROGRAM SUMMARY): the manual page PROGRAM.1 from the program's own --help and from
# PROGRAM.h2m in the current folder, by help2man where that is installed; and completion for bash.
find_program(MEDIAL_HELP2MAN help2man DOC "Makes manual pages from --help")
find_program(MEDIAL_GZIP gzip DOC "Compresses manual pages")
mark_as_advanced(MEDIAL_HELP2MAN MEDIAL_GZIP)
if(NOT MEDIAL_HELP2MAN OR NOT MEDIAL_GZIP)
  message(STATUS "help2man or gzip is not installed: no manual pages")
endif()

function(medial_manual program summary)
  install(FILES "${PROJECT_SOURCE_DIR}/apps/common/completion.bash" RENAME ${program}
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT tools)
  if(NOT MEDIAL_HELP2MAN OR NOT MEDIAL_GZIP)
    return()
  endif()
  set(page "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_MANDIR}/man1/${program}.1")
  get_filename_component(folder "${page}" DIRECTORY)
  file(MAKE_DIRECTORY "${folder}")
  # Leaks of the libraries are no matter of --help. Compressed so, the bytes are the same at any time.
  add_custom_command(OUTPUT "${page}" "${page}.gz"
    COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0 LC_ALL=C
      "${MEDIAL_HELP2MAN}" --no-info --name "${summary}" --manual "Medial"
      --include "${CMAKE_CURRENT_SOURCE_DIR}/${program}.h2m" --output "${page}" $<TARGET_FILE:${program}>
    COMMAND "${MEDIAL_GZIP}" --keep --force --best --no-name "${page}"
    DEPENDS ${program} "${CMAKE_CURRENT_SOURCE_DIR}/${program}.h2m"
    VERBATIM)
  add_custom_target(${program}-manual ALL DEPENDS "${page}.gz")
  install(FILES "${page}.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT tools)
endfunction()
