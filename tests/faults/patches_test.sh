#!/bin/sh
# Every patch applies to the sources as they are, to the letter, and says what it breaks, which group sees it and by which row.
# usage: patches_test.sh SOURCE_FOLDER PATCH...
set -eu
source=$1
shift
[ $# -gt 0 ] || { echo "no patch was given" >&2; exit 1; }

bad=0
for patch in "$@"; do
  patch --dry-run --strip=1 --fuzz=0 --forward --silent --directory="$source" <"$patch" ||
    { echo "$patch: does not apply; make it anew" >&2; bad=1; }
  for key in group row; do
    grep -q "^$key: ." "$patch" || { echo "$patch: says no $key" >&2; bad=1; }
  done
  sed 1q "$patch" | grep -q '^[A-Z].*\.$' || { echo "$patch: its first line does not say what it breaks" >&2; bad=1; }
done
exit $bad
