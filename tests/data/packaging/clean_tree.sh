#!/bin/sh
# clean_tree.sh PACKAGES TREE: installs, uses and removes the Debian packages of the folder PACKAGES in a clean Debian 12
# that it makes in the folder TREE. It must run as root in namespaces of its own (unshare --mount --pid --fork --mount-proc),
# so that its end ends everything that it has started. Packages come from where this machine gets its own.
set -eu
packages=$1 tree=$2
step() { echo "== $*"; }
fail() {
    echo "failed: $*"
    exit 1
}
inside() {
    env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive chroot "$tree" "$@"
}
# in_shell COMMANDS, as a person without rights, in a home of their own.
in_shell() { inside setpriv --reuid=1000 --regid=1000 --clear-groups env HOME=/home/person sh -e -c "cd; $1"; }
install_packages() {
    inside apt-get install -y -q --no-install-recommends -o Dpkg::Options::=--force-unsafe-io "$@" >"$tree/tmp/apt.log" 2>&1 ||
        fail "installing $*: $(tail -n 12 "$tree/tmp/apt.log")"
}
the_package() { (cd "$tree" && ls packages/"$1"_*.deb) | sed 's|^|/|'; }
# shellcheck disable=SC2016 # dpkg-query has variables of its own
installed() { inside dpkg-query -W -f='${Package} ${db:Status-Abbrev}\n' "$1" 2>/dev/null | grep -q ' ii'; }
there() { for file; do [ -e "$tree$file" ] || fail "$file is not there"; done; }

step "a clean Debian 12"
mmdebstrap --quiet --variant=apt bookworm - 2>/dev/null | tar -x -C "$tree" || fail "mmdebstrap makes no tree"
rm -rf "$tree/etc/apt"
cp -a /etc/apt "$tree/etc/apt"
cp -L /etc/resolv.conf /etc/hosts "$tree/etc/"
mount -t proc proc "$tree/proc"
mount --rbind /dev "$tree/dev"
mkdir "$tree/packages"
cp "$packages"/usar-mission-control*.deb "$tree/packages"
inside useradd --create-home --uid 1000 person
inside apt-get update -q >"$tree/tmp/apt.log" 2>&1 || fail "apt-get update: $(tail -n 5 "$tree/tmp/apt.log")"

step "the programs without a window"
install_packages "$(the_package usar-mission-control-headless)"
! installed libqt6widgets6 || fail "the headless package brings Qt Widgets"
for file in "$tree"/usr/bin/usar-* "$tree"/usr/lib/usar-mission-control/robots/*.so; do
    linked=$(readelf -d "$file" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p')
    ! echo "$linked" | grep -E 'Widgets|PrintSupport|QCustomPlot|SDL|lib(X|xcb|GL|EGL|OpenGL)' || fail "$file links these"
done
there /usr/share/man/man1/usar-mission.1.gz /usr/lib/usar-mission-control/robots/airrobot.so
zcat "$tree/usr/share/man/man1/usar-mission.1.gz" | grep -q '^\.TH ' || fail "the man page is none"
inside bash -c '. /usr/share/bash-completion/completions/usar-mission && complete -p usar-mission' || fail "nothing is completed"
flown=$(in_shell 'usar-mission run /usr/share/usar-mission-control/missions/quick_scan.json --seed 3 --speed max --out results' |
    tail -n 1)
echo "$flown" | grep -q '"success": *true' || fail "the mission: $flown"
ls "$tree"/home/person/results/*_picture.png

step "the window"
install_packages xvfb xdotool fonts-dejavu-core "$(the_package usar-mission-control)"
there /usr/share/applications/usar-mission-control.desktop /usr/share/man/man1/mission-control.1.gz
# shellcheck disable=SC2016 # the variables are those of the shell inside
in_shell '
    export DISPLAY=:17 XDG_RUNTIME_DIR=$HOME
    Xvfb $DISPLAY -screen 0 1280x800x24 -fbdir "$HOME" >xvfb.log 2>&1 &
    for i in $(seq 100); do [ -e /tmp/.X11-unix/X17 ] && break; sleep 0.1; done
    mission-control >window.log 2>&1 &
    window=$!
    timeout 60 xdotool search --sync --onlyvisible --name "Mission Control" >/dev/null ||
        { echo "no window: $(cat xvfb.log window.log)"; exit 1; }
    sleep 3
    kill -0 $window && cp Xvfb_screen0 screen.xwd
    kill $window
    wait $window || [ $? -eq 143 ] || { echo "the window ended badly: $(cat window.log)"; exit 1; }
    kill %1' || fail "the window"

step "a robot of one's own, by CMake and by pkg-config"
install_packages g++ cmake ninja-build pkg-config "$(the_package usar-mission-control-dev)"
sample=/usr/share/usar-mission-control/sample
in_shell "cp -r $sample by_cmake; cd by_cmake; cmake -G Ninja -B build >log; cmake --build build >log
          usar-mission run hop.json --plugins build/robots --out results | tail -n 1 | grep -q '\"success\": *true'" ||
    fail "the sample by CMake"
commands=$(sed -n '/^Without CMake/,/^## /p' "$tree$sample/README.md" | sed -n '/^```$/,/^```$/p' | sed '/^```$/d')
[ -n "$commands" ] || fail "the sample's page has no commands for pkg-config"
in_shell "cp -r $sample by_pkg_config; cd by_pkg_config
          { $commands
          } | tail -n 1 | grep -q '\"success\": *true'" || fail "the sample by pkg-config"

step "the documents"
install_packages doc-base "$(the_package usar-mission-control-doc)"
there /usr/share/usar-mission-control/html/resources/docs/tasks/README.html \
    /usr/share/doc/usar-mission-control-doc/manual/README.html /usr/share/doc/usar-mission-control-doc/reference/index.html
for document in usar-mission-control-manual usar-mission-control-reference; do
    inside install-docs --status "$document" || fail "$document is not registered"
done

step "gone again"
ours='usar-mission-control usar-mission-control-headless usar-mission-control-dev usar-mission-control-doc'
# shellcheck disable=SC2086 # these are four words
inside dpkg -L $ours | grep -v -e '^$' -e '^/\.$' | sort -u >"$tree/tmp/listed"
# shellcheck disable=SC2086
inside apt-get purge -y -q $ours >"$tree/tmp/apt.log" 2>&1 || fail "apt-get purge: $(tail -n 12 "$tree/tmp/apt.log")"
while IFS= read -r file; do
    if [ -e "$tree$file" ] || [ -L "$tree$file" ]; then
        inside dpkg -S "$file" >/dev/null 2>&1 || fail "$file is left over"
    fi
done <"$tree/tmp/listed"
left=$(cd "$tree" && find . -xdev \( -path ./packages -o -path ./home -o -path ./tmp -o -path ./proc -o -path ./dev \
    -o -path ./var/log -o -path ./var/cache \) -prune -o \( -name '*usar[-_]*' -o -name '*mission-control*' \) -print)
[ -z "$left" ] || fail "left over: $left"
step "passed"
