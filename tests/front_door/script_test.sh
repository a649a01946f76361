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

# fake_known NAMES: what apt can install; without names, all that it is asked for.
fake_known() {
    # shellcheck disable=SC2016 # expanded by the fake
    local names='${*:2}'
    (($# == 0)) || names=$*
    # shellcheck disable=SC2016
    fake apt-cache "for name in $names; do"' printf "%s:\n  Candidate: 1\n" "$name"; done'
}

make_machine() {
    mkdir -p "$machine" "$checkout/stages/01_first" "$checkout/stages/04_last"
    cp "$source_dir/stagelight" "$checkout"
    mkdir "$checkout/packages"
    printf '# a list\none  # a reason\ntwo\nthree | drei | trois # another\n' >"$checkout/packages/draw.txt"
    printf 'needs: draw\nread\n' >"$checkout/packages/learn.txt"
    printf 'needs: learn\ntry\noptional: rare | scarce # not everywhere\n' >"$checkout/packages/test.txt"
    printf 'needs: test\nfour # for one verb\n' >"$checkout/packages/peers.txt"
    printf 'needs: test\n' | tee "$checkout/packages/check.txt" >"$checkout/packages/docs.txt"
    local tool
    for tool in bash env dirname readlink sed cat mkdir nproc awk mktemp rm flock touch tee sleep; do
        ln -s "$(command -v $tool)" "$machine/$tool"
    done
    fake_installed one two three read try rare
    fake_known
    fake id 'echo 0'
    fake apt-get ''
    fake dpkg ''
    fake df 'echo heading; echo 1000000 /'
    fake c++ ''
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
                printf "%s\n" "CMAKE_HOME_DIRECTORY:INTERNAL=$2" CMAKE_CXX_COMPILER:STRING=c++ \
                    "BUILD_TESTING:BOOL=${7#*=}" >"$2/build/$4/CMakeCache.txt"
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
        for command in run test mutate golden bench chart show diff stability povray readers check fuzz doctor \
            help; do
            expect_text "'$arguments' names $command" $'\n'"  $command" "$output"
        done
    done
}

test_version() {
    cp "$source_dir/CMakeLists.txt" "$checkout"
    stagelight --version
    expect_equal "exit code" 0 $code
    [[ $output =~ ^Stagelight\ [0-9]+\.[0-9]+\.[0-9]+$ ]] || fail "expected a version, but:" "$output"
}

test_unknown_command() {
    stagelight paint
    expect_equal "exit code" 2 $code
    expect_equal "message" "stagelight: no command 'paint'; ./stagelight help lists them" "$errors"
}

test_unknown_stage() {
    local stage
    for stage in 02 5 004 04_ 04_last/ '0*'; do
        stagelight run "$stage"
        expect_equal "exit code of $stage" 2 $code
        expect_equal "message" "stagelight: no stage '$stage'; there are: 01_first 04_last" "$errors"
    done
    [[ ! -e $log ]] || fail "set-up began before the stage was known:" "$(<"$log")"
}

test_old_stage_names() {
    local command now="the full tracer is stage 11 now"
    for command in run show "diff 04" step exercise "exercise prove" "golden update"; do
        # shellcheck disable=SC2086 # a command may be two words
        stagelight $command 10_full_tracer
        expect_equal "exit code of $command" 2 $code
        expect_equal "message of $command" "stagelight: 10_full_tracer: $now: 11_full_tracer" "$errors"
    done
    stagelight run 09_acceleration --depth 3
    expect_equal "exit code" 2 $code
    expect_equal "message" "stagelight: 09_acceleration: acceleration is two stages now: 09_tree and 10_packets" \
        "$errors"
    stagelight run 01 scenes/10_glass.toml
    expect_equal "exit code of a scene" 2 $code
    expect_equal "message" "stagelight: scenes/10_glass.toml: $now: scenes/11_glass.toml" "$errors"
    [[ ! -e $log ]] || fail "set-up began before the name was refused:" "$(<"$log")"
    : >"$scratch/10_full_tracer.toml"
    stagelight run 10_full_tracer.toml
    expect_equal "a file of the user's own" "04_last in $scratch: '10_full_tracer.toml'" "$output"
}

test_run_builds_one_stage_and_passes_everything() {
    stagelight run 01 "a scene.toml" --size 32x20
    expect_equal "exit code is the program's" 7 $code
    expect_equal "program, folder, options" "01_first in $scratch: 'a scene.toml' '--size' '32x20'" "$output"
    expect_equal "cmake" "cmake -S $checkout --preset release --log-level=NOTICE -D BUILD_TESTING=OFF --fresh
cmake --build $checkout/build/release --target 01_first" "$(calls cmake)"
    local stage
    for stage in 04_last 04 4; do
        stagelight run $stage --depth 3
        expect_equal "by the name $stage" "04_last in $scratch: '--depth' '3'" "$output"
    done
    expect_equal "configured once, built four times" 5 "$(calls cmake | wc -l)"
}

test_run_takes_the_highest_stage() {
    stagelight run --depth 3
    expect_equal "program and options" "04_last in $scratch: '--depth' '3'" "$output"
}

# Unless it is asked for anything: the stages without a tree take seconds a sample.
test_run_smooths_the_first_picture() {
    stagelight run 01
    expect_equal "a stage" "01_first in $scratch: " "$output"
    stagelight run
    expect_equal "the highest" "04_last in $scratch: '--samples' '16'" "$output"
}

test_run_draws_a_scene_in_the_place_of_a_stage() {
    stagelight run "my scene.toml"
    expect_equal "by its ending" "04_last in $scratch: 'my scene.toml'" "$output"
    : >"$scratch/scene"
    stagelight run scene --depth 3
    expect_equal "any file" "04_last in $scratch: 'scene' '--depth' '3'" "$output"
}

# It tells its age when the picture is there; what a terminal, or a caller, sends is for it.
test_run_starts_the_program_as_a_process_of_its_own() {
    # shellcheck disable=SC2016 # expanded by the fakes
    fake cmake '
        mkdir -p "$2/stages"
        printf "#!/bin/bash\necho \$\$ >%s/program\ntrap \"exit 9\" TERM INT\ncat\nwhile :; do sleep 0.02; done\n" \
            '"$scratch"' >"$2/stages/04_last"
        /bin/chmod +x "$2/stages/04_last"'
    local signal door
    for signal in TERM INT; do
        rm -f "$scratch/program"
        PATH=$machine env --default-signal=INT "$checkout/stagelight" run <<<"its input" >"$scratch/said" 2>/dev/null &
        door=$!
        for _ in {1..200}; do
            [[ ! -s $scratch/program || $(<"$scratch/said") != "its input" ]] || break
            sleep 0.02
        done
        expect_equal "its input" "its input" "$(<"$scratch/said")"
        [[ $(<"$scratch/program") != "$door" ]] || fail "the program is the script's process"
        kill -$signal $door
        code=0
        wait $door || code=$?
        expect_equal "exit code after $signal is the program's" 9 $code
        ! kill -0 "$(<"$scratch/program")" 2>/dev/null || fail "the program is still there after $signal"
    done
}

test_help_of_each_command_builds_and_installs_nothing() {
    local command
    fake_installed
    for command in run test mutate golden report bench chart show diff step exercise docs check stability fuzz povray \
        readers doctor; do
        stagelight $command --help
        expect_equal "exit code of $command --help" 0 $code
        expect_text "its own lines" "  $command" "$output"
        expect_empty "lines of others" "$(grep -E '^  [a-z]' <<<"$output" | grep -v "^  $command" || true)"
    done
    stagelight run 01 --size 1x1 -h
    expect_text "help after other options" "Once 01_first is built" "$output"
    [[ ! -e $log ]] || fail "not only help:" "$(<"$log")"
    [[ ! -e $checkout/build ]] || fail "a build folder was made"
    fake_installed one two three
    stagelight run 01
    : >"$log"
    stagelight run 01 --help
    expect_text "what the program says" "01_first in $scratch: '--help'" "$output"
    expect_empty "what was called" "$(<"$log")"
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
    expect_equal "cmake" "cmake -S $checkout --preset peers --log-level=NOTICE -D BUILD_TESTING=ON --fresh
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
    expect_equal "cmake" "cmake -S $checkout --preset fuzz --log-level=NOTICE -D BUILD_TESTING=ON --fresh
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
    expect_equal "apt-get" "apt-get -o DPkg::Lock::Timeout=600 update
apt-get -o DPkg::Lock::Timeout=600 install --yes --no-install-recommends one three" "$(calls apt-get)"
    expect_text "messages" "installing one three" "$errors"
    expect_text "output" "04_last" "$output"
}

# installs VERB: what set-up has apt-get install for it on a bare machine.
installs() {
    fake_installed
    : >"$log"
    stagelight "$@"
    calls apt-get | sed -n 's/.*--no-install-recommends //p'
}

test_set_up_for_each_purpose() {
    mkdir "$checkout/tests" "$checkout/tests/fuzz"
    fake npm ''
    local command
    expect_equal "run" "one two three" "$(installs run)"
    for command in step exercise show diff report; do
        expect_equal "$command" "one two three read" "$(installs $command)"
    done
    for command in test golden bench chart mutate stability povray readers fuzz; do
        expect_equal "$command" "one two three read try rare" "$(installs $command)"
    done
    expect_equal "bench peers" "one two three read try four rare" "$(installs bench peers)"
}

test_set_up_takes_an_alternative() {
    fake_installed one two trois
    stagelight run
    expect_empty "apt-get, with one installed" "$(calls apt-get)"
    fake_known one two drei trois
    expect_equal "the first that is known" "one two drei" "$(installs run)"
}

test_set_up_passes_over_what_is_optional() {
    fake_known one two three read try
    expect_equal "installs" "one two three read try" "$(installs test)"
    stagelight test
    expect_equal "exit code" 0 $code
    expect_text "message" "stagelight: this system has no rare or scarce: what needs it is left out" "$errors"
    fake_installed one two three read try
    : >"$log"
    stagelight test
    expect_empty "apt-get, with nothing else missing" "$(calls apt-get)"
    fake_known
    fake apt-get 'exit 100'
    stagelight test
    expect_equal "exit code, where apt fails" 0 $code
    expect_text "message" "rare could not be installed: what needs it is left out" "$errors"
}

test_set_up_on_an_unknown_release() {
    fake_installed
    fake_known one two
    stagelight run
    expect_equal "exit code" 3 $code
    local last=${errors##*$'\n'}
    # shellcheck source=/dev/null
    expect_text "the last line names the system" "$(. /etc/os-release && echo "$PRETTY_NAME")" "$last"
    expect_text "the last line names the package" \
        "has no package three or drei or trois, which ./stagelight needs; Debian 12, 13 and testing" "$last"
    expect_equal "apt-get only updates" "apt-get -o DPkg::Lock::Timeout=600 update" "$(calls apt-get)"
}

# apt-get update ends with 0 without a network; then apt knows nothing, or can't fetch what it knows.
test_set_up_without_a_network() {
    fake_installed
    fake_known no_package
    fake apt-get 'echo "W: Failed to fetch http://there  Temporary failure resolving"'
    stagelight run
    expect_equal "exit code" 3 $code
    expect_equal "the last line" "stagelight: apt reaches no server of packages; connect this machine to the network and try again" \
        "${errors##*$'\n'}"
    fake_known
    fake apt-get 'echo "E: Failed to fetch http://there"; [[ $* == *update ]] || exit 100'
    stagelight run
    expect_equal "exit code" 3 $code
    expect_text "apt's words" "E: Failed to fetch http://there" "$errors"
    expect_equal "the last line" "stagelight: apt could not fetch packages, see above; connect this machine to the network and try again" \
        "${errors##*$'\n'}"
}

test_set_up_after_an_interrupted_one() {
    fake_installed one two
    fake dpkg ": >$scratch/mended"
    # shellcheck disable=SC2016 # expanded by the fake
    fake apt-get '[[ $* != *" install "* || -e '"$scratch"'/mended ]] && exit
        echo "E: dpkg was interrupted, you must manually run '"'dpkg --configure -a'"' to correct the problem."
        exit 100'
    stagelight run
    expect_text "output after $errors" "04_last" "$output"
    expect_equal "dpkg" "dpkg --configure -a" "$(calls dpkg)"
}

test_full_disk() {
    fake_installed one two
    fake apt-get 'echo "E: You don'"'"'t have enough free space in /var/cache/apt/archives/."; exit 100'
    stagelight run
    expect_equal "exit code" 3 $code
    expect_equal "the last line" "stagelight: a disk is full, see above; free some space and try again" \
        "${errors##*$'\n'}"
    fake_installed one two three
    fake df 'echo heading; echo 1000000 /; echo 12 /mnt'
    fake cmake 'exit 1'
    stagelight run
    expect_equal "exit code" 3 $code
    expect_equal "the last line" "stagelight: the disk at /mnt is full; free some space and try again" \
        "${errors##*$'\n'}"
}

test_a_folder_that_cannot_be_written() {
    : >"$checkout/build"
    stagelight run
    expect_equal "exit code" 3 $code
    expect_text "which folder" "$checkout/build" "$errors"
    expect_text "message" "./stagelight builds there, so free some space or make the folder yours" "$errors"
    expect_equal "lines" 1 "$(wc -l <<<"$errors")"
}

test_set_up_uses_sudo() {
    fake_installed one three
    fake id 'echo 1000'
    # shellcheck disable=SC2016 # expanded by the fake
    fake sudo '"$@"'
    stagelight run
    local apt="sudo env LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600"
    expect_equal "sudo" "$apt update
$apt install --yes --no-install-recommends two" "$(calls sudo)"
}

test_set_up_without_sudo_names_the_command() {
    fake_installed
    fake_known one trois
    fake id 'echo 1000'
    stagelight run
    expect_equal "exit code" 3 $code
    expect_equal "messages" "stagelight: packages are missing; as root, run: apt-get install --no-install-recommends one trois two" \
        "$errors"
    expect_empty "apt-get or cmake was called" "$(calls apt-get)$(calls cmake)"
}

test_set_up_tells_why_apt_failed() {
    fake_installed one two read try rare
    fake apt-get 'echo "E: no such luck"; exit 100'
    stagelight golden
    expect_equal "exit code" 3 $code
    expect_text "messages" "E: no such luck" "$errors"
    expect_text "messages" "as root run: apt-get install --no-install-recommends three" "$errors"
}

test_set_up_goes_on_where_there_is_no_apt() {
    rm "$machine/apt-get" "$machine/dpkg-query"
    stagelight run
    expect_text "messages" "what is here of: one, two, three or drei or trois" "$errors"
    expect_text "output" "04_last" "$output"
}

test_tests_are_configured_where_they_are_run() {
    stagelight run
    stagelight test
    expect_text "cmake" "-D BUILD_TESTING=ON" "$(calls cmake | sed -n 3p)"
    stagelight run
    stagelight test
    expect_equal "configured twice, built four times" 6 "$(calls cmake | wc -l)"
}

# The copy's build folder knows the original's sources, all of its presets'.
test_a_copied_checkout_builds_itself() {
    stagelight test
    cp -r "$checkout/build/release" "$checkout/build/fuzz"
    cp -r "$checkout" "$scratch/copy"
    : >"$log"
    checkout=$scratch/copy
    stagelight run 01 --depth 3
    expect_text "message" "stagelight: configuring build/release anew: it was made in $scratch/checkout" "$errors"
    expect_equal "cmake" "cmake -S $scratch/copy --preset release --log-level=NOTICE -D BUILD_TESTING=OFF --fresh
cmake --build $scratch/copy/build/release --target 01_first" "$(calls cmake)"
    [[ ! -e $scratch/copy/build/fuzz/CMakeCache.txt ]] || fail "build/fuzz still belongs to the original"
    expect_equal "program" "01_first in $scratch: '--depth' '3'" "$output"
}

test_a_moved_checkout_builds_itself() {
    stagelight run
    mv "$checkout" "$scratch/moved"
    : >"$log"
    checkout=$scratch/moved
    stagelight run
    expect_text "message" "it was made in $scratch/checkout" "$errors"
    expect_text "cmake" "cmake -S $scratch/moved" "$(calls cmake)"
    stagelight run
    expect_equal "messages the second time" "stagelight: building 04_last" "$errors"
}

test_a_compiler_that_is_gone() {
    stagelight run
    rm "$machine/c++"
    : >"$log"
    stagelight run
    expect_text "message" "configuring build/release anew: its compiler c++ is gone" "$errors"
    expect_text "cmake" "--fresh" "$(calls cmake)"
}

test_an_interrupted_configuration_begins_anew() {
    stagelight run
    rm "$checkout/build/release/build.ninja"
    : >"$log"
    stagelight run
    expect_text "cmake" "--fresh" "$(calls cmake)"
}

# Not while the program runs, which may be a window's.
test_two_at_once_build_in_turn() {
    stagelight run
    # shellcheck disable=SC2016 # expanded by the fake
    fake cmake 'echo begin >>'"$scratch"'/turns; sleep 0.3; echo end >>'"$scratch/turns"
    printf '#!/bin/bash\nexec sleep 5\n' >"$checkout/build/release/stages/04_last"
    PATH=$machine "$checkout/stagelight" run 04 2>"$scratch/first" &
    local first=$!
    sleep 0.1
    stagelight run 01 --depth 3
    expect_equal "turns" "begin end begin end" "$(tr '\n' ' ' <"$scratch/turns" | sed 's/ $//')"
    expect_text "messages" "stagelight: another ./stagelight is setting up or building in this checkout; waiting for it
stagelight: building 01_first" "$errors"
    kill -0 $first || fail "the first has ended before the second"
    kill $first
}

# What a step leaves running, as a server that a package starts, does not keep others waiting.
test_a_lock_is_nobody_elses() {
    stagelight run
    # shellcheck disable=SC2016 # expanded by the fake
    fake cmake 'sleep 5 >/dev/null 2>&1 & echo $! >'"$scratch/server"
    stagelight run
    flock --nonblock "$checkout/build/lock" true || fail "the lock is still held"
    kill "$(<"$scratch/server")"
}

test_test_counts_what_is_left_out() {
    # shellcheck disable=SC2016 # expanded by the fake
    fake ctest 'mkdir -p '"$checkout"'/build/release/Testing/Temporary
        printf "%s\n" "left out: this system has no rare" "x.cpp:3: Skipped" "no doubles" "" \
            "left out: this system has no rare" >'"$checkout"'/build/release/Testing/Temporary/LastTest.log
        echo "100% tests passed"'
    stagelight test
    expect_equal "exit code" 0 $code
    local last=${errors##*$'\n'} reason
    for reason in "2 (this system has no rare)" "1 (no doubles)"; do
        expect_text "the last line" "$reason" "$last"
    done
    fake ctest 'exit 8'
    stagelight test
    expect_equal "exit code" 1 $code
    expect_equal "the last line, of nothing left out" "stagelight: building all" "${errors##*$'\n'}"
}

test_doctor_on_a_bare_machine() {
    fake_installed two
    rm "$machine/cmake"
    stagelight doctor
    expect_equal "exit code" 3 $code
    local remedy
    for remedy in "apt-get install "{g++,cmake,ninja-build,clinfo,mesa-utils,xvfb} \
        "LACKING: draw: one three"; do
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

test_systems_wants_a_release_and_root() {
    local release
    for release in "" run buster "13 13.1"; do
        code=0
        # shellcheck disable=SC2086 # no argument at all is one of the cases
        output=$(bash "$source_dir/tests/systems/try.sh" $release 2>&1) || code=$?
        expect_equal "exit code of '$release'" 2 $code
        expect_text "message" "bookworm (12), trixie (13) or forky (testing)" "$output"
    done
    code=0
    fake id 'echo 1000'
    output=$(PATH=$machine:$PATH bash "$source_dir/tests/systems/try.sh" 13 2>&1) || code=$?
    expect_equal "exit code" 3 $code
    expect_equal "message" "try.sh: only root may mount and chroot; try sudo" "$output"
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
