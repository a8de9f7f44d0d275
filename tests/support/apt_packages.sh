# shellcheck shell=bash
# Sourced. need_packages names...: installs those of the named Debian packages that are missing. A package counts as
# present where a command of its name is there, so that tools from elsewhere serve as well. Without apt or without root
# it says what is missing and ends the script with status 1.
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
