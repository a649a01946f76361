#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What this build took from the machine comes with the lists of packages/, or is on every Debian: a
# machine that has a package for another reason would hide its lack from everybody but a newcomer.
# What the stages took comes with the lists that ./stagelight run installs.
# shellcheck source-path=SCRIPTDIR
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# list_packages PURPOSE: what its list and those that it needs name, alternatives in one line.
list_packages() {
    local other
    sed 's/[[:space:]]*#.*//; s/^optional://; /^needs:/d; /^$/d; s/|/ /g' "$source_dir/packages/$1.txt"
    while read -r other; do
        list_packages "$other"
    done < <(sed -n 's/^needs://p' "$source_dir/packages/$1.txt")
}

# list_closure PURPOSE: its packages, those of the smallest Debian, and all that these depend on. Of
# alternatives a bare machine gets the first; if that is none of dpkg's, any that is here may do.
list_closure() {
    # shellcheck disable=SC2016 # the fields are dpkg-query's
    dpkg-query -W -f '${db:Status-Status}\t${Package}\t${Essential}\t${Priority}\t${Provides}\t${Pre-Depends}, ${Depends}\n' |
        awk -F '\t' '
            function add(package) {
                if (package in depends && !(package in closure)) {
                    closure[package]
                    queue[++queued] = package
                }
            }
            function bare(name) {
                gsub(/\([^)]*\)|:[a-z0-9]+| /, "", name)
                return name
            }
            FNR == NR { wanted[$0]; next }
            $1 == "installed" {
                depends[$2] = $6
                if ($3 == "yes" || $4 == "required" || $2 == "apt")
                    wanted[$2]
                for (i = split($5, names, ","); i; i--)
                    providers[bare(names[i])] = providers[bare(names[i])] " " $2
            }
            END {
                for (entry in wanted) {
                    count = split(entry, choices, " ")
                    for (k = 1; k < count && !(choices[k] in depends);)
                        k++
                    add(choices[k])
                }
                for (next_one = 1; next_one <= queued; next_one++) {
                    for (i = split(depends[queue[next_one]], groups, ","); i; i--) {
                        count = split(groups[i], choices, "|")
                        for (k = 1; k <= count; k++) {
                            add(bare(choices[k]))
                            if (k == 1 && bare(choices[k]) in depends)
                                break
                            for (m = split(providers[bare(choices[k])], names, " "); m; m--)
                                add(names[m])
                        }
                    }
                }
                for (package in closure)
                    print package
            }' <(list_packages "$1") -
}

# list_foreign PURPOSE: reads paths, says which are in no package of the closure. dpkg may know a file of /usr/lib as /lib.
list_foreign() {
    xargs -r -d '\n' realpath -s | sort -u >"$scratch/paths"
    [[ -s $scratch/paths ]] || fail "found nothing to check in $binary_dir: is everything built?"
    list_closure "$1" >"$scratch/closure"
    { cat "$scratch/paths"; sed -n 's|^/usr/|/|p; s|^/lib|/usr/lib|p' "$scratch/paths"; } |
        xargs -d '\n' dpkg-query -S 2>/dev/null >"$scratch/owners" || true
    awk '
        FILENAME ~ /closure$/ { closure[$0]; next }
        FILENAME ~ /owners$/ {
            path = $0
            sub(/^.*: /, "", path)
            sub(/^\/usr\//, "/", path)
            sub(/: .*/, "")
            for (i = split($0, owners, ", "); i; i--) {
                sub(/:.*/, "", owners[i])
                if (!index(owned_by[path] " ", " " owners[i] " "))
                    owned_by[path] = owned_by[path] " " owners[i]
                if (owners[i] in closure)
                    covered[path]
            }
            next
        }
        {
            path = $0
            sub(/^\/usr\//, "/", path)
            if (!(path in covered))
                print $0 " is of" (path in owned_by ? owned_by[path] : " no package")
        }' "$scratch/closure" "$scratch/owners" "$scratch/paths"
}

list_programs() {
    find "$binary_dir" -path '*/CMakeFiles' -prune -o -type f -executable -print | while read -r file; do
        ! readelf -h "$file" >/dev/null 2>&1 || echo "$file"
    done
}

# What the build of all stages starts from, and passes through.
list_stage_inputs() {
    (cd "$source_dir/stages" && printf '%s\n' [0-9][0-9]_*) | xargs ninja -C "$binary_dir" -t inputs
}

# list_headers [OBJECT...]: what was included, by default by all.
list_headers() { ninja -C "$binary_dir" -t deps "$@" | sed -n 's|^ *\(/usr/.*\)|\1|p' | sort -u; }

# list_libraries: what the programs that it reads load; some are links of update-alternatives.
list_libraries() {
    xargs -r -d '\n' ldd | sed -n 's/.*=> \(\/.*\) (.*/\1/p' | sort -u | xargs -r realpath
}

# Where find_package and find_library found what they found.
list_found() { sed -nE 's/^[^:]+_(DIR|LIBRARY):(PATH|FILEPATH)=(\/usr.*)/\3/p' "$1/CMakeCache.txt"; }

test_headers() {
    expect_empty "headers that packages/test.txt does not bring" "$(list_headers | list_foreign test)"
}

test_stage_headers() {
    local objects
    mapfile -t objects < <(list_stage_inputs | grep '\.o$')
    expect_empty "headers that packages/draw.txt does not bring" \
        "$(list_headers "${objects[@]}" | list_foreign draw)"
}

test_shared_libraries() {
    expect_empty "shared libraries that packages/test.txt does not bring" \
        "$(list_programs | list_libraries | list_foreign test)"
}

test_stage_shared_libraries() {
    expect_empty "shared libraries that packages/draw.txt does not bring" \
        "$({ find "$binary_dir"/stages -maxdepth 1 -type f -executable | list_libraries
            list_stage_inputs | grep -E '^/usr/.*\.(so|a)$'; } | list_foreign draw)"
}

# The programs that CMake files insist on, and what the build lines name, too.
test_cmake_packages() {
    local build_file=$binary_dir/build.ninja
    expect_empty "files that packages/test.txt does not bring" "$({
        list_found "$binary_dir"
        grep -oE '/usr/lib/[^ ]+-none\.cmake\b' "$build_file" | sort -u |
            xargs -r sed -nE 's|.* "\$\{_IMPORT_PREFIX\}/(bin/[^"]+)".*|/usr/\1|p'
        grep -oE '/usr/[^ ]+\.(so|a)\b' "$build_file"
        grep -oE -e '-isystem /usr[^ ]*' "$build_file" | cut -d ' ' -f 2
    } | sort -u | list_foreign test)"
}

# As ./stagelight run configures.
test_stage_cmake_packages() {
    cmake -S "$source_dir" -B "$scratch/build" -G Ninja -D BUILD_TESTING=OFF >/dev/null
    expect_empty "files that packages/draw.txt does not bring" "$(list_found "$scratch/build" | list_foreign draw)"
}

# list_started PROGRAM...: where they are; what is optional may not be.
list_started() {
    local program
    for program in "$@"; do
        readlink -f "$(command -v "$program")" || fail "there is no $program"
    done
}

# Everything that a script or a test starts, the shell's own commands aside, or that is found at run
# time only: OpenCL devices and assets.
test_run_time() {
    local optional
    mapfile -t optional < <(compgen -c | grep -x oclgrind | sort -u)
    {
        list_started apt-cache apt-get awk bash cat clang++ clang-format clinfo cmake cp ctest cut df dirname dpkg \
            dpkg-query env find flock g++ grep head id ldd ln ls mkdir mktemp ninja nproc povray readelf readlink \
            realpath rm sed shellcheck sleep sort tail tee touch tr wc xargs Xvfb "${optional[@]}"
        ls -d /etc/OpenCL/vendors/{pocl,rusticl}.icd /usr/share/{assimp/models,glmark2}
    } >"$scratch/started"
    expect_empty "files that packages/test.txt does not bring" "$(list_foreign test <"$scratch/started")"
}

# What ./stagelight run starts itself.
test_stage_run_time() {
    {
        list_started apt-cache apt-get awk bash cat cmake df dirname dpkg dpkg-query env flock g++ id mkdir ninja \
            readlink rm sed tee touch
        ls -d /etc/OpenCL/vendors/pocl.icd /usr/share/{assimp/models,glmark2}
    } >"$scratch/started"
    expect_empty "files that packages/draw.txt does not bring" "$(list_foreign draw <"$scratch/started")"
}

"test_$name"
