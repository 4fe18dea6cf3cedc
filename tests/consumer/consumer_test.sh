#!/bin/sh
# The membrane as others use it: installed, found by find_package(), linked, and solved with. No file that tells others how
# to use it may name the checkout or the build folder.
# usage: consumer_test.sh CMAKE SOURCE_FOLDER BUILD_FOLDER
set -eu
cmake=$1 source=$2 build=$3

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$cmake" --install "$build" --component membrane --prefix "$folder/prefix" >"$folder/install.log"
if grep -rIl -e "$source" -e "$build" "$folder/prefix"; then
  echo "these files name the checkout or the build folder" >&2
  exit 1
fi
cp -r "$source/tests/consumer" "$folder/consumer"
"$cmake" -S "$folder/consumer" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/prefix" -DCMAKE_BUILD_TYPE=Release \
  >"$folder/log" 2>&1 && "$cmake" --build "$folder/build" >>"$folder/log" 2>&1 || { cat "$folder/log" >&2; exit 1; }
"$folder/build/disc"
