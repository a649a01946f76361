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
    printf '# %s\n\n*10 minutes, easy*\n' "$1" >"$folder/README.md"
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

# core_of MISTAKES...: a core exercise whose kernel says "value 1", where each mistake is a line of Python. The program
# draws a tenth of the value, everywhere.
core_of() {
    local folder=$stage/core/1_value
    mkdir -p "$folder"
    printf '### value: what is drawn\n\n*20 minutes, moderate*\n' >"$folder/README.md"
    printf '// stages/01_first/kernel.cl\n// #region one\nvalue 7\n// #endregion one\n' >"$folder/exercise.cl"
    printf '// #region one\nvalue 1\n// #endregion one\n' >"$stage/kernel.cl"
    {
        printf '%s\n' 'import numpy as np' 'MISTAKES = [' "$@" ']'
        printf '%s\n' 'def check(attempt):' \
            '    attempt.expect_same(attempt.render(size=(4, 4)), np.full((4, 4, 3), 0.1), "the value")'
    } >"$folder/test.py"
    cat >"$scratch/build/stages/01_first" <<'END'
#!/usr/bin/python3
import re, sys, numpy as np, OpenImageIO as oiio
value = int(re.search(r"value (\d)", open(sys.argv[-1] + "/stages/01_first/kernel.cl").read())[1]) / 10
image = oiio.ImageBuf(oiio.ImageSpec(4, 4, 3, oiio.FLOAT))
image.set_pixels(oiio.ROI(), np.full((4, 4, 3), value, np.float32))
image.write(sys.argv[sys.argv.index("--out") + 1])
END
}

mistakes=('("1", "2", "a two"),' '("1", "3", "a three"),' '("1", "4", "a four"),' '("1", "5", "a five"),'
    '("1", "6", "a six"),')

test_a_core_exercise_is_proven() {
    core_of "${mistakes[@]}"
    exercise prove
    expect_text "its stub" "01 value: solved; without, the value: 16 of 16 pixels differ" "$output"
    expect_equal "the last line" "exercises: 1 passed, 0 failed" "${output##*$'\n'}"
    local faults=('("1", "1", "no mistake"),' '("1", "2", "also a two"),' '("8", "9", "of another text"),' '')
    local told=("the test passes the mistake 'no mistake'" "'also a two' is taken for 'a two'"
        "stages/01_first/core/1_value/test.py: '8' is in its regions 0 times, expected once"
        "4 mistakes: expected 5 or more") i
    for i in "${!faults[@]}"; do
        core_of "${mistakes[@]:0:4}" "${faults[i]}"
        exercise prove
        expect_equal "exit code" 1 $code
        expect_text "what is wrong with it" "01 value: FAILED: " "$output"
        expect_text "what is wrong with it" "${told[i]}" "$output"
    done
}

test_a_core_exercise_is_done() {
    local file=work/01_first/value.cl
    core_of "${mistakes[@]}"
    exercise_of 1_long given
    sed -i 's/10 minutes, easy/90 minutes, hard/' "$stage/exercises/1_long/README.md"
    exercise_of 2_short given
    exercise list
    expect_equal "the list" "$(printf '%s\n' '01 value                  20 min  moderate  what is drawn' \
        '01 2_short                10 min  easy      2_short' '01 1_long                 90 min  hard      1_long')" \
        "$output"
    exercise status
    expect_equal "nothing is done" "0 of 3 done: 0 of 120 minutes" "${output##*$'\n'}"
    exercise 01 value
    expect_text "what is to be changed" "what to change: $file" "$output"
    [[ $output != *" a "* ]] || fail "the stub is taken for a mistake:" "$output"
    exercise reset 01 value
    expect_equal "a stub" "$file: nothing to reset" "$output"
    sed -i 's/7/4/' "$checkout/$file"
    exercise 01 value
    expect_text "the mistake's sentence" $'\na four\nNot yet.' "$output"
    exercise status
    expect_text "a file" "01 value                  20 min  moderate  begun"$'\n' "$output"
    sed -i 's/4/1/' "$checkout/$file"
    exercise 01 value
    expect_equal "exit code" 0 $code
    exercise status
    expect_text "done" "01 value                  20 min  moderate  done on $(date +%F)"$'\n' "$output"
    expect_equal "the sum" "1 of 3 done: 20 of 120 minutes" "${output##*$'\n'}"
    echo >>"$checkout/$file"
    exercise status
    expect_text "another file" "changed since it passed on $(date +%F)" "$output"
    exercise reset 01 value
    expect_equal "exit code" 2 $code
    expect_equal "work is not thrown away" \
        "stagelight: exercise reset: $file has work of yours: copy it elsewhere, then give --yes" "$output"
    expect_text "work" "value 1" "$(<"$checkout/$file")"
    exercise reset 01 value --yes
    expect_text "the stub" "value 7" "$(<"$checkout/$file")"
    exercise 01 value --solution
    expect_equal "the course's own kernels" "Done: the test passes." "${output##*$'\n'}"
    exercise 01 valve
    expect_equal "exit code" 2 $code
    exercise reset 01 value --solution
    expect_equal "exit code" 2 $code
}

"test_$name"
