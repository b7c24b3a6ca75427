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

# The licences that the package's own copyright file names, where a machine can read it.
licences_of() {
  local file=/usr/share/doc/${1%:*}/copyright
  [ -r "$file" ] || { echo "none is named"; return; }
  if grep -q '^Format:' "$file"; then
    sed -n 's/^License: *//p' "$file" | sed '/^$/d' | LC_ALL=C sort -u | paste -sd ';' | sed 's/;/; /g'
  else
    echo "as told in prose in $file"
  fi
}

describe() { # PACKAGE RELATION
  local name=${1%:*} id
  id=SPDXRef-$(printf '%s' "$name" | tr -c 'A-Za-z0-9.' '-')
  cat <<TEXT

PackageName: $name
SPDXID: $id
PackageVersion: $(dpkg-query -W -f='${Version}' "$1")
PackageSupplier: Organization: Debian
PackageDownloadLocation: NOASSERTION
FilesAnalyzed: false
PackageLicenseConcluded: NOASSERTION
PackageLicenseDeclared: NOASSERTION
PackageLicenseComments: <text>Licences in its copyright file: $(licences_of "$1")</text>
PackageCopyrightText: NOASSERTION
ExternalRef: PACKAGE-MANAGER purl pkg:deb/debian/${name//+/%2B}@$(dpkg-query -W -f='${Version}' "$1" | sed 's/+/%2B/g; s/:/%3A/g')
Relationship: $([ "$2" = linked ] && echo "SPDXRef-limn DYNAMIC_LINK $id" || echo "$id BUILD_DEPENDENCY_OF SPDXRef-limn")
TEXT
}

linked=$(libraries | packages_of)
made_of=$(headers | packages_of | LC_ALL=C comm -13 <(printf '%s\n' "$linked") -)
list=$(for package in $linked $made_of; do describe "$package" "$(grep -qxF "$package" <<<"$linked" && echo linked || echo built)"; done)

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
