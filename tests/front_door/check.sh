# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# For the scripts beside it: bash SCRIPT NAME SOURCE_DIR BINARY_DIR runs its test_NAME.
set -euo pipefail

export LC_ALL=C
# shellcheck disable=SC2034 # for the scripts that source this
name=$1 source_dir=$2 binary_dir=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() {
    printf '%s\n' "$@" >&2
    exit 1
}

# expect_empty WHAT_IS_WRONG LINES
expect_empty() { [[ -z $2 ]] || fail "$1:" "$2"; }

# expect_equal WHAT EXPECTED ACTUAL
expect_equal() { [[ $2 == "$3" ]] || fail "$1" "expected: $2" "actual:   $3"; }

# expect_text WHAT PART ACTUAL
expect_text() { [[ $3 == *"$2"* ]] || fail "$1" "expected to hold: $2" "actual: $3"; }
