# Sourced by the project's scripts, which run in the project's root under "set -euo pipefail".

# say TEXT: a line on the terminal.
say() { printf '%s\n' "$*"; }

# For AddressSanitizer. Debian 12's takes thread-local memory at some addresses for that of an old glibc, and
# its search for leaks then reads where nothing is (google/sanitizers issue 1322).
sanitizer_options=intercept_tls_get_addr=0

# quietly LOG COMMAND...: the command's output goes to the file LOG; when it fails, so does this
# function, after showing the end of LOG.
quietly()
{
  local log=$1
  shift
  mkdir -p "$(dirname "$log")"
  if ! "$@" >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    say "failed: $*" >&2
    say "the whole output is in $log" >&2
    return 1
  fi
}

# configure PRESET FOLDER [OPTION...]: configures the preset; ccache is called for the compiler if it is there.
configure()
{
  local preset=$1 folder=$2
  shift 2
  if command -v ccache >/dev/null; then
    set -- "$@" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  say "Configuring $folder (preset $preset)"
  quietly "$folder/configure.log" cmake --preset "$preset" "$@"
}

# build PRESET FOLDER [TARGET...]: configures the preset if that was not done yet, and builds. ccache shares
# what one folder has compiled with other folders that have the same flags.
build()
{
  local preset=$1 folder=$2
  shift 2
  export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$PWD}
  export CCACHE_NOHASHDIR=true # debug information names another folder then
  export CCACHE_INODECACHE=true # so that it does not read all precompiled headers for each file
  export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros} # for precompiled headers
  if [[ ! -e $folder/build.ninja ]]; then
    configure "$preset" "$folder"
  fi
  say "Building ${*:-everything} in $folder"
  quietly "$folder/build.log" cmake --build "$folder" --parallel "$(nproc)" ${1:+--target "$@"}
}
