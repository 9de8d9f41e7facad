# medial_shader_text(FILE VARIABLE): reads a shader, with other files in place of its lines
# `#include "PATH.glsl"`, relative to its folder, which OpenGL does not know.
function(medial_shader_text file variable)
  get_filename_component(folder "${file}" DIRECTORY)
  file(READ "${file}" text)
  while(text MATCHES "#include \"([a-z_./]+\\.glsl)\"\n")
    set(name "${CMAKE_MATCH_1}")
    file(READ "${folder}/${name}" included)
    string(REPLACE "#include \"${name}\"\n" "${included}" text "${text}")
  endwhile()
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()
