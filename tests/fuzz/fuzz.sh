#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# bash fuzz.sh BUILD_DIR SECONDS scene|mesh|texture [fresh]: fuzzes one input for that long, from seeds
# and from what earlier runs have kept in BUILD_DIR/corpus; fresh: from the seeds alone, and each time the
# same. A finding is written to BUILD_DIR/findings and ends the run with exit code 1.
set -euo pipefail

build=$1 seconds=$2 input=$3
root=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../..
models=/usr/share/assimp/models
largest=40000 # bytes: more of them make the fuzzer slow, not thorough

# A file system in memory, where there is one: each try writes its file.
scratch=$(mktemp -d -p "$([[ -w /dev/shm ]] && echo /dev/shm || echo "${TMPDIR:-/tmp}")")
seeds=$scratch/seeds corpus=$build/corpus/$input findings=$build/findings options=()
[[ ${4:-} != fresh ]] || corpus=$scratch/corpus options=(-seed=1)
mkdir -p "$seeds" "$scratch/tmp" "$corpus" "$findings"

clean_up() {
    rm -rf "$scratch"
    # Logs of no more than a line are of readers that crashed where they may.
    find "$findings" -name 'sanitizer-*' -size -100c -delete
}
trap clean_up EXIT

# list_files NAMES...: the files with such endings that may be seeds.
list_files() {
    local ending endings=()
    for ending in "$@"; do
        endings+=(-o -iname "*.$ending")
    done
    find "$models" "$root/scenes" "$root/tests/fuzz/seeds" -type f -size "-${largest}c" \( "${endings[@]:1}" \)
}

# The first byte says which format it is, by its place in the list of inputs.h.
mesh_seeds() {
    local formats format file count=0
    mapfile -t formats < <(sed -n '/mesh_formats\[\]/,/;/p' "$root/tests/fuzz/inputs.h" |
        grep -o '"[a-z0-9]*"' | tr -d '"')
    for format in "${!formats[@]}"; do
        while IFS= read -r file; do
            # shellcheck disable=SC2059 # the byte is the format
            { printf "\\x$(printf %02x "$format")"; cat "$file"; } >"$seeds/$((++count))"
        done < <(list_files "${formats[format]}")
    done
}

files=()
case $input in
    scene)
        mapfile -t files < <(find "$root/scenes" -name '*.toml')
        options+=(-only_ascii=1)
        ;;
    mesh) mesh_seeds ;;
    texture) mapfile -t files < <(list_files png jpg bmp tga webp ppm pgm pbm) ;;
esac
for file in "${!files[@]}"; do
    cp "${files[file]}" "$seeds/file$file"
done

# Large meshes would take all of the time.
[[ $input != scene ]] || sed -i 's/^file = .*/file = "cube.obj"/' "$seeds"/*

# What a library gets wrong in sight of AddressSanitizer is not its finding.
printf 'interceptor_via_lib:%s\n' libassimp libfreeimage libstb >"$scratch/suppressions"
export ASAN_OPTIONS=suppressions=$scratch/suppressions:log_path=$findings/sanitizer-$input:quarantine_size_mb=8
export STAGELIGHT_ASSETS=$root/scenes TMPDIR=$scratch/tmp
# The time is longer than run_sandboxed lets a reader take and wait, and an allocation may be of any size: it
# fails there.
"$build/tests/fuzz/fuzz_$input" -max_total_time="$seconds" -max_len="$largest" -timeout=120 \
    -rss_limit_mb=2048 -malloc_limit_mb=1000000 -artifact_prefix="$findings/$input-" \
    -print_final_stats=1 "${options[@]}" "$corpus" "$seeds" || exit 1
