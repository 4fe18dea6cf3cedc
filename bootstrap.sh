#!/bin/sh
# Installs the Debian packages that validate needs, configures the release preset and builds build/validate and
# build/validate-atoms, with --tests the tests too. Safe to run again: what is present is skipped.
set -eu

# One package per line: everything whose headers, libraries or programs the build and the tests use. (The package
# lammps holds only the program, which the CMake package of liblammps-dev insists on.)
packages='
cmake
fonts-dejavu-core
g++
gnuplot-nox
lammps
lammps-data
libbenchmark-dev
libblas-dev
libcli11-dev
libeigen3-dev
libfmt-dev
libgsl-dev
libgtest-dev
libhdf5-dev
libhypre-dev
liblapack-dev
liblammps-dev
libopenblas0-serial
libspdlog-dev
libssl-dev
libsuitesparse-dev
libtomlplusplus-dev
libvalijson-dev
libzip-dev
ninja-build
nlohmann-json3-dev
openmpi-bin
patch
pkg-config
python3-h5py
python3-meshio
'

usage() {
  cat <<'TXT'
usage: ./bootstrap.sh [--tests] [--ci] [--with-kim] [--no-install] [--list] [--help]

  --tests       build the tests too, for: ctest --preset default
  --ci          install what .ci/run and .ci/nightly need too (chromium, clang, clang-format, clang-tidy), make every
                warning an error, and build the tests
  --with-kim    install the OpenKIM models too (openkim-models): more potentials, and their tests
  --no-install  do not install packages; stop with the list of what is missing
  --list        print the Debian packages, one per line, and stop
  --help        this text

Installing needs root or sudo without a password. Exit codes: 0 built, 1 the build failed,
2 packages are missing and could not be installed, or the system is not Debian.
TXT
}

install=yes
preset=release
targets='validate validate-atoms'
for argument in "$@"; do
  case "$argument" in
    --tests) targets=all ;;
    --ci) targets=all preset=ci packages="$packages chromium clang clang-format clang-tidy" ;;
    --with-kim) packages="$packages openkim-models" ;;
    --no-install) install=no ;;
    --list) printf '%s\n' $packages; exit 0 ;;
    --help|-h) usage; exit 0 ;;
    *) echo "bootstrap.sh: unknown option '$argument'" >&2; usage >&2; exit 2 ;;
  esac
done

cd "$(dirname "$0")"

if ! command -v dpkg-query >/dev/null 2>&1 || ! command -v apt-get >/dev/null 2>&1; then
  cat >&2 <<'TXT'
bootstrap.sh: this is not a Debian system, so it cannot install packages here.
Install these by your system's own means, then run: cmake --preset release && cmake --build build
  a C++20 compiler (g++ 12 or later), CMake 3.25, Ninja, pkg-config
  LAMMPS as a shared library with MPI, packages MANYBODY and KSPACE, and its potential files
  Open MPI or another MPI with mpiexec
  Eigen 3.4, SuiteSparse (CHOLMOD), OpenBLAS, GSL 2.7, HDF5 (C library), libzip
  hypre with MPI, if sheets of more than 100000 atoms are to be computed in a reasonable time
  OpenSSL (libcrypto), CLI11, toml++ 3, fmt, spdlog, nlohmann-json; for the tests GoogleTest, valijson and h5py
  gnuplot with pngcairo and the DejaVu fonts
TXT
  exit 2
fi

missing=
for package in $packages; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) || status=absent
  [ "$status" = installed ] || missing="$missing $package"
done

if [ -n "$missing" ]; then
  echo "bootstrap.sh: packages to install:$missing"
  if [ "$(id -u)" -eq 0 ]; then as_root='env'
  elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then as_root='sudo -n env'
  else as_root=; fi
  if [ "$install" = no ] || [ -z "$as_root" ]; then
    [ "$install" = no ] || echo "bootstrap.sh: neither root nor sudo without a password." >&2
    echo "bootstrap.sh: run this as root, then ./bootstrap.sh again:" >&2
    echo "  apt-get update && apt-get install -y --no-install-recommends$missing" >&2
    exit 2
  fi
  if ! $as_root apt-get -q update ||
     ! $as_root DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends $missing; then
    echo "bootstrap.sh: installing failed; see the messages of apt-get above." >&2
    exit 2
  fi
fi

cmake --preset $preset
cmake --build --preset $preset --target $targets
echo "bootstrap.sh: built build/validate and build/validate-atoms; try: build/validate indentation --radius 30"
