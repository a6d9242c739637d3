#!/usr/bin/env bash
# Makes the .deb, installs it in a bare Debian 12 and works with it there. Needs root, debootstrap and a Debian mirror; about 3 minutes.
#
#   tests/package/bare_debian.sh [BUILD_DIR]     default build/release, which must be built
set -euo pipefail

here=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$here/build/release}
((EUID == 0)) || { echo "bare_debian: needs root, for chroot" >&2 && exit 2; }
command -v debootstrap >/dev/null || { echo "bare_debian: needs debootstrap (apt install debootstrap)" >&2 && exit 2; }

scratch=$(mktemp -d)
trap 'umount "$scratch/root/proc" 2>/dev/null || true; rm -rf "$scratch"' EXIT
(cd "$scratch" && cpack --config "$build/CPackConfig.cmake" -B "$scratch/package" >"$scratch/said") || { cat "$scratch/said" >&2 && exit 1; }
deb=$(echo "$scratch"/package/*.deb)
[[ -f $deb ]] || { echo "bare_debian: cpack made no .deb" >&2 && exit 1; }
echo "package: ${deb##*/}, $(stat -c %s "$deb" | numfmt --to=iec), depends on $(dpkg-deb -f "$deb" Depends)"

mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null | grep -oE 'https?://[^ ]+/debian/?( |$)' | head -1 || true)
debootstrap --variant=minbase bookworm "$scratch/root" "${mirror:-http://deb.debian.org/debian}" >"$scratch/said" 2>&1 || { tail -5 "$scratch/said" >&2 && exit 1; }
for file in /etc/apt/apt.conf.d/*registry* /etc/apt/apt.conf.d/*proxy* /etc/resolv.conf; do [[ ! -f $file ]] || cp "$file" "$scratch/root$file"; done # how this machine reaches its mirror
mount -t proc proc "$scratch/root/proc"
cp "$deb" "$here/tests/data/heights/gz_dem_squared_129.tif" "$scratch/root/root/"
inside() { chroot "$scratch/root" /usr/bin/env -i HOME=/root PATH=/usr/bin:/bin:/usr/sbin:/sbin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
inside dpkg-query -W -f '${Package}\n' | wc -l | sed 's/$/ packages before/'
inside apt-get install -y "/root/${deb##*/}" >"$scratch/said" 2>&1 || { tail -20 "$scratch/said" >&2 && exit 1; }
inside dpkg-query -W -f '${Package}\n' | wc -l | sed 's/$/ packages after/'

inside reliefbake --version
inside reliefbake cone /root/gz_dem_squared_129.tif -o /root/map.exr
inside reliefbake verify /root/map.exr --rays 20000
inside reliefbake render /root/map.exr -o /root/picture.png --view 60 --shadow
test -s "$scratch/root/root/picture.png"
pages=("$scratch"/root/usr/share/man/man1/reliefbake*.gz)
echo "${#pages[@]} man pages"
inside bash -c 'source /usr/share/bash-completion/completions/reliefbake; compopt() { :; }; COMP_WORDS=(reliefbake cone --encoding r) COMP_CWORD=3; _reliefbake; echo "completes --encoding r: ${COMPREPLY[*]}"; [[ ${COMPREPLY[*]} == "ratio radius" ]]'
inside apt-get purge -y reliefbake >/dev/null 2>&1
[[ -z $(find "$scratch/root/usr" -name '*reliefbake*') ]] || { echo "bare_debian: purging left files" >&2 && exit 1; }
echo 'installed, worked, purged without a trace'
