# Run as a script: writes OUTPUT, the linker's list of what libmedial exports: the classes that HEADERS mark
# with MEDIAL_EXPORT, and functions. Visibility alone does not hide private functions that GCC compiles for
# several processors, nor instances of the standard library's templates.
set(classes "")
foreach(header IN LISTS HEADERS)
  file(STRINGS "${header}" lines REGEX "^(class|struct) MEDIAL_EXPORT ")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^[a-z]+ MEDIAL_EXPORT ([A-Za-z0-9]+).*" "\\1" class "${line}")
    list(APPEND classes "${class}")
  endforeach()
endforeach()
list(SORT classes)
set(text "")
foreach(class IN LISTS classes)
  # Members; typeinfo, its name and the vtable.
  string(APPEND text "      medial::${class}::*;\n      *?for?medial::${class};\n")
endforeach()
# Classes begin with capitals, functions do not.
file(WRITE "${OUTPUT}" "{
  global:
    extern \"C++\" {
      medial::[a-z]*;
${text}    };
  local: *;
};
")
