#!/bin/sh
# The Python example of a README reads a run.h5 that was just made.
# usage: readme_example_test.sh VALIDATE README
set -eu
validate=$1 readme=$2

python=
for candidate in /usr/bin/python3 python3; do
  if "$candidate" -c 'import h5py' 2>/dev/null; then python=$candidate; break; fi
done
[ -n "$python" ] || { echo "no Python with h5py"; exit 77; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
"$validate" indentation --models membrane --radius "0.5 um" --E "1.0209 TPa" --thickness "0.335 nm" --nu 0.165 \
  --pretension "0.34 N/m" --loads disc --tip-radius "16.5 nm" --depth-step "20 nm" --out run --quiet >table
awk '/^```python$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$readme" >example.py
[ -s example.py ] || { echo "$readme has no Python example"; exit 1; }
cd run
"$python" ../example.py >../printed
cat ../printed
# What it prints: one line per run, E·h as used (342 N/m) and as read by Eq. 16 (more, the tip being no point).
awk '/membrane disc/ { if ($4 > 341 && $4 < 343 && $6 > 1.1 * $4) ok = 1 } END { exit !ok }' ../printed
grep -q 'eV/Å' ../printed
