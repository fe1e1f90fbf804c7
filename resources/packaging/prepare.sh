# Sourced by app/run, tests/run and make-deb: checks whether this machine is suitable, installs what is missing on Debian 12 and builds.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$root/resources/packaging/progress.sh"

build_packages=(g++ cmake ninja-build pkg-config qt6-base-dev libqcustomplot-dev libbullet-dev libsdformat-dev
                libpng-dev libjpeg62-turbo-dev zlib1g-dev libzstd-dev libexpected-dev libeigen3-dev libsdl2-dev
                cmark-gfm fonts-dejavu-core)
test_packages=(libbenchmark-dev gdal-bin pngcheck clang libclang-rt-14-dev xvfb openbox xdotool at-spi2-core dbus
               doxygen mandoc desktop-file-utils appstream shared-mime-info librsvg2-bin)
# For resources/packaging/make-deb, besides the first list.
deb_packages=(build-essential debhelper dpkg-dev lintian doxygen librsvg2-bin)

# What one compiler process needs at most, in MB, and what it takes where there is plenty: it collects less garbage then,
# which saves a sixth of the time.
compiler_memory_mb=1300
generous_memory_mb=2200

# die SENTENCE …: ends the script with a message that says what to do.
die() {
    say "$*"
    exit 2
}

free_memory_mb() { awk '/^MemAvailable:/ { print int($2 / 1024) }' /proc/meminfo; }

# free_disk_mb FOLDER, which need not exist yet.
free_disk_mb() {
    local folder=$1
    while [ ! -d "$folder" ]; do folder=$(dirname "$folder"); done
    df -Pk "$folder" | awk 'NR == 2 { print int($4 / 1024) }'
}

# check_machine PRESET DISK-MB: before anything is started. USAR_ANY_SYSTEM=1 skips the check of the release. Memory and disk
# are checked before the first build only; the later ones need little.
check_machine() {
    local preset=$1 disk_mb=$2 system=unknown name='an unknown system' free
    if [ -r /etc/os-release ]; then
        system=$(. /etc/os-release && echo "${ID:-}-${VERSION_ID:-}")
        name=$(. /etc/os-release && echo "${PRETTY_NAME:-$system}")
    fi
    if [ "$system" != debian-12 ] && [ -z "${USAR_ANY_SYSTEM:-}" ]; then
        die "This is $name, and the packages that Mission Control is built with are those of Debian 12 (bookworm):" \
            "use that, in a container for example, or set USAR_ANY_SYSTEM=1 to try it here."
    fi
    [ ! -f "$root/build/$preset/build.ninja" ] || return 0
    free=$(free_memory_mb)
    if [ "$free" -lt $compiler_memory_mb ]; then
        die "Only $free MB of memory are free and the compiler needs $compiler_memory_mb MB: close other programs, or use a" \
            "machine with more memory."
    fi
    free=$(free_disk_mb "$root/build")
    if [ "$free" -lt "$disk_mb" ]; then
        die "Only $free MB are free on the disk that holds $root and the build needs $disk_mb MB: make room there, or" \
            "clone to another disk."
    fi
    mkdir -p "$root/build" 2>/dev/null && [ -w "$root/build" ] ||
        die "The folder $root/build cannot be written, and all that is built goes there: clone as the user who builds."
}

# compile_jobs PRESET: compilers beside each other, one a core, and no more than the memory holds.
compile_jobs() {
    local cores by_memory each_mb=$compiler_memory_mb
    cores=$(nproc)
    ! grep -q 'USAR_COMPILER_HEAP_MB:STRING=[1-9]' "$root/build/$1/CMakeCache.txt" || each_mb=$generous_memory_mb
    by_memory=$(($(free_memory_mb) / each_mb))
    [ "$by_memory" -ge 1 ] || by_memory=1
    echo $((cores < by_memory ? cores : by_memory))
}

# compiler_heap_mb: what a compiler may fill before it looks for garbage; 0 leaves that to itself.
compiler_heap_mb() {
    if [ "$(free_memory_mb)" -ge $(($(nproc) * generous_memory_mb)) ]; then echo 900; else echo 0; fi
}

# first_error LOG: the first thing that went wrong in it, with what stands below it.
first_error() {
    local pattern='^dpkg: error|^E: |CMake Error|error: |undefined reference|ld: |No space left on device|Killed signal|out of memory'
    pattern+='|virtual memory exhausted|Segmentation fault|^FAILED: |^sudo: '
    if grep -q -E "$pattern" "$1"; then
        # Of a failed step its command line comes first, which is long and says nothing.
        local line
        line=$(grep -n -m 1 -E "${pattern/|^FAILED: /}" "$1" | cut -d: -f1 || true)
        tail -n "+${line:-1}" "$1" | head -n 13 | sed '/^\[[0-9]*\/[0-9]*\]/,$d'
    else
        tail -n 12 "$1"
    fi
}

# what_to_do LOG: a sentence that fits what stands there.
what_to_do() {
    if grep -q 'No space left on device' "$1"; then
        echo "The disk is full: make room, then run this again; it goes on where it stopped."
    elif grep -qE 'Killed signal|out of memory|virtual memory exhausted' "$1"; then
        echo "The compiler ran out of memory: close other programs, then run this again; it goes on where it stopped."
    elif grep -qE 'Could not resolve|Unable to fetch|Temporary failure|Failed to fetch|Unable to locate package' "$1"; then
        echo "The package server could not be reached or does not have the package: check the network and /etc/apt/sources.list, then run this again."
    elif grep -q 'Could not get lock' "$1"; then
        echo "Another program is installing packages: wait for it, then run this again."
    elif grep -q 'CMake Error' "$1"; then
        echo "If packages were changed since the last time, delete the folder build and run this again."
    else
        echo "If you changed the code, fix it and run this again; it goes on where it stopped."
    fi
}

# give_up WHAT LOG
give_up() {
    say "$1 failed. The first error:"
    first_error "$2" | sed 's/^/    /' >&2
    say "The full log is ${2#"$root"/}. $(what_to_do "$2")"
    exit 2
}

# install_missing PACKAGE…: asks dpkg first, so that a prepared machine needs neither the network nor rights.
install_missing() {
    local missing=() package as_root=() log=$root/build/packages.log begin=$SECONDS
    for package in "$@"; do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
    done
    [ ${#missing[@]} -gt 0 ] || return 0
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || die "Missing packages: ${missing[*]}. Install them as root, then run this again."
        as_root=(sudo)
        sudo true || die "Missing packages: ${missing[*]}. Install them as root, then run this again."
    fi
    say "Installing: ${missing[*]}"
    "${as_root[@]}" env LC_ALL=C.UTF-8 apt-get update -qq >"$log" 2>&1 || give_up "Updating the package lists" "$log"
    # Hundreds of small files: asking the disk to confirm each one is most of the time on a slow disk. The status goes to a
    # descriptor of its own, for apt closes it in what it starts; it is opened within sudo, which closes all but three.
    "${as_root[@]}" env LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive bash -c '
        exec apt-get install -y -q --no-install-recommends -o Dpkg::Options::=--force-unsafe-io -o Dpkg::Use-Pty=0 \
            -o APT::Status-Fd=3 "${@:2}" 3>&1 >>"$1" 2>&1 </dev/null' install "$log" "${missing[@]}" |
        follow "Installing packages" read_apt_status || give_up "Installing packages" "$log"
    say "Installed in $(as_time $((SECONDS - begin)))."
}

# steps_weight PRESET [TARGET…]: of all steps that are left to be built; nothing where ninja cannot tell.
steps_weight() {
    local line weight sum=0 steps folder=$root/build/$1
    shift
    steps=$(NINJA_STATUS='[%f/%t] ' ninja -C "$folder" -n "$@" 2>/dev/null) || return 0
    while IFS= read -r line; do
        [[ $line == \[* ]] || continue
        step_weight "$line"
        sum=$((sum + weight))
    done <<<"$steps"
    echo $sum
}

# build PRESET TARGETS [CMAKE-ARG…]: TARGETS is one word, names with spaces between. Headers are read and small files
# compiled together, which takes a third of the time.
build() {
    local preset=$1 targets begin=$SECONDS log weight
    read -ra targets <<<"$2"
    shift 2
    log=$root/build/$preset.log
    cd "$root"
    export LC_ALL=C.UTF-8 NINJA_STATUS='[%f/%t] '
    # The heap is chosen once: another figure would be another command for each file.
    if [ ! -f "build/$preset/CMakeCache.txt" ]; then set -- -DUSAR_COMPILER_HEAP_MB="$(compiler_heap_mb)" "$@"; fi
    # A compiler cache would hash 300 MB of precompiled headers for each file.
    cmake --preset "$preset" -DUSAR_PRECOMPILE=ON -DUSAR_COMPILER_CACHE=OFF -DCMAKE_UNITY_BUILD=ON \
        -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 "$@" >"$log" 2>&1 ||
        give_up "Configuring the build $preset" "$log"
    weight=$(steps_weight "$preset" "${targets[@]}")
    [ "$weight" != 0 ] || return 0
    [ -s "$root/build/$preset/.ninja_log" ] || say "Building $preset; this takes minutes only the first time."
    CMAKE_BUILD_PARALLEL_LEVEL=$(compile_jobs "$preset")
    export CMAKE_BUILD_PARALLEL_LEVEL # the build of the fuzzers within reads it, too
    cmake --build --preset "$preset" --target "${targets[@]}" 2>&1 </dev/null | tee -a "$log" |
        follow "Building $preset" read_ninja "${weight:-0}" || give_up "Building $preset" "$log"
    say "Built $preset in $(as_time $((SECONDS - begin)))."
}
