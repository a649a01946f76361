#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# display.sh [COMMAND...]: shows the display that DISPLAY names in a browser, on port 6080, then runs the
# command on it. What it starts goes on when it ends.
set -euo pipefail

start() { setsid "$@" </dev/null >/dev/null 2>&1 & }

is_up() { (exec 3<>/dev/tcp/localhost/5901) 2>/dev/null; }

if ! is_up; then
    # A container that is started again has the lock of the display it had before.
    start Xvnc "$DISPLAY" -rfbport 5901 -localhost -SecurityTypes None -nolock -geometry 1280x800
    start websockify --web /usr/share/novnc 6080 localhost:5901
    for _ in {1..100}; do
        ! is_up || break
        sleep 0.1
    done
fi
is_up || {
    echo "display.sh: Xvnc did not start on $DISPLAY; --entrypoint bash does without a display" >&2
    exit 3
}
echo "the display: http://localhost:6080/vnc.html?autoconnect=true&resize=scale" >&2
exec "${@:-true}"
