# medial_warnings(TARGET): the warnings that every target of the project is built with.
function(medial_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
    -Wcast-align -Woverloaded-virtual -Wnull-dereference)
  # Clang's warning is also of doubles that are set to a float.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion>)
  if(MEDIAL_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
