# medial_embed(TARGET SYMBOL FILE): adds the bytes of FILE to TARGET, between the C symbols SYMBOL and
# SYMBOLEnd. The assembler reads the file, so that megabytes cost the compiler nothing.
function(medial_embed target symbol file)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/embedded/${symbol}.cpp")
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
__asm__(
  ".section .rodata\n"
  ".global @symbol@\n"
  ".global @symbol@End\n"
  "@symbol@:\n"
  ".incbin \"@file@\"\n"
  "@symbol@End:\n"
  ".previous\n");
]])
  set_source_files_properties("${source}" PROPERTIES
    OBJECT_DEPENDS "${file}"
    COMPILE_OPTIONS -fno-lto) # which would not see the symbols
  target_sources(${target} PRIVATE "${source}")
endfunction()
