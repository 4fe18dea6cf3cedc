#!/bin/sh
# Nothing rests on what a machine happens to have: every header and library that the build used, and every program and
# data file that a run needs, belongs to a package of bootstrap.sh or to one that such a package depends on.
# usage: package_test.sh SOURCE_FOLDER BUILD_FOLDER NINJA
set -eu
source=$1 build=$2 ninja=$3

command -v dpkg-query >/dev/null 2>&1 || { echo "not a Debian system: nothing to compare"; exit 77; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Headers from the compiler's own dependency records, libraries from the link commands, and what is looked for at run time.
{
  "$ninja" -C "$build" -t deps | sed -n 's/^ *\(\/usr\/[^ ]*\)$/\1/p'
  grep -o '/usr/lib[^ ]*\.\(so\|a\)[.0-9]*' "$build/build.ninja"
  ldd "$build/validate" "$build/validate-atoms" | sed -n 's/.*=> \(\/[^ ]*\) .*/\1/p'
  for program in gnuplot mpiexec cmake c++ patch "$ninja"; do command -v "$program"; done
  echo /usr/share/lammps/potentials/CH.airebo
  echo /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
} | sort -u | xargs realpath | sort -u >"$work/files"

# /usr/lib and /lib are one folder; packages may list either.
xargs dpkg -S <"$work/files" 2>/dev/null >"$work/found" || true
sed 's/^[^:]*\(:[a-z0-9]*\)*: //' "$work/found" | sort -u >"$work/known"
comm -23 "$work/files" "$work/known" | sed 's,^/usr/lib,/lib,' | xargs -r dpkg -S >>"$work/found" 2>"$work/orphans" || true
if grep -q . "$work/orphans"; then
  echo "files of no package:" >&2
  cat "$work/orphans" >&2
  exit 1
fi
sed 's/: .*//; s/:[a-z0-9]*$//' "$work/found" | tr ',' '\n' | sed 's/^ *//; s/:[a-z0-9]*$//' | sort -u >"$work/owners"

# The packages of bootstrap.sh, and step by step those that they depend on.
"$source/bootstrap.sh" --list | sort -u >"$work/allowed"
dpkg-query -W -f='${Package}|${Depends}, ${Pre-Depends}\n' | sed 's/([^)]*)//g; s/:[a-z0-9]*//g; s/ //g' >"$work/depends"
dpkg-query -W -f='${Package}|${Provides}\n' | sed 's/([^)]*)//g; s/ //g' >"$work/provides"
while :; do
  awk -F'|' -v allowed="$work/allowed" -v provides="$work/provides" '
    BEGIN {
      while ((getline line <provides) > 0) {
        split(line, part, "|"); n = split(part[2], names, ",")
        for (i = 1; i <= n; ++i) provider[names[i]] = provider[names[i]] " " part[1]
      }
      while ((getline name <allowed) > 0) { seen[name] = 1; print name }
    }
    $1 in seen {
      sub(/^[^|]*\|/, ""); n = split($0, names, /[,|]/)
      for (i = 1; i <= n; ++i) {
        print names[i]
        m = split(provider[names[i]], real, " ")
        for (j = 1; j <= m; ++j) print real[j]
      }
    }' "$work/depends" | grep . | sort -u >"$work/more"
  cmp -s "$work/allowed" "$work/more" && break
  mv "$work/more" "$work/allowed"
done

comm -23 "$work/owners" "$work/allowed" >"$work/missing"
if [ -s "$work/missing" ]; then
  echo "bootstrap.sh does not install these packages, which the build used:" >&2
  while read -r package; do
    echo "  $package: $(grep -m1 "^$package[:,]" "$work/found")" >&2
  done <"$work/missing"
  exit 1
fi
echo "$(wc -l <"$work/files") files of $(wc -l <"$work/owners") packages, all installed by bootstrap.sh"
