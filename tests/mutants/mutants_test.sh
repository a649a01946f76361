#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# mutants_test.sh SOURCE_DIR KERNELS_TESTS: every known mistake is where mutants.toml says; one is planted and
# caught, one is seen by nobody, and others can't be planted.
set -euo pipefail

source_dir=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# Of all checks, one suite.
for program in golden:none render:none kernels:'*KernelsStage04Schlick*'; do
    folder=build/tests/${program%:*}
    mkdir -p "$folder"
    printf '#!/bin/bash\necho "$@" >>%q\nexec %q "$@" --gtest_filter=%q\n' "$scratch/calls" "$2" "${program#*:}" \
        >"$folder/${program%:*}_tests"
    chmod +x "$folder/${program%:*}_tests"
done

# mutate EXIT_CODE TEXT MUTANTS [NAME…]: ends so, and says that.
mutate() {
    local wanted=$1 text=$2 said code=0
    shift 2
    said=$(/usr/bin/python3 "$source_dir/tests/mutants/mutate.py" "$source_dir" build "$@" 2>&1) || code=$?
    if [[ $code != "$wanted" || $said != *"$text"* ]]; then
        printf '%s\n' "of mutate ${*:2}" "expected $wanted: $text" "found $code: $said" >&2
        exit 1
    fi
}

# seen FIND REPLACE: a list of one mistake in Schlick's formula.
seen() {
    printf '[[mutants]]\nname = "mine"\nstage = "04"\nfile = "kernels/fresnel/schlick.cl"\nregion = "schlick"\n'
    printf "find = '%s'\nreplace = '%s'\nmistake = \"\"\n" "$@"
}

list=$source_dir/tests/mutants/mutants.toml
mutate 0 "caught by 1: On/KernelsStage04Schlick.ReflectanceMatchesDouble
1 of 1 mistakes caught" "$list" schlick_to_the_fourth
grep -q '"caught": \[' out/mutants.json
seen 'slope_squared * slope;' 'slope * slope_squared;' >same.toml
mutate 1 "SURVIVES
0 of 1" same.toml
seen 'slope_squared * slope;' 'slope_cubed;' >broken.toml
mutate 1 "stagelight: mutate: mine: the kernel does not build: " broken.toml

rm calls
seen 'slope ' 'slop ' >often.toml
mutate 1 "stagelight: mutate: mine: kernels/fresnel/schlick.cl, region schlick: expected once, found 2 times: slope " often.toml
seen 'float unit' '' >moved.toml
mutate 1 "mine: kernels/fresnel/schlick.cl, region schlick: expected once, found 0 times" moved.toml
sed 's/"schlick"/"snell"/' same.toml >nowhere.toml
mutate 1 "region snell: there is no such region" nowhere.toml
mutate 2 "no mistake 'typo'; there are: camera_corner_of_pixel, " "$list" typo
if [[ -e calls ]]; then
    echo "tests were run before the mistakes were known to be there:" "$(<calls)" >&2
    exit 1
fi
