#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes a folder with Debian's arm64 packages, for a compiler and an emulator on another processor: sysroot.sh FOLDER
# PACKAGE… It needs no root and leaves the system's own packages alone: apt works on lists and a state of its own
# beside the packages, in FOLDER.apt, and what it fetches is unpacked without being set up.
set -euo pipefail
folder=$(realpath -m "$1")
shift
apt=$folder.apt
wanted="$*"
[ "$(cat "$folder/wanted" 2>/dev/null)" != "$wanted" ] || exit 0

# Nothing counts as installed, and no other architecture is known.
rm -rf "$folder"
mkdir -p "$folder/usr/lib" "$apt/lists/partial" "$apt/archives/partial"
: >"$apt/status"
of_arm64=(apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures::=arm64 -o "Dir::State=$apt" -o "Dir::Cache=$apt"
  -o "Dir::State::status=$apt/status" -o APT::Install-Recommends=false -o APT::Sandbox::User=root -o Debug::NoLocking=1)
"${of_arm64[@]}" update
"${of_arm64[@]}" install --yes --download-only "$@" >/dev/null

# As in a Debian with one tree, /lib is /usr/lib; documents and the Java that VTK's packages ask for are left out.
ln -s usr/lib "$folder/lib"
for package in "$apt"/archives/*.deb; do
  dpkg-deb --fsys-tarfile "$package" | tar -x -C "$folder" --keep-directory-symlink --no-same-owner \
    --exclude='./usr/share/doc' --exclude='./usr/share/man' --exclude='./usr/share/locale' --exclude='./usr/lib/jvm'
done
rm -rf "$apt"

# Links that begin at the root would lead out of the folder.
find "$folder" -type l -lname '/*' -printf '%l\t%p\n' | while IFS=$'\t' read -r to link; do
  ln -sfnr "$folder$to" "$link"
done
# What update-alternatives would choose.
libraries=$folder/usr/lib/aarch64-linux-gnu
for library in blas/libblas.so.3 lapack/liblapack.so.3; do
  ln -sf "$library" "$libraries"
done
printf '%s' "$wanted" >"$folder/wanted"
