# Sourced by prepare.sh: one line that moves while something long goes on, and plain lines where nobody's terminal shows it.
# shellcheck shell=bash

say() { printf '%s\n' "$*" >&2; }

# as_time SECONDS: 75 is "1:15".
as_time() { printf '%d:%02d' $(($1 / 60)) $(($1 % 60)); }

# follow WHAT READER [ARG …]: reads a command's output from standard input. For each line it calls READER, which sets
# `finished` and `total` (shares of the work, whole numbers) and `detail` (text) if the line tells something new.
# On a terminal the line is drawn anew each second; elsewhere a line comes with each tenth of the work, or every 30 s.
follow() {
    local what=$1 reader=$2 line begin=$SECONDS finished=0 total=0 detail='' drawn=-1 said_tenth=0 said_at=$SECONDS status
    shift 2
    while :; do
        status=0
        IFS= read -r -t 1 line || status=$?
        if [ $status -eq 0 ]; then
            "$reader" "$line" "$@"
        elif [ $status -le 128 ]; then
            break # the end; above 128 nothing has come for a second
        fi
        if [ -t 2 ]; then
            [ "$SECONDS" -eq $drawn ] && continue
            drawn=$SECONDS
            printf '\r\033[K%s' "$(progress_text)" >&2
        elif [ "$total" -gt 0 ] && { [ $((10 * finished / total)) -gt $said_tenth ] || [ $((SECONDS - said_at)) -ge 30 ]; }; then
            said_tenth=$((10 * finished / total))
            said_at=$SECONDS
            say "$(progress_text)"
        fi
    done
    [ ! -t 2 ] || printf '\r\033[K' >&2
}

# One line from the variables of `follow`. The time left is estimated once enough is done.
progress_text() {
    local elapsed=$((SECONDS - begin)) text="$what"
    [ -z "$detail" ] || text+=": $detail"
    if [ "$total" -gt 0 ]; then
        text+=", $((100 * finished / total)) %"
        text+=", $(as_time $elapsed) so far"
        if [ "$finished" -lt "$total" ] && [ $((20 * finished)) -ge "$total" ] && [ $elapsed -ge 3 ]; then
            text+=", about $(as_time $((elapsed * (total - finished) / finished))) left"
        fi
    else
        text+=", $(as_time $elapsed) so far"
    fi
    printf '%s' "$text"
}

# What APT::Status-Fd says: "dlstatus:3:12.5:Retrieving file …", then "pmstatus:libpng-dev:40.0:Unpacking …".
read_apt_status() {
    local kind rest percent
    IFS=: read -r kind rest percent _ <<<"$1"
    case $kind in dlstatus) detail=downloading ;; pmstatus) detail=unpacking ;; *) return 0 ;; esac
    percent=${percent%%.*}
    [[ $percent =~ ^[0-9]+$ ]] || return 0
    # Unpacking takes about twice as long as downloading.
    total=300
    if [ "$kind" = dlstatus ]; then finished=$percent; else finished=$((100 + 2 * percent)); fi
}

# step_weight LINE: sets `weight`, about how many seconds of one core a build step takes.
step_weight() {
    case $1 in
        *cmake_pch.hxx*) weight=16 ;;
        *usar_precompiled_*) weight=1 ;;
        *Unity/unity_*) weight=8 ;;
        *mocs_compilation*) weight=1 ;;
        *'Building CXX object'*) weight=4 ;;
        *Generating*world*) weight=2 ;;
        *usar-fuzz*) weight=100 ;; # a build within the build
        *) weight=1 ;;
    esac
}

# What ninja says: "[12/180] Building …". The argument is the weight of all steps.
read_ninja() {
    local weight
    [[ $1 =~ ^\[([0-9]+)/([0-9]+)\]\  ]] || return 0
    total=$2
    detail="step ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}"
    step_weight "$1"
    finished=$((finished + weight))
    [ "$finished" -lt "$total" ] || finished=$total
}
