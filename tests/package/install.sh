#!/usr/bin/env bash
# install.sh build configuration folder: installs the library and moves the tree to folder/prefix, where the consumers
# find it: whatever remembers the place it was installed to fails there.
set -euo pipefail
build=$1
configuration=$2
folder=$3

rm -rf "$folder"
mkdir -p "$folder"
"${CMAKE:-cmake}" --install "$build" --config "$configuration" --prefix "$folder/installed"
mv "$folder/installed" "$folder/prefix"
if grep -rIl -e "$folder" -e "$build" "$folder/prefix"; then
  echo "these files name the place of the build or of the installation"
  exit 1
fi
