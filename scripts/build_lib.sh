# Sourced by the other scripts: where the project is, and one function that builds a preset without doing work twice.

root=$(unset CDPATH && cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

# Two checkouts of the project share what the compiler cache holds, units with precompiled headers included: the headers'
# contents count, not when they were written.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime

# build_preset PRESET [TARGET...]: configures once, then builds; says nothing when all is up to date.
# Everything it prints goes to stderr, so that a command's own output stays clean.
build_preset() {
  local preset=$1 folder=$root/build/$1 log target
  local targets=()
  shift
  for target in "$@"; do targets+=(--target "$target"); done
  if [[ ! -f $folder/build.ninja || $root/CMakePresets.json -nt $folder/configured ]]; then
    echo "configuring build/$preset" >&2
    log=$(mktemp)
    if ! (cd "$root" && cmake --preset "$preset") >"$log" 2>&1; then
      cat "$log" >&2
      rm -f "$log"
      echo "the configuration of build/$preset failed; are all packages there (scripts/install_packages)?" >&2
      return 1
    fi
    rm -f "$log"
    touch "$folder/configured"
  fi
  if ninja -C "$folder" -n "$@" 2>/dev/null | grep -q 'no work to do'; then
    return 0
  fi
  echo "building build/$preset" >&2
  if ! cmake --build "$folder" "${targets[@]}" >&2; then
    echo "the build of build/$preset failed: the first error stands above" >&2
    return 1
  fi
}
