#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# mutants_test.sh SOURCE_DIR KERNELS_TESTS: every known mistake is where mutants.toml says; one is planted and
# caught, one is seen by nobody, and others can't be planted. Of mistakes at random, that a seed draws the same again.
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

# Of those that are asked last, one: it looks for a mistake that no program of the above sees.
cat >build/CTestTestfile.cmake <<'TESTS'
add_test(stability.last bash -c "! grep unseen $STAGELIGHT_KERNELS/kernels/fresnel/schlick.cl")
set_tests_properties(stability.last PROPERTIES LABELS stability)
TESTS

list=$source_dir/tests/mutants/mutants.toml
mutate 0 "caught by 1: On/KernelsStage04Schlick.ReflectanceMatchesDouble
1 of 1 mistakes caught" "$list" schlick_to_the_fourth
grep -q '"caught": \[' out/mutants.json
seen 'slope_squared * slope;' 'slope * slope_squared;' >same.toml
mutate 1 "SURVIVES
0 of 1" same.toml
seen 'slope_squared * slope;' 'slope * slope_squared;  // unseen' >last.toml
mutate 1 "MISSED by its stage, caught by stability.last" last.toml
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
mutate 2 "--random N --seed S: expected two whole numbers" "$list" --random 3
mutate 2 "--random glass: expected kernels, host, reference" "$list" --random 3 --seed 1 glass
if [[ -e calls ]]; then
    echo "tests were run before the mistakes were known to be there:" "$(<calls)" >&2
    exit 1
fi

# drawn SEED: mistakes of each kind, as they would be told.
drawn() {
    PYTHONPATH=$source_dir/tests/mutants /usr/bin/python3 -B - "$source_dir" "$1" <<'PYTHON'
import itertools, pathlib, sys
import draw
root, seed = pathlib.Path(sys.argv[1]), int(sys.argv[2])
for kind in draw.KINDS:
    for mistake in itertools.islice(draw.draw(root, kind, seed), 200):
        text = (root / mistake.file).read_text()
        assert mistake.planted(text) != text, mistake
        assert len(mistake.planted(text).split("\n")) == len(text.split("\n")), mistake
        print(mistake.told(text))
PYTHON
}
drawn 7 >once
[[ $(sort -u once | wc -l) == 600 ]] || { echo "expected 600 different mistakes, one of each draw" >&2 && exit 1; }
drawn 7 | cmp - once
drawn 8 >other
! cmp -s once other
