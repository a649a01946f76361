#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# ./stagelight on a machine of fakes: a copy of it in a scratch checkout with two stages, and a PATH
# that holds nothing but what it may start.
# shellcheck source-path=SCRIPTDIR
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

machine=$scratch/machine checkout=$scratch/checkout log=$scratch/log
unset CI

# fake PROGRAM SCRIPT: a program of the machine, which logs how it is called.
fake() {
    printf '#!/bin/bash\necho "%s $*" >>%q\n%s\n' "$1" "$log" "$2" >"$machine/$1"
    chmod +x "$machine/$1"
}

fake_installed() {
    fake dpkg-query "$(printf 'printf "installed:%%s " %s\nexit 1' "$*")"
}

make_machine() {
    mkdir -p "$machine" "$checkout/stages/01_first" "$checkout/stages/04_last"
    cp "$source_dir/stagelight" "$checkout"
    printf '# a list\none  # a reason\ntwo\nthree # another\n' >"$checkout/packages.txt"
    printf '# more\nfour # for one verb\n' >"$checkout/packages_peers.txt"
    local tool
    for tool in bash env dirname readlink sed cat mkdir nproc awk mktemp rm; do
        ln -s "$(command -v $tool)" "$machine/$tool"
    done
    fake_installed one two three
    fake id 'echo 0'
    fake apt-get ''
    # shellcheck disable=SC2016 # expanded by the fakes
    {
        fake ctest 'echo "${*@Q}"; echo "100% tests passed"'
        fake cmake '
            if [[ $1 == --build ]]; then
                mkdir -p "$2/stages" "$2/tools"
                for program in "$2/stages/$4" "$2/tools/golden"; do
                    printf "#!/bin/bash\necho \"\${0##*/} in \$PWD: \${*@Q}\"\nexit 7\n" >"$program"
                    /bin/chmod +x "$program"
                done
            else
                mkdir -p "$2/build/$4"
                : >"$2/build/$4/build.ninja"
            fi'
    }
}

# stagelight ARGUMENTS...: leaves exit code, standard output and error in code, output and errors.
stagelight() {
    code=0
    output=$(cd "$scratch" && PATH=$machine "$checkout/stagelight" "$@" 2>"$scratch/errors") || code=$?
    errors=$(<"$scratch/errors")
}

# The calls of a program so far.
calls() { grep "^$1 " "$log" || true; }

test_help_names_each_command() {
    local arguments command
    for arguments in "" help --help; do
        # shellcheck disable=SC2086 # no argument at all is one of the cases
        stagelight $arguments
        expect_equal "exit code of '$arguments'" 0 $code
        for command in run test mutate golden bench chart diff stability povray check fuzz doctor help; do
            expect_text "'$arguments' names $command" $'\n'"  $command" "$output"
        done
    done
}

test_unknown_command() {
    stagelight paint
    expect_equal "exit code" 2 $code
    expect_equal "message" "stagelight: no command 'paint'; ./stagelight help lists them" "$errors"
}

test_unknown_stage() {
    local stage
    for stage in 02 4 04_ 04_last/ '0*'; do
        stagelight run "$stage"
        expect_equal "exit code of $stage" 2 $code
        expect_equal "message" "stagelight: no stage '$stage'; there are: 01_first 04_last" "$errors"
    done
    [[ ! -e $log ]] || fail "set-up began before the stage was known:" "$(<"$log")"
}

test_run_builds_one_stage_and_passes_everything() {
    stagelight run 01 "a scene.toml" --size 32x20
    expect_equal "exit code is the program's" 7 $code
    expect_equal "program, folder, options" "01_first in $scratch: 'a scene.toml' '--size' '32x20'" "$output"
    expect_equal "cmake" "cmake -S $checkout --preset release --log-level=NOTICE
cmake --build $checkout/build/release --target 01_first" "$(calls cmake)"
    stagelight run 04_last
    expect_equal "by full name" "04_last in $scratch: " "$output"
    expect_equal "configured once, built twice" 3 "$(calls cmake | wc -l)"
}

test_run_takes_the_highest_stage() {
    stagelight run --depth 3
    expect_equal "program and options" "04_last in $scratch: '--depth' '3'" "$output"
    stagelight run
    expect_equal "program" "04_last in $scratch: " "$output"
}

test_presets_changed_configures_again() {
    stagelight run
    sleep 0.02
    : >"$checkout/CMakePresets.json"
    stagelight run
    expect_equal "configured and built twice" 4 "$(calls cmake | wc -l)"
}

test_symbolic_link_from_another_folder() {
    mkdir "$scratch/bin" "$scratch/elsewhere"
    ln -s ../checkout/stagelight "$scratch/bin/light"
    output=$(cd "$scratch/elsewhere" && PATH=$machine ../bin/light run 01 out.png 2>&1) || true
    expect_text "output" "01_first in $scratch/elsewhere: 'out.png'" "$output"
}

test_test_passes_options_and_ends_with_the_summary() {
    stagelight test -L stage04 -R "a b"
    expect_equal "exit code" 0 $code
    expect_equal "ctest's options, and its summary last" \
        "'--preset' 'release' '--parallel' '$(nproc)' '-L' 'stage04' '-R' 'a b'
100% tests passed" "$output"
    expect_equal "cmake builds" "cmake --build $checkout/build/release --target all" \
        "$(calls cmake | tail -n 1)"
}

# The device as a program says it, with a word on the way.
test_test_on_one_device() {
    # shellcheck disable=SC2016 # expanded by the fakes
    fake cmake '
        mkdir -p "$2/stages"
        printf "#!/bin/bash\n[[ \$2 == gpu ]] && echo A device && exit 0\necho no such device; exit 3\n" \
            >"$2/stages/$4"
        /bin/chmod +x "$2/stages/$4"'
    # shellcheck disable=SC2016 # expanded by the fake
    fake ctest 'echo "${STAGELIGHT_DEVICE-none}: ${*:4}"'
    STAGELIGHT_DEVICE=mine stagelight test
    expect_equal "without the option" "none: $(nproc)" "$output"
    stagelight test --device gpu -L stage04
    expect_equal "exit code" 0 $code
    expect_equal "the device, and ctest's options" "A device: $(nproc) -L stage04" "$output"
    expect_text "said" "tests run on A device alone" "$errors"
    : >"$log"
    stagelight test --device abacus
    expect_equal "exit code is the program's" 3 $code
    expect_equal "no tests" "" "$(calls ctest)"
    expect_equal "only what knows was built" "" "$(calls cmake | grep "target all" || true)"
    stagelight test --device
    expect_equal "exit code" 2 $code
    expect_text "message" "test --device: expected" "$errors"
}

# PoCL wants the folder of its cache to exist.
test_test_has_its_own_kernel_caches() {
    # shellcheck disable=SC2016 # expanded by the fake
    fake ctest 'echo "$POCL_CACHE_DIR $MESA_SHADER_CACHE_DIR"; [[ -d $POCL_CACHE_DIR ]]'
    stagelight test
    local build=$checkout/build/release
    expect_equal "folders" "$build/pocl_cache $build/mesa_cache" "$output"
    expect_equal "exit code is ctest's" 0 $code
}

test_golden_passes_everything() {
    stagelight golden update 04_last --reason "a new lamp"
    expect_equal "exit code is the program's" 7 $code
    expect_equal "output" "golden in $scratch: 'update' '04_last' '--reason' 'a new lamp'" "$output"
}

# The benchmark tells where it runs. There is no display but what a fake Xvfb offers.
make_bench() {
    # shellcheck disable=SC2016 # expanded by the fakes
    fake cmake '
        if [[ $1 == --build ]]; then
            mkdir -p "$2/tools"
            printf "#!/bin/bash\necho \"on \$DISPLAY, \${OPENCL_LAYERS##*/}: \$*\"\n" >"$2/tools/$4"
            /bin/chmod +x "$2/tools/$4"
        fi'
    fake Xvfb "echo \$\$ >$scratch/xvfb; echo 42; exec /bin/sleep 20"
    unset WAYLAND_DISPLAY OPENCL_LAYERS
}

test_bench_takes_the_display_that_there_is() {
    make_bench
    DISPLAY=:7 stagelight bench interop --fast
    expect_equal "exit code" 0 $code
    expect_equal "output" "on :7, stagelight_gl_sharing.so: --fast" "$output"
    expect_equal "calls of Xvfb" "" "$(calls Xvfb)"
}

test_bench_without_a_display_starts_one_and_ends_it() {
    make_bench
    DISPLAY='' stagelight bench interop
    expect_equal "exit code" 0 $code
    expect_equal "output" "on :42, stagelight_gl_sharing.so: " "$output"
    sleep 0.2
    ! kill -0 "$(<"$scratch/xvfb")" 2>/dev/null || fail "Xvfb is still there"
}

test_bench_without_a_word_is_of_the_stages() {
    make_bench
    local options
    for options in "" "--benchmark_filter=04 -v"; do
        # shellcheck disable=SC2086 # no option at all is one of the cases
        DISPLAY='' stagelight bench $options
        expect_equal "exit code of '$options'" 0 $code
        expect_equal "output" "on , : $options" "$output"
        expect_equal "cmake" "cmake --build $checkout/build/release --target bench_stages" \
            "$(calls cmake | tail -n 1)"
    done
}

test_bench_scaling() {
    make_bench
    DISPLAY='' stagelight bench scaling
    expect_equal "exit code" 0 $code
    expect_equal "cmake" "cmake --build $checkout/build/release --target bench_scaling" \
        "$(calls cmake | tail -n 1)"
}

# What only the peers need is installed, looked for and built for them alone.
test_bench_peers_has_packages_and_a_build_of_its_own() {
    make_bench
    DISPLAY='' stagelight bench peers --fast
    expect_equal "exit code" 0 $code
    expect_equal "output" "on , : --fast" "$output"
    expect_text "apt-get" "install --yes --no-install-recommends four" "$(calls apt-get)"
    expect_equal "cmake" "cmake -S $checkout --preset peers --log-level=NOTICE
cmake --build $checkout/build/peers --target bench_peers" "$(calls cmake)"
    : >"$log"
    DISPLAY=:7 stagelight bench interop
    expect_empty "apt-get for interop" "$(calls apt-get)"
    expect_text "cmake for interop" "--preset release" "$(calls cmake)"
}

test_bench_of_nothing_known() {
    stagelight bench speed
    expect_equal "exit code" 2 $code
    expect_equal "message" \
        "stagelight: bench 'speed': expected nothing, scaling, peers or interop" "$errors"
}

# One that finds something does not keep the others from their turn.
test_fuzz_runs_each_in_a_build_of_its_own() {
    mkdir -p "$checkout/tests/fuzz"
    # shellcheck disable=SC2016 # expanded by the fake
    printf 'echo "${*:2}"; [[ $3 != mesh ]]\n' >"$checkout/tests/fuzz/fuzz.sh"
    stagelight fuzz
    expect_equal "exit code" 1 $code
    expect_equal "output" "60 scene
60 mesh
60 texture" "$output"
    expect_text "message" "the findings are in $checkout/build/fuzz/findings" "$errors"
    expect_equal "cmake" "cmake -S $checkout --preset fuzz --log-level=NOTICE
cmake --build $checkout/build/fuzz --target fuzzers" "$(calls cmake)"
    stagelight fuzz texture --seconds 3600 scene
    expect_equal "exit code" 0 $code
    expect_equal "output" "3600 texture
3600 scene" "$output"
}

test_fuzz_of_nothing_known() {
    stagelight fuzz music
    expect_equal "exit code" 2 $code
    expect_equal "message" "stagelight: fuzz 'music': expected scene, mesh, texture or --seconds N" "$errors"
    stagelight fuzz --seconds soon
    expect_equal "exit code" 2 $code
    expect_equal "message" "stagelight: --seconds 'soon': expected a whole number" "$errors"
}

test_failed_build_shows_the_compiler() {
    # shellcheck disable=SC2016 # expanded by the fake
    fake cmake 'mkdir -p "$2/build/$4"; [[ $1 == -S ]] || { echo "main.cpp:3: error"; exit 5; }'
    stagelight run 01
    expect_equal "exit code" 1 $code
    expect_text "messages" "main.cpp:3: error" "$errors"
}

test_set_up_leaves_a_complete_machine_alone() {
    stagelight run
    expect_empty "apt-get was called" "$(calls apt-get)"
}

# A package that was removed leaves its configuration behind, and dpkg-query still knows it.
test_set_up_installs_what_is_missing() {
    fake dpkg-query 'echo "installed:two config-files:three "; exit 1'
    stagelight run
    expect_equal "apt-get" "apt-get update
apt-get install --yes --no-install-recommends one three" "$(calls apt-get)"
    expect_text "messages" "installing one three" "$errors"
    expect_text "output" "04_last" "$output"
}

test_set_up_uses_sudo() {
    fake_installed one three
    fake id 'echo 1000'
    # shellcheck disable=SC2016 # expanded by the fake
    fake sudo '"$@"'
    stagelight run
    expect_equal "sudo" "sudo apt-get update
sudo env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends two" \
        "$(calls sudo)"
}

test_set_up_without_sudo_names_the_command() {
    fake_installed
    fake id 'echo 1000'
    stagelight test
    expect_equal "exit code" 3 $code
    expect_text "messages" "as root, run: apt-get install --no-install-recommends one two three" \
        "$errors"
    expect_empty "apt-get or cmake was called" "$(calls apt-get)$(calls cmake)"
}

test_set_up_tells_why_apt_failed() {
    fake_installed one two
    fake apt-get 'echo "E: no such luck"; exit 100'
    stagelight golden
    expect_equal "exit code" 3 $code
    expect_text "messages" "E: no such luck" "$errors"
    expect_text "messages" "as root run: apt-get install --no-install-recommends three" "$errors"
}

test_set_up_goes_on_where_there_is_no_apt() {
    rm "$machine/apt-get" "$machine/dpkg-query"
    stagelight run
    expect_text "messages" "what is here of: one two three" "$errors"
    expect_text "output" "04_last" "$output"
}

test_doctor_on_a_bare_machine() {
    fake_installed two
    rm "$machine/cmake"
    stagelight doctor
    expect_equal "exit code" 3 $code
    local remedy
    for remedy in "apt-get install "{g++,cmake,ninja-build,clinfo,mesa-utils,xvfb} \
        "LACKING: one three"; do
        expect_text "doctor" "$remedy" "$output"
    done
}

# clinfo_of NAME PLATFORM: what clinfo --raw prints of one device.
clinfo_of() {
    printf 'echo "[X/*] CL_PLATFORM_NAME  %s"\n' "$2"
    printf 'echo "[X/0] %s"\n' "CL_DEVICE_NAME  $1" "CL_DEVICE_VERSION  OpenCL 3.0" \
        "CL_DRIVER_VERSION  9.8" "CL_DEVICE_IMAGE_SUPPORT  CL_TRUE" \
        "CL_DEVICE_EXTENSIONS  cl_khr_fp64 cl_khr_other"
}

test_doctor_on_a_complete_machine() {
    local program
    for program in g++ ninja cmake; do
        fake "$program" "echo $program 12.3"
    done
    fake clinfo "$(clinfo_of Processor PoCL)"
    sed -i 's/^\(assimp-testmodels\|glmark2-data\) .*/\1 \//' "$checkout/stagelight"
    stagelight doctor
    expect_equal "exit code after $output" 0 $code
    expect_text "doctor" "g++ 12.3" "$output"
    expect_text "doctor" "Processor (PoCL; OpenCL 3.0; driver 9.8)"$'\n' "$output"
    expect_text "doctor" "images yes, cl_khr_fp64 yes, cl_khr_fp16 no" "$output"
}

# rusticl shows its device only when told to, so by itself it is not enough.
test_doctor_needs_a_device_that_shows() {
    fake clinfo "$(clinfo_of llvmpipe rusticl)"
    unset RUSTICL_ENABLE # which test --device sets
    stagelight doctor
    expect_text "doctor" "LACKING: no device" "$output"
    expect_text "doctor" "with RUSTICL_ENABLE=llvmpipe" "$output"
    RUSTICL_ENABLE=llvmpipe stagelight doctor
    [[ $output != *"no device"* ]] || fail "expected llvmpipe to do, but:" "$output"
}

# It goes on where a part has failed, says which did, and fails in the end.
test_ci_run_asks_for_each_part() {
    mkdir "$checkout/.ci"
    cp "$source_dir/.ci/run" "$checkout/.ci"
    # shellcheck disable=SC2016 # expanded by the script
    printf '#!/bin/bash\necho "asked ${CI:-} $*"\necho "100%% tests passed"\n[[ $* != "${bad:-}" ]]\n' >"$checkout/stagelight"
    local all='asked true test asked true check asked true exercise prove asked true docs test '
    output=$("$checkout/.ci/run" </dev/null)
    expect_equal "the parts" "$all" "$(grep ^asked <<<"$output" | tr '\n' ' ')"
    expect_equal "the last line" "4 passed, 0 failed" "${output##*$'\n'}"
    code=0
    output=$(bad=check "$checkout/.ci/run" </dev/null) || code=$?
    expect_equal "exit code" 1 "$code"
    expect_equal "the parts" "$all" "$(grep ^asked <<<"$output" | tr '\n' ' ')"
    expect_text "what failed" "./stagelight check failed" "$output"
    expect_equal "the last line" "3 passed, 1 failed" "${output##*$'\n'}"
}

make_machine
"test_$name"
