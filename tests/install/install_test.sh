#!/bin/sh
# The installed program works on its own: cmake --install into an empty folder, then a run from another empty one.
# usage: install_test.sh CMAKE BUILD_FOLDER VALIDATE_DOCUMENT
set -eu
cmake=$1 build=$2 validate_document=$3

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$cmake" --install "$build" --prefix "$folder/prefix" >"$folder/install.log"
mkdir "$folder/elsewhere"
cd "$folder/elsewhere"

unset VALIDATE_INPUTS
code=0
"$folder/prefix/bin/validate" indentation --radius 15 --potential tersoff --tip-radius 5 --depth-step 1 --depth-max 4 \
  --out run || code=$?
[ "$code" -eq 0 ] || [ "$code" -eq 3 ] || { echo "the installed program ended with $code" >&2; exit 1; }
"$validate_document" "$folder/prefix/share/validate/summary.schema.json" run/summary.json
for file in run.h5 curves.csv figure.svg figure.png figure.csv lammps.log atoms-disc.extxyz; do
  [ -s "run/$file" ] || { echo "run/$file is missing or empty" >&2; exit 1; }
done
