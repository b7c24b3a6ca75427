#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What a built program is linked with and made of, as an SPDX document:
#   app/packaging/sbom.sh BUILD_FOLDER VERSION > limn.spdx
# Libraries are those that the dynamic linker loads for the program and its module, with all that they bring along;
# headers are those that the compiler read. Both are named by the Debian packages that own them.
set -euo pipefail
build=$1
version=$2
: "${SOURCE_DATE_EPOCH:=$(date +%s)}"

# The packages of the paths on stdin, one a line. dpkg may know a path in /usr/lib as one in /lib, or the other way round.
packages_of() {
  local paths
  paths=$(cat)
  awk '{ print; if (sub("^/usr", "")) print; else print "/usr" $0 }' <<<"$paths" |
    { xargs dpkg-query -S 2>/dev/null || true; } | sed -n 's/^\([^ ,]*\)\(, [^:]*\)*: /\1 /p' |
    awk -v paths="$paths" '
      { path = $2; sub("^/usr", "", path); owner[path] = $1 }
      END {
        count = split(paths, wanted, "\n")
        for (i = 1; i <= count; ++i) {
          path = wanted[i]; sub("^/usr", "", path)
          if (path in owner) print owner[path]
          else { print "sbom: no package owns " wanted[i] > "/dev/stderr"; failed = 1 }
        }
        exit failed
      }' | LC_ALL=C sort -u
}

libraries() {
  ldd "$build/limn" "$build"/lib/liblimn_picture_files.so | sed -n 's/.*=> \(\/[^ ]*\) .*/\1/p' | sort -u |
    xargs -n 1 realpath | sort -u
}

headers() { ninja -C "$build" -t deps | sed -n 's/^ *\(\/usr\/include\/[^ ]*\)$/\1/p' | sort -u; }

# For each package of the list, its name and the licences that its copyright file names, where a machine can read it.
licences_of() {
  local package file
  for package in "$@"; do
    file=/usr/share/doc/${package%:*}/copyright
    [ -r "$file" ] && printf '%s\n' "$file"
  done | LC_ALL=C xargs awk '
    FNR == 1 { split(FILENAME, parts, "/"); name = parts[5]; print name "\t" }
    /^Format:/ { print name "\tFormat:" }
    sub("^License:[ \t]*", "") && $0 != "" { print name "\t" $0 }' | LC_ALL=C sort -u | LC_ALL=C awk -F '\t' '
    function tell() {
      if (name != "")
        print name "\t" (isForMachines ? licences : "as told in prose in /usr/share/doc/" name "/copyright")
    }
    $2 == "" { tell(); name = $1; licences = ""; isForMachines = 0; next }
    $2 == "Format:" { isForMachines = 1; next }
    { licences = licences (licences == "" ? "" : "; ") $2 }
    END { tell() }'
}

# Version and licences by package. Each program is asked once of all packages: one process for each takes a minute.
declare -A version_of licence_of relation_of
learn() {
  local package value
  while read -r package value; do version_of[$package]=$value; done < <(
    dpkg-query -W -f='${binary:Package} ${Version}\n' "$@")
  while IFS=$'\t' read -r package value; do licence_of[$package]=$value; done < <(licences_of "$@")
}

describe() { # PACKAGE
  local name=${1%:*} version=${version_of[$1]:-} id purl relation
  id=SPDXRef-${name//[^A-Za-z0-9.]/-}
  purl=${version//+/%2B}
  relation="$id BUILD_DEPENDENCY_OF SPDXRef-limn"
  [ "${relation_of[$1]}" = linked ] && relation="SPDXRef-limn DYNAMIC_LINK $id"
  printf '%s\n' "" "PackageName: $name" "SPDXID: $id" "PackageVersion: $version" \
    "PackageSupplier: Organization: Debian" "PackageDownloadLocation: NOASSERTION" "FilesAnalyzed: false" \
    "PackageLicenseConcluded: NOASSERTION" "PackageLicenseDeclared: NOASSERTION" \
    "PackageLicenseComments: <text>Licences in its copyright file: ${licence_of[$name]:-none is named}</text>" \
    "PackageCopyrightText: NOASSERTION" \
    "ExternalRef: PACKAGE-MANAGER purl pkg:deb/debian/${name//+/%2B}@${purl//:/%3A}" "Relationship: $relation"
}

linked=$(libraries | packages_of)
made_of=$(headers | packages_of | LC_ALL=C comm -13 <(printf '%s\n' "$linked") -)
for package in $made_of; do relation_of[$package]=built; done
for package in $linked; do relation_of[$package]=linked; done
# shellcheck disable=SC2086
learn $linked $made_of
list=$(for package in $linked $made_of; do describe "$package"; done)

cat <<TEXT
SPDXVersion: SPDX-2.3
DataLicense: CC0-1.0
SPDXID: SPDXRef-DOCUMENT
DocumentName: limn-$version
DocumentNamespace: https://spdx.org/spdxdocs/limn-$version-$(sha256sum <<<"$list" | cut -c1-32)
Creator: Tool: app/packaging/sbom.sh
Created: $(date -u -d "@$SOURCE_DATE_EPOCH" +%Y-%m-%dT%H:%M:%SZ)

PackageName: limn
SPDXID: SPDXRef-limn
PackageVersion: $version
PackageSupplier: Organization: The Limn developers
PackageDownloadLocation: NOASSERTION
FilesAnalyzed: false
PackageLicenseConcluded: GPL-3.0-or-later
PackageLicenseDeclared: GPL-3.0-or-later
PackageCopyrightText: <text>2026 The Limn developers</text>
Relationship: SPDXRef-DOCUMENT DESCRIBES SPDXRef-limn
$list
TEXT
