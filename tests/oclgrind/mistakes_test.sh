#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# mistakes_test.sh SOURCE_DIR 01_PROGRAM 04_PROGRAM: oclgrind_test.sh must fail on kernels with an
# access out of bounds, a data race, a stack that is too small.
set -euo pipefail

source_dir=$1 primitives=$2 glass=$3
here=$(dirname "$0")
spheres=$source_dir/scenes/01_primitives.toml
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# expect_report TEXT PROGRAM SCENE FILE SED_COMMAND: the report on the kernels with that change
# holds the text.
expect_report() {
    local text=$1 program=$2 scene=$3 file=$4 change=$5 said
    rm -rf "${scratch:?}/mine"
    mkdir "$scratch/mine"
    cp -r "$source_dir/kernels" "$source_dir/stages" "$scratch/mine"
    sed -i "$change" "$scratch/mine/$file"
    if cmp -s "$source_dir/$file" "$scratch/mine/$file"; then
        printf 'nothing changed in %s by %s\n' "$file" "$change"
        exit 1
    fi
    if said=$(bash "$here/oclgrind_test.sh" "$program" "$scene" --kernels "$scratch/mine" 2>&1) \
        || [[ $said != *"$text"* ]]; then
        printf 'expected a report with "%s" on %s, changed by %s; it said:\n%s\n' \
            "$text" "$file" "$change" "$said"
        exit 1
    fi
}

expect_report "Invalid write of size 16" "$primitives" "$spheres" kernels/picture.cl \
    's/image\[pixel.y \*/image[1 + pixel.y */'
expect_report "Invalid read of size" "$primitives" "$spheres" kernels/each_shape.cl \
    's/i < scene->sphere_count/i <= scene->sphere_count/'
expect_report "Write-write data race" "$primitives" "$spheres" kernels/picture.cl \
    's/image\[pixel.y \* width + pixel.x\]/image[pixel.y]/'
expect_report "Invalid write of size" "$glass" "$here/glass_row.toml" kernels/ray_stack.cl \
    's/rays\[STACK_SIZE\]/rays[STACK_SIZE - 1]/'
