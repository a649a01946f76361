#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What holds of every file of the project.
# shellcheck source-path=SCRIPTDIR
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# list_files NAMES...: the project's own files with such names (shell patterns), without git's help.
list_files() {
    local pattern names=()
    for pattern in "$@"; do
        names+=(-o -name "$pattern")
    done
    find "$source_dir" -mindepth 1 \( -name .git -o -name build -o -name out -o -name work -o -name node_modules \
        -o -path "$source_dir/docs/generated" \) -prune -o -type f \( "${names[@]:1}" \) -print
}

test_shellcheck() {
    mapfile -t files < <(list_files stagelight run '*.sh')
    shellcheck --external-sources "${files[@]}"
}

test_spdx_line() {
    local file
    while read -r file; do
        head -n 2 "$file" | grep -q 'SPDX-License-Identifier: MIT$' || echo "${file#"$source_dir"/}"
    done < <(list_files '*.h' '*.cpp' '*.cl' '*.toml' '*.cmake' CMakeLists.txt '*.sh' stagelight run
        find "$source_dir/packages" -type f) >"$scratch/without"
    expect_empty "no SPDX line at the head of" "$(<"$scratch/without")"
}

test_clang_format() {
    local version
    version=$(clang-format --version)
    if [[ $version != *"version 14."* ]]; then
        echo "left out: other versions of clang-format than 14 lay out the sources in other ways"
        exit 77
    fi
    # Not the parts of files that exercises and pictures put in place of others.
    list_files '*.h' '*.cpp' '*.cl' | grep -vE '/(stages/[^/]+/(exercises|core)|docs/pictures)/' |
        xargs -d '\n' clang-format --dry-run -Werror
}

test_no_large_file() {
    expect_empty "over 1 MB" "$(list_files '*' | xargs -d '\n' ls -l | awk '$5 > 1000000')"
}

test_stage_differences() {
    python3 "$source_dir/stages/difference.py" || fail "a stage adds too much: see above"
}

# A step that is too long, a line of the budget that nobody needs, and one for a stage that is not there.
test_stage_differences_see() {
    local copy=$scratch/copy line output
    mkdir "$copy"
    cp -r "$source_dir/stages" "$source_dir/kernels" "$copy"
    differ() {
        if output=$(python3 "$copy/stages/difference.py"); then fail "not seen: $1" "$output"; fi
    }
    {
        echo 'static float3 longer(float3 color) {'
        for line in {1..90}; do echo "    color += $line.0f;"; done
        echo '    return color;'
        echo '}'
    } >>"$copy/kernels/texture_coordinates.cl"
    python3 "$copy/stages/difference.py" || fail "what nothing calls counts"
    sed -i 's/return filtered(texel/return longer(wrapped.xyy) + filtered(texel/' "$copy/kernels/texture.cl"
    differ "a long step"
    expect_text "a long step" "06_textures               170 lines more, of 100" "$output"
    cp "$source_dir"/kernels/texture*.cl "$copy/kernels"
    printf '[08_gamma]\nlines = 90\n' >>"$copy/stages/budget.toml"
    differ "a line too many"
    expect_text "a line too many" "it keeps to the usual 100" "$output"
    sed -i 's/08_gamma/08_pictures/' "$copy/stages/budget.toml"
    differ "an unknown stage"
    expect_text "an unknown stage" "08_pictures: stages/budget.toml knows it" "$output"
    cp "$source_dir/stages/budget.toml" "$copy/stages"
    sed -i '/^"the beam"/d' "$copy/stages/budget.toml"
    differ "a module of no part"
    expect_text "a module of no part" "  packets/beam.cl: in no part of stages/budget.toml" "$output"
    cp "$source_dir/stages/budget.toml" "$copy/stages"
    sed -i 's/^part_lines = 250/part_lines = 150/' "$copy/stages/budget.toml"
    differ "a long part"
    expect_text "a long part" "of 150 at the most: a block of pixels" "$output"
}

# lists_without STAGE: of all that a new stage is added to by hand, what does not have it. CMake and the programs find
# it by its folder.
lists_without() {
    local stage=$1 number=${1%%_*} file pattern
    while read -r file pattern; do
        grep -qsE -- "$pattern" "$source_dir/$file" || echo "$file"
    done <<END
scenes/$stage.toml .
golden/$stage.exr .
docs/chapters/$stage.md .
docs/pictures/$number.toml .
README.md ^\\| \[$stage\]\(stages/$stage\) \\|
docs/index.md \(chapters/$stage\.md\):
docs/pov-ray.md ^\\| $stage \\|
docs/recorded/costs.json "stage": ?"$stage"
tests/oclgrind/CMakeLists.txt ^ *oclgrind_test\(\S+ $stage
tests/render/arguments_test.cpp DefaultScene\{"$stage"
tests/mutants/mutants.toml ^stage = "$number"
END
}

test_lists_of_stages() {
    local stages stage words file
    mapfile -t stages < <(cd "$source_dir/stages" && printf '%s\n' [0-9][0-9]_*)
    for stage in "${stages[@]}"; do
        expect_empty "$stage is missing in" "$(lists_without "$stage")"
    done
    expect_equal "lists without a stage that nobody has added" 11 "$(lists_without 99_new | wc -l)"
    words=(none one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen)
    for file in README.md CITATION.cff docs/index.md docs/.vitepress/config.mts; do
        expect_text "how many stages $file says there are" "in ${words[${#stages[@]}]} stages" "$(<"$source_dir/$file")"
    done
}

# A mark that is wrong, one that is missing, and a head that tells another story.
test_signposts_see() {
    local copy=$scratch/copy output
    mkdir "$copy"
    cp -r "$source_dir/stages" "$source_dir/kernels" "$copy"
    see() {
        if output=$(python3 "$copy/stages/difference.py"); then fail "not seen: $1" "$output"; fi
        expect_text "$1" "$1" "$output"
        cp -r "$source_dir/stages" "$source_dir/kernels" "$copy"
    }
    sed -i 's|^#include "closest_hit.cl"$|#include "closest_hit.cl"  // extended: a mirror|' "$copy"/stages/02*/kernel.cl
    see "02_shading_shadows/kernel.cl: closest_hit.cl is as before, and it says extended"
    sed -i '/#include "shadow.cl"/d' "$copy"/stages/02*/kernel.cl
    see "02_shading_shadows/kernel.cl: shadow.cl is new, and it says nothing"
    sed -i 's/05 (triangles) and/07 (triangles) and/' "$copy/kernels/each_shape.cl"
    see "kernels/each_shape.cl: its head says 01, 02, 07, 06; expected Introduced by stage 01, 02, 05, 06"
}

test_show() {
    local output code=0
    output=$(python3 "$source_dir/stages/show.py" 04 refract) || fail "show 04 refract ended with $?" "$output"
    expect_text "a function that is new" "+ static bool refract(" "$output"
    output=$(python3 "$source_dir/stages/show.py" 03 light_at) || fail "show 03 light_at ended with $?" "$output"
    expect_text "a function that is as before" $'\n'"  static Illumination light_at(" "$output"
    for arguments in "" "12" "four" "04 refrakt" "04 refract 05"; do
        # shellcheck disable=SC2086 # no argument at all is one of the cases
        output=$(python3 "$source_dir/stages/show.py" $arguments 2>&1) || code=$?
        expect_equal "exit code of show $arguments" 2 $code
        expect_equal "lines of show $arguments" 1 "$(wc -l <<<"$output")"
    done
    expect_text "an unknown function" "there are: " "$(python3 "$source_dir/stages/show.py" 04 refrakt 2>&1 || true)"
}

# In pictures too: their headers may name the folder where they were made.
test_no_path_of_a_machine() {
    expect_empty "paths of somebody's machine" "$(list_files '*' | xargs -d '\n' \
        grep -aHnoE '(^|[^[:alnum:]_.-])/(work|root|home)/.{0,40}' || true)"
}

# What is built, what is cited and what has changed are of one version.
test_versions_agree() {
    local built cited changed
    built=$(sed -n 's/^project(stagelight VERSION \([0-9.]*\) .*/\1/p' "$source_dir/CMakeLists.txt")
    cited=$(sed -n 's/^version: //p; s/^date-released: //p' "$source_dir/CITATION.cff")
    changed=$(sed -n '/^## Unreleased$/d; /^## /{s///p; q}' "$source_dir/CHANGELOG.md")
    expect_equal "CHANGELOG.md's newest entry against CITATION.cff" "${cited/$'\n'/, }" "$changed"
    expect_equal "CMakeLists.txt against CHANGELOG.md" "${changed%%, *}" "$built"
}

test_devcontainer_is_json() {
    python3 -m json.tool "$source_dir/.devcontainer/devcontainer.json" >/dev/null
}

"test_$name"
