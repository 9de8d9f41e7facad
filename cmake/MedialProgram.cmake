# medial_program(PROGRAM SUMMARY): adds what comes with a program: completion for bash, and the manual page
# PROGRAM.1 from the program's own --help and from PROGRAM.h2m in the current folder, by help2man where that
# is installed. Installs all three.
find_program(MEDIAL_HELP2MAN help2man DOC "Makes manual pages from --help")
find_program(MEDIAL_GZIP gzip DOC "Compresses manual pages")
mark_as_advanced(MEDIAL_HELP2MAN MEDIAL_GZIP)
if(NOT MEDIAL_HELP2MAN OR NOT MEDIAL_GZIP)
  message(STATUS "help2man or gzip is not installed: no manual pages")
endif()

# medial_manual(PROGRAM SUMMARY PAGE): makes the file PAGE, and PAGE.gz.
function(medial_manual program summary page)
  get_filename_component(folder "${page}" DIRECTORY)
  file(MAKE_DIRECTORY "${folder}")
  # Leaks in other libraries do not matter for --help. gzip -n makes the same bytes every time.
  add_custom_command(OUTPUT "${page}" "${page}.gz"
    COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0 LC_ALL=C
      "${MEDIAL_HELP2MAN}" --no-info --name "${summary}" --manual "Medial"
      --include "${CMAKE_CURRENT_SOURCE_DIR}/${program}.h2m" --output "${page}" $<TARGET_FILE:${program}>
    COMMAND "${MEDIAL_GZIP}" --keep --force --best --no-name "${page}"
    DEPENDS ${program} "${CMAKE_CURRENT_SOURCE_DIR}/${program}.h2m"
    VERBATIM)
  add_custom_target(${program}-manual ALL DEPENDS "${page}.gz")
endfunction()

function(medial_program program summary)
  set(page "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_MANDIR}/man1/${program}.1")
  if(MEDIAL_HELP2MAN AND MEDIAL_GZIP)
    medial_manual(${program} "${summary}" "${page}")
  endif()
  if(NOT MEDIAL_INSTALL)
    return()
  endif()
  install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
  install(FILES "${PROJECT_SOURCE_DIR}/apps/common/completion.bash" RENAME ${program}
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT tools)
  if(TARGET ${program}-manual)
    install(FILES "${page}.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT tools)
  endif()
endfunction()
