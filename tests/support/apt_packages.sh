# shellcheck shell=bash
# Sourced, in the root of the project.
#
# need_packages names...: installs those of the named Debian packages that are missing. A package counts as present where
# a command of its name is there, so that tools from elsewhere serve as well. Without apt or without root it says what is
# missing and ends the script with status 1.
need_packages() {
  local package missing=()
  for package in "$@"; do
    command -v "$package" >/dev/null && continue
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] && continue
    missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return

  if ! command -v apt-get >/dev/null; then
    echo "Missing, under the names they have in Debian: ${missing[*]}" >&2
    exit 1
  fi
  if [ "$(id -u)" -ne 0 ]; then
    echo "Missing packages. Install them as root:" >&2
    echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  echo "Installing ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -q
  apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# need_clang_format: version 14, which decides the layout. Debian 13 has it no more: there Python's package of the same
# program serves, put into build/tools, where tests/gates/format.sh finds it.
need_clang_format() {
  local tool
  for tool in clang-format-14 clang-format build/tools/clang_format/data/bin/clang-format; do
    case "$("$tool" --version 2>/dev/null)" in *"version 14."*) return ;; esac
  done
  if command -v apt-cache >/dev/null && [ "$(id -u)" -eq 0 ]; then
    apt-get update -q
    if apt-cache show clang-format-14 >/dev/null 2>&1; then
      need_packages clang-format-14
      return
    fi
  fi
  need_packages python3 python3-pip
  echo "Installing clang-format 14 into build/tools"
  python3 -m pip install --quiet --disable-pip-version-check --target build/tools clang-format==14.0.6
}

# use_ccache: has CMake's builds below this script, all of them, compile through ccache where there is one.
use_ccache() {
  command -v ccache >/dev/null || return 0
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  # as it advises for precompiled headers
  export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:+$CCACHE_SLOPPINESS,}pch_defines,time_macros
}
