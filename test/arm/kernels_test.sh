#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the kernels for 64-bit ARM with a cross compiler and runs them on an emulated processor.
#   test/arm/kernels_test.sh FOLDER    # to build in
set -euo pipefail
repository=$(cd "$(dirname "$0")/../.." && pwd)
folder=${1:?expected a folder to build in}
for tool in aarch64-linux-gnu-g++ qemu-aarch64; do
  if ! command -v "$tool" > /dev/null; then
    echo "skipped: there is no $tool (apt install g++-aarch64-linux-gnu qemu-user)"
    exit 77
  fi
done
mkdir -p "$folder"
includes=("-I$repository/include" "-I$repository/src" -isystem /usr/include/eigen3)
ln -sfn /usr/include/boost "$folder/boost"  # headers alone; those of this machine's libc stay away
aarch64-linux-gnu-g++ -std=c++17 -O2 -ffp-contract=off -Wall -Wextra -Werror -static "${includes[@]}" \
  -isystem "$folder" "$repository/test/arm/kernels.cpp" \
  "$repository/src/observation/field_kernel.cpp" "$repository/src/ser/range_kernel.cpp" \
  -o "$folder/kernels"
qemu-aarch64 "$folder/kernels"
