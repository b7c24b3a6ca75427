#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs what ./dev arm64 built under qemu: the program, whose pictures are held against those of this machine's own
# processor and of the reference; every hard case; and the tests of what computes pictures, less those that take the
# emulator minutes each.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
TIMEFORMAT='%R s, %U s of the processor'

emulated() { qemu-aarch64-static -L build/arm64-sysroot "$@"; }
native=build/release/limn
pictures=build/arm64/pictures
mkdir -p "$pictures"
# Without a driver: Mesa's compiles its programs as it draws, which takes an emulator for ever.
export __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null

version=$(emulated build/arm64/limn --version)
[ "$version" = "$("$native" --version)" ] || { echo "arm64 says it is \"$version\"" >&2; exit 1; }

# As far apart as two sets of instructions may be (tests/cpu/InstructionSetTest.cpp), and half as far as the engine may
# be from the definition (tests/cpu/CpuAgainstReferenceTest.cpp).
for model in none classic enhanced robust; do
  scene=(render sample --model "$model" --size 128x128)
  echo "arm64 draws the sample, $model:"
  time emulated build/arm64/limn "${scene[@]}" --engine cpu -o "$pictures/$model-arm64.exr"
  "$native" "${scene[@]}" --engine cpu -o "$pictures/$model-native.exr"
  "$native" "${scene[@]}" --engine reference -o "$pictures/$model-reference.exr"
  for other in native:0.05 reference:0.25; do
    printf '  from %s: ' "${other%:*}"
    build/release/tests/arm64/limn_picture_difference "$pictures/$model-arm64.exr" "$pictures/$model-${other%:*}.exr" "${other#*:}"
  done
done

echo "hard cases, and 20 random scenes, without OpenGL:"
time emulated build/arm64/limn stability -o build/arm64/stability --fuzz 20 --quiet | tail -n 4

tests() {
  echo "limn_$1_tests $2:"
  time emulated "build/arm64/tests/$1/limn_$1_tests" --gtest_brief=1 --gtest_filter="$2"
}
tests scene '-Boundaries.*:Phantom.noise*:Pyramid.comparesEverySlice'
tests reference '*'
tests cpu 'CpuAnalytic.*:CpuAgainstReference.everyParameter*:CpuAgainstReference.everyStored*:CpuRules.*'
