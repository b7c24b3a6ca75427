// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace limn {

/// What a file says, or its name lets expect, of how a volume was taken: enough to choose a first look, and
/// nothing that could name anybody.
struct ScanHints {
  enum class BodyPart { unknown, head, chest, abdomen, other };
  enum class Weighting { unknown, t1, t2, pd };
  std::string modality; ///< DICOM code; empty where nothing tells
  BodyPart bodyPart = BodyPart::unknown;
  Weighting weighting = Weighting::unknown; ///< of MR
  bool isAngiography = false;               ///< vessels filled with contrast, or by flow
  bool operator==(const ScanHints&) const = default;
};

/// From words in a description or a file's name ("cta_brain", "T1 MPRAGE sag"); words that say nothing leave
/// the hints as they are.
ScanHints withHintsOf(ScanHints hints, std::string_view text);

/// The weighting of a spin echo by its times (ms), both > 0: short repetition T1; long repetition PD where
/// the echo is short, T2 where it is long.
ScanHints::Weighting weightingBy(double repetitionMs, double echoMs);

} // namespace limn
