#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# precision_test.sh SOURCE_DIR least|filter PROGRAM FILTER: the program's tests on PoCL pass with kernels that are
# that imprecise.
set -euo pipefail

source_dir=$1 what=$2 program=$3 filter=$4
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
/usr/bin/python3 -B "$source_dir/tests/precision/imprecise.py" "$source_dir" "$scratch" "$what"
export STAGELIGHT_KERNELS=$scratch STAGELIGHT_DEVICE=pocl
unset STAGELIGHT_RESULTS # these are not the project's pictures
output=$("$program" --gtest_filter="$filter" 2>&1) || { echo "$output"; exit 1; }
grep -q '\[  PASSED  \] [1-9]' <<<"$output" || { echo "no test ran: $filter" "$output"; exit 1; }
