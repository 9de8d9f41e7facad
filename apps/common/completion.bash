# Bash completion for medial-axis, medial-distance, medial-measure, medial-proximity and medial-viewer. It
# offers the options of --help, and files with the extensions that an option accepts.

# _medial_files WORD EXTENSION...: prints the files that begin with WORD and have one of the extensions, and
# folders.
_medial_files()
{
  local word=$1 extension
  shift
  for extension in "$@"; do
    compgen -f -X "!*.$extension" -- "$word"
    compgen -f -X "!*.${extension^^}" -- "$word"
  done
  compgen -d -- "$word"
}

# _medial_values OPTION WORD: prints the values that the option accepts.
_medial_values()
{
  case $1 in
    --side) compgen -W "interior exterior both" -- "$2" ;;
    --representation) compgen -W "surface faces points" -- "$2" ;;
    --topology) compgen -W "selected preserve" -- "$2" ;;
    --sign) compgen -W "auto none pseudonormal winding" -- "$2" ;;
    --engine) compgen -W "auto device rasteriser processor" -- "$2" ;;
    -o | --output)
      if [[ ${COMP_WORDS[0]} == *medial-distance ]]; then
        _medial_files "$2" vtp csv
      else
        _medial_files "$2" vtp pvtp ply obj ma
      fi
      ;;
    --field-arrays) compgen -W "distance closest_point closest_cell closest_feature closest_site" -- "$2" ;;
    --curves | --skeleton | --thickness | --thin-regions) _medial_files "$2" vtp ;;
    --skeleton-table) _medial_files "$2" csv ;;
    --contacts) _medial_files "$2" vtp pvd ;;
    --animation) compgen -d -- "$2" ;;
    --field) _medial_files "$2" vti pvti nrrd mha nii.gz vdb ;;
    --local-thickness) _medial_files "$2" vti pvti nrrd mha nii.gz ;;
    --histogram | --image | --thickness-image | --screenshot) _medial_files "$2" png ;;
    --html) _medial_files "$2" html ;;
    --thickness-method) compgen -W "ball ray wall" -- "$2" ;;
    --colour) compgen -W "radius angle thickness" -- "$2" ;;
    --report | --json) _medial_files "$2" json ;;
  esac
}

# _medial_option_takes_value OPTION HELP: whether a value follows the option.
_medial_option_takes_value()
{
  [[ $1 == -?* && $2 =~ (^|[[:space:],])"$1"(,--[a-z-]+)?" "[A-Z] ]]
}

_medial()
{
  local program=$1 word=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]} help
  local -a meshes=(stl obj ply off vtp vtk) scans=(nrrd mha mhd nii nii.gz vti)
  # "--side=x" comes as three words.
  if [[ $word == = ]]; then
    word=
  elif [[ $option == = ]]; then
    option=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  help=$("$program" --help 2>/dev/null)
  if _medial_option_takes_value "$option" "$help"; then
    mapfile -t COMPREPLY < <(_medial_values "$option" "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(grep -oE -- '(^  |,)--?[a-z-]+' <<<"$help" | tr -d ' ,')" -- "$word")
  elif [[ $program == *medial-measure ]]; then
    mapfile -t COMPREPLY < <(_medial_files "$word" vtp ply obj ma stl off vtk)
  elif [[ $program == *medial-distance ]]; then
    mapfile -t COMPREPLY < <(_medial_files "$word" "${meshes[@]}" "${scans[@]}" xyz txt csv)
  elif [[ $program == *medial-axis ]]; then
    mapfile -t COMPREPLY < <(_medial_files "$word" "${meshes[@]}" pvtp "${scans[@]}")
  elif [[ $program == *medial-proximity ]]; then
    mapfile -t COMPREPLY < <(_medial_files "$word" "${meshes[@]}")
  else
    mapfile -t COMPREPLY < <(_medial_files "$word" "${meshes[@]}" "${scans[@]}")
  fi
}

complete -o filenames -F _medial medial-axis medial-distance medial-measure medial-proximity medial-viewer
