#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# oclgrind_test.sh PROGRAM SCENE [OPTION …]: draws 32x20 pixels in oclgrind's simulator, and fails
# with its report if it has one.
set -euo pipefail

program=$1
shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# -O0: what LLVM 14 inlines holds an intrinsic that oclgrind 21.10 does not know, and a faulty read
# whose value nobody uses is kept. Not --uninitialized: it takes a buffer that was filled, and an
# image, for uninitialised.
oclgrind --data-races --uniform-writes --build-options -O0 --log "$scratch/report" \
    "$program" --device "Oclgrind Simulator" --size 32x20 --out "$scratch/picture.png" "$@"
if [[ -s $scratch/report ]]; then
    cat "$scratch/report"
    exit 1
fi
