// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/header/DicomTags.h"

#include <algorithm>
#include <optional>

namespace limn::tag {
namespace {

std::optional<Kind> kindOf(DicomTag tag) {
  const auto row = std::ranges::find_if(all, [tag](const Attribute& one) { return one.tag == tag; });
  return row == all.end() ? std::nullopt : std::optional(row->kind);
}

} // namespace

bool isKept(DicomTag tag) {
  const auto kind = kindOf(tag);
  return kind && *kind != Kind::pixels;
}

bool isSequence(DicomTag tag) {
  return kindOf(tag) == Kind::sequence;
}

bool isPixels(DicomTag tag) {
  return kindOf(tag) == Kind::pixels;
}

} // namespace limn::tag
