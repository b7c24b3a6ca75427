#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A package tried as a stranger would, in a fresh minimal Debian: app/packaging/try_out.sh PACKAGE.deb [FOLDER]
# Needs root, debootstrap, a mirror, and some 3 GB in FOLDER (a new one below /tmp), which is left for a look.
# Fails where the package cannot be installed, started or used there, or leaves a file when it is purged.
set -euo pipefail
package=$(realpath "$1")
root=${2:-$(mktemp -d /tmp/limn-try-XXXXXX)}
chmod 755 "$root" # mktemp lets nobody else in, and it becomes the stranger's /
mirror=${LIMN_DEBIAN_MIRROR:-http://deb.debian.org/debian}

inside() { unshare --mount --pid --fork --mount-proc="$root/proc" chroot "$root" env -i \
  PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
as_stranger() { inside su stranger -s /bin/sh -c "cd && $1"; }
apt_get() { inside apt-get -y -qq "$@" >>"$root/apt.log" 2>&1 || { tail -n 20 "$root/apt.log" >&2; exit 1; }; }
seconds() { local TIMEFORMAT=%R; { time "$@" >/dev/null 2>&1; } 2>&1; }
# What belongs to the system; apt's lists and logs say that there was a package, and are nobody's.
files() { inside find / -xdev \( -path /proc -o -path /tmp -o -path /home -o -path /var/cache -o -path /var/log \
  -o -path /var/lib/apt -o -path /var/lib/dpkg -o -path /apt.log \) -prune -o -print | sort; }
installed_mb() { inside dpkg-query -W -f '${Installed-Size}\n' | awk '{ sum += $1 } END { printf "%.0f", sum / 1024 }'; }

[ -x "$root/usr/bin/apt-get" ] || debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log"
: >"$root/apt.log"
apt_get update
bare=$(installed_mb)
echo "needed packages: $(seconds apt_get --no-install-recommends satisfy "$(dpkg-deb -f "$package" Depends)") s"
echo "needed packages hold $(($(installed_mb) - bare)) MB"
apt_get --no-install-recommends install xvfb xauth
inside id stranger >/dev/null 2>&1 || inside useradd -m stranger
files >"$root.before"

cp "$package" "$root/tmp/limn.deb"
echo "apt install ./limn.deb: $(seconds apt_get --no-install-recommends install /tmp/limn.deb) s"
echo "package $(stat -c %s "$package") bytes, installed $(dpkg-deb -f "$package" Installed-Size) KiB"
echo "version: $(as_stranger 'limn --version')"
for _ in 1 2 3; do echo "limn --version: $(seconds as_stranger 'limn --version') s with the change of root"; done
echo "nothing at all: $(seconds as_stranger true) s with the change of root"
echo "limn render sample: $(seconds as_stranger 'limn render sample --size 512x512 -o picture.png') s"
as_stranger 'test -s picture.png'
echo "window, drawn at rest, and its picture: $(seconds as_stranger \
  'xvfb-run -a -s "-screen 0 1400x900x24" limn --screenshot window.png sample') s"
as_stranger 'test -s window.png'

apt_get purge limn
files >"$root.after"
diff "$root.before" "$root.after" || { echo "the lines above changed by installing and purging the package" >&2; exit 1; }
echo "apt purge limn: left nothing; pictures are in $root/home/stranger"
