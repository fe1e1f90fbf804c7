# Sourced by app/run and tests/run: installs what is missing on Debian 12 and builds a preset.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

build_packages=(g++ cmake ninja-build ccache pkg-config qt6-base-dev libqcustomplot-dev libbullet-dev libsdformat-dev
                libpng-dev libjpeg62-turbo-dev libexpected-dev libeigen3-dev libsdl2-dev
                fonts-dejavu-core)
test_packages=(libbenchmark-dev gdal-bin pngcheck clang libclang-rt-14-dev)

say() { printf '%s\n' "$*" >&2; }

# install_missing PACKAGE…: asks dpkg first, so that a prepared machine needs neither the network nor rights.
install_missing() {
    local missing=() package as_root=()
    for package in "$@"; do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { say "Missing packages: ${missing[*]}. Install them as root, then run this again."; exit 2; }
        as_root=(sudo)
    fi
    say "Installing: ${missing[*]}"
    # Hundreds of small files: asking the disk to confirm each one is most of the time on a slow disk.
    "${as_root[@]}" apt-get update -qq >/dev/null
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
        -o Dpkg::Options::=--force-unsafe-io -o Dpkg::Use-Pty=0 "${missing[@]}" >/dev/null ||
        { say "apt-get could not install: ${missing[*]}"; exit 2; }
}

# build PRESET [CMAKE-ARG…]: headers are read and small files compiled together, which takes a third of the time.
build() {
    local preset=$1 log
    shift
    log=$root/build/$preset.log
    mkdir -p "$root/build"
    say "Building $preset (the first time takes a few minutes) …"
    (cd "$root" && cmake --preset "$preset" -DUSAR_PRECOMPILE=ON -DCMAKE_UNITY_BUILD=ON "$@" && cmake --build --preset "$preset") >"$log" 2>&1 || {
        grep -E 'error|warning|Error' "$log" | head -n 40 >&2
        say "The build failed; all of it is in ${log#"$root"/}."
        exit 1
    }
}
