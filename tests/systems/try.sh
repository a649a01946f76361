#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# try.sh RELEASE [run|test] [--out FOLDER]: the two commands of the README on a bare Debian, as root.
#
# RELEASE is bookworm or 12, trixie or 13, forky or testing. The script puts a minimal system of that
# release into a temporary folder, with this checkout's files as they are, except what git ignores.
# There it runs ./stagelight run and then ./stagelight test, or only the one you name. It prints the
# last lines of each, the seconds, and the packages that were installed; --out copies the logs and the
# pictures into FOLDER. Everything else is removed at the end, also after Ctrl-C.
#
# It needs debootstrap, git, 8 GB in TMPDIR, and a mirror of Debian: the one in this machine's apt
# sources, else deb.debian.org.
#
# Exit codes: 0 done, 1 a command failed, 2 a mistake in what you gave, 3 the machine.
set -euo pipefail

fail() {
    local code=$1
    shift
    echo "try.sh: $*" >&2
    exit "$code"
}

release='' commands=() out='' arguments=("$@")
while (($#)); do
    case $1 in
        run | test) commands+=("$1") ;;
        --out)
            out=${2:-}
            [[ $out ]] || fail 2 "--out: expected a folder"
            shift
            ;;
        12 | bookworm) release=bookworm ;;
        13 | trixie) release=trixie ;;
        testing | forky) release=forky ;;
        *) fail 2 "'$1': expected bookworm (12), trixie (13) or forky (testing), run, test or --out FOLDER" ;;
    esac
    shift
done
[[ $release ]] || fail 2 "expected a release: bookworm (12), trixie (13) or forky (testing)"
((${#commands[@]})) || commands=(run test)
[[ $(id -u) == 0 ]] || fail 3 "only root may mount and chroot; try sudo"
for program in debootstrap git; do
    command -v $program >/dev/null || fail 3 "apt-get install $program"
done
# In a namespace of its own, what is mounted is nobody else's, and ends with it.
[[ ${STAGELIGHT_TRY:-} ]] || STAGELIGHT_TRY=apart exec unshare --mount "$0" "${arguments[@]}"

checkout=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
system=$(mktemp -d -t "stagelight_$release.XXXXXX")
chmod 755 "$system" # tests leave root, and must still find the way to their files
# A folder that is still mounted would be emptied with the rest.
clean_up() {
    local folder
    for folder in dev/shm dev/pts dev sys proc; do
        ! mountpoint --quiet "$system/$folder" || umount --lazy "$system/$folder"
    done
    rm -rf --one-file-system "$system"
}
trap clean_up EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

# mount_at FOLDER ARGUMENTS...
mount_at() {
    mkdir -p "$system/$1"
    mount "${@:2}" "$system/$1" || fail 3 "could not mount /$1"
}

inside() {
    chroot "$system" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb \
        LC_ALL=C.UTF-8 XDG_RUNTIME_DIR=/run/user/0 "$@"
}

# The number of installed packages, and their megabytes.
count_packages() {
    # shellcheck disable=SC2016 # the fields are dpkg-query's
    inside dpkg-query -W -f '${db:Status-Status} ${Installed-Size}\n' |
        awk '$1 == "installed" { count++; size += $2 } END { print count, int(size / 1024) }'
}

mirror=$(sed -nE 's/^URIs: *([^ ]*debian\/?)$/\1/p; s/^deb (\[[^]]*\] )?([^ ]*debian\/?) .*/\2/p' \
    /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null | head -n 1) || true
mirror=${mirror:-http://deb.debian.org/debian}
script=/usr/share/debootstrap/scripts/$release
[[ -e $script ]] || script=/usr/share/debootstrap/scripts/sid # an older debootstrap's name for the newest
echo "try.sh: a bare $release from $mirror" >&2
debootstrap --variant=minbase --include=ca-certificates "$release" "$system" "$mirror" "$script" \
    >"$system/debootstrap.log" 2>&1 || {
    tail -n 5 "$system/debootstrap.log" >&2
    fail 3 "debootstrap failed, see above"
}
# A mirror may lag behind what a release says of its own age.
echo 'Acquire::Check-Valid-Until "false";' >"$system/etc/apt/apt.conf.d/90stagelight"
mount_at proc -t proc proc
mount_at sys -t sysfs sysfs -o ro
mount_at dev --bind /dev
mount_at dev/pts -t devpts devpts -o newinstance,ptmxmode=0666
mount_at dev/shm -t tmpfs tmpfs
mkdir -p "$system/src"
install -d -m 700 "$system/run/user/0"
git -C "$checkout" -c safe.directory="$checkout" ls-files -z --cached --others --exclude-standard |
    tar -C "$checkout" --null --files-from=- --ignore-failed-read -cf - 2>/dev/null |
    tar -C "$system/src" --no-same-owner -xf -

failed=0
for command in "${commands[@]}"; do
    read -r packages megabytes < <(count_packages)
    log=$system/$command.log
    begin=$SECONDS code=0
    inside bash -c "cd /src && ./stagelight $command" </dev/null >"$log" 2>&1 || code=$?
    seconds=$((SECONDS - begin))
    read -r packages_after megabytes_after < <(count_packages)
    tail -n 12 "$log"
    echo "$release: ./stagelight $command: exit code $code, $seconds s," \
        "$((packages_after - packages)) packages, $((megabytes_after - megabytes)) MB installed"
    ((code == 0)) || failed=1
    if [[ $out ]]; then
        mkdir -p "$out"
        cp "$log" "$out/$release.$command.log"
        [[ ! -d $system/src/out ]] || cp -r "$system/src/out" "$out/$release.out"
    fi
done
((!failed))
