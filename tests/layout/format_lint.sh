#!/bin/sh
# Every C++ file is as clang-format leaves it. usage: format_lint.sh SOURCE_FOLDER
set -eu
cd "$1"
find membrane atomistic compare tests cmake -name '*.[ch]pp' -print0 | sort -z | xargs -0 clang-format --dry-run -Werror
