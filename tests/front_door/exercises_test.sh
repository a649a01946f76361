#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# stages/exercises.py in a scratch checkout whose only stage is a fake: it shows the kernel that it is given, and fails.
# shellcheck source-path=SCRIPTDIR
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

checkout=$scratch/checkout
stage=$checkout/stages/01_first
copy=$checkout/work/01_first/1_one.cl
mkdir -p "$stage/exercises" "$scratch/build/stages"
cp "$source_dir/stages/exercises.py" "$checkout/stages"
printf '// #region one\nours\n// #endregion one\nrest\n' >"$stage/kernel.cl"
# shellcheck disable=SC2016 # expanded by the program
printf '#!/bin/bash\ncat "${@: -1}/stages/01_first/kernel.cl" >&2\nexit 1\n' >"$scratch/build/stages/01_first"
chmod +x "$scratch/build/stages/01_first"

# exercise_of NAME LINES...: an exercise whose region has these lines; the first is line 3.
exercise_of() {
    local folder=$stage/exercises/$1
    mkdir "$folder"
    echo "# $1" >"$folder/README.md"
    printf 'def check(attempt):\n    attempt.render()\n' >"$folder/test.py"
    printf '%s\n' '// stages/01_first/kernel.cl' '// #region one' "${@:2}" '// #endregion one' >"$folder/exercise.cl"
}

# exercise ARGUMENTS...
exercise() {
    code=0
    output=$(cd "$scratch" && /usr/bin/python3 -B "$checkout/stages/exercises.py" "$scratch/build" "$@" 2>&1) || code=$?
}

# expect_kernel WHAT LINES...: what stands in the region.
expect_kernel() {
    local region
    region=$(sed -n '/#region/,/#endregion/{//!p}' <<<"$output")
    expect_equal "$1" "$(printf '%s\n' "${@:2}" '#line 3 "stages/01_first/kernel.cl"')" "$region"
}

test_a_part_of_the_file() {
    local file=stages/01_first/exercises/1_one/exercise.cl
    exercise_of 1_one given '// #stub' empty '// #solution' written twice '    # #end' \
        more '<!-- #stub -->' '// #solution' last '/* #end */'
    exercise 01 1
    expect_equal "exit code" 1 $code
    expect_text "which file to change" "what to change: work/01_first/1_one.cl" "$output"
    expect_kernel "the stub" '#line 3 "work/01_first/1_one.cl"' given empty more
    expect_equal "the student's file" \
        "$(printf '%s\n' '// stages/01_first/kernel.cl' '// #region one' given empty more '// #endregion one')" \
        "$(<"$copy")"
    sed -i 's/empty/mine/' "$copy"
    exercise 01 1
    expect_kernel "what the student wrote" '#line 3 "work/01_first/1_one.cl"' given mine more
    exercise 01 1 --solution
    expect_kernel "the solution" "#line 3 \"$file\"" given "#line 7 \"$file\"" written twice "#line 10 \"$file\"" more \
        "#line 13 \"$file\"" last
    exercise prove
    expect_kernel "the stub that is proven" "#line 3 \"$file\"" given "#line 5 \"$file\"" empty \
        "#line 10 \"$file\"" more
}

test_marks_that_are_wrong() {
    local line lines
    exercise_of 1_end '// #end'
    exercise_of 2_solution given '// #solution' written '// #end'
    exercise_of 3_no_solution '// #stub' empty '// #end'
    exercise_of 4_twice '// #stub' empty '// #solution' written '// #stub'
    exercise_of 5_open '// #stub' empty '// #solution' written
    exercise_of 6_misspelt '// #stub' empty '// #soluton' written '// #end'
    exercise prove
    expect_equal "exit code" 1 $code
    mapfile -t lines <<<"$output"
    expect_equal "lines" 7 ${#lines[@]}
    for line in "1_end/exercise.cl:3: #end: expected #stub before it" \
        "2_solution/exercise.cl:4: #solution: expected #stub before it" \
        "3_no_solution/exercise.cl:5: #end: expected #solution before it" \
        "4_twice/exercise.cl:7: #stub: expected #end before it" \
        "5_open/exercise.cl:5: #solution: expected #end after it" \
        "6_misspelt/exercise.cl:7: #end: expected #solution before it"; do
        expect_text "a wrong mark" "stages/01_first/exercises/$line"$'\n' "$output"
    done
    exercise 01 1
    expect_equal "exit code" 1 $code
    expect_equal "all of the message" \
        "stagelight: stages/01_first/exercises/1_end/exercise.cl:3: #end: expected #stub before it" "$output"
    [[ ! -e $checkout/work ]] || fail "a student's file was made of it"
}

"test_$name"
