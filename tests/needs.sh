#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# needs.sh PROGRAM SCRIPT ARGUMENTS...: runs the test, or leaves it out on a system without that
# program: packages/test.txt has it as optional.
if ! command -v "$1" >/dev/null; then
    echo "left out: this system has no $1"
    exit 77
fi
exec bash "${@:2}"
