#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What this build took from the machine comes with packages.txt, or is on every Debian: a machine
# that has a package for another reason would hide its lack from everybody but a newcomer.
# shellcheck source-path=SCRIPTDIR
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# The packages of the list, those of the smallest Debian, and all that these depend on. Of
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
            FNR == NR { sub(/[ \t]*#.*/, ""); wanted[$0]; next }
            $1 == "installed" {
                depends[$2] = $6
                if ($3 == "yes" || $4 == "required" || $2 == "apt")
                    wanted[$2]
                for (i = split($5, names, ","); i; i--)
                    providers[bare(names[i])] = providers[bare(names[i])] " " $2
            }
            END {
                for (package in wanted)
                    add(package)
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
            }' "$source_dir/packages.txt" -
}

# Reads paths, says which are in no package of the closure. dpkg may know a file of /usr/lib as /lib.
list_foreign() {
    xargs -r -d '\n' realpath -s | sort -u >"$scratch/paths"
    [[ -s $scratch/paths ]] || fail "found nothing to check in $binary_dir: is everything built?"
    list_closure >"$scratch/closure"
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

test_headers() {
    expect_empty "headers that packages.txt does not bring" \
        "$(ninja -C "$binary_dir" -t deps | sed -n 's|^ *\(/usr/.*\)|\1|p' | sort -u | list_foreign)"
}

test_shared_libraries() {
    expect_empty "shared libraries that packages.txt does not bring" \
        "$(list_programs | xargs -r -d '\n' ldd | sed -n 's/.*=> \(\/.*\) (.*/\1/p' | sort -u |
            xargs -r realpath | list_foreign)" # some are links of update-alternatives
}

# Where find_package and find_library found what they found, the programs that those CMake files
# insist on, and what the build lines name.
test_cmake_packages() {
    local build_file=$binary_dir/build.ninja cache=$binary_dir/CMakeCache.txt
    expect_empty "files that packages.txt does not bring" "$({
        sed -nE 's/^[^:]+_(DIR|LIBRARY):(PATH|FILEPATH)=(\/usr.*)/\3/p' "$cache"
        grep -oE '/usr/lib/[^ ]+-none\.cmake\b' "$build_file" | sort -u |
            xargs -r sed -nE 's|.* "\$\{_IMPORT_PREFIX\}/(bin/[^"]+)".*|/usr/\1|p'
        grep -oE '/usr/[^ ]+\.(so|a)\b' "$build_file"
        grep -oE -e '-isystem /usr[^ ]*' "$build_file" | cut -d ' ' -f 2
    } | sort -u | list_foreign)"
}

# Everything that a script or a test starts, the shell's own commands aside, or that is found at run
# time only: OpenCL devices and assets.
test_run_time() {
    local program
    for program in apt-get awk bash cat clang++ clang-format clinfo cmake cp ctest cut dirname dpkg-query env find \
        g++ grep head id ldd ln ls mkdir mktemp ninja nproc oclgrind povray readelf readlink realpath rm sed \
        shellcheck sleep sort tail tr wc xargs Xvfb; do
        readlink -f "$(command -v "$program")" || fail "there is no $program"
    done >"$scratch/programs"
    printf '%s\n' /etc/OpenCL/vendors/{pocl,rusticl}.icd /usr/share/{assimp/models,glmark2} |
        xargs ls -d >"$scratch/files"
    expect_empty "files that packages.txt does not bring" \
        "$(cat "$scratch/programs" "$scratch/files" | list_foreign)"
}

"test_$name"
