// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FuzzInput.h"

#include "io/looks/families/Families.h"
#include "io/scenefile/SceneFile.h"

#include <algorithm>

namespace limn::test {

/// A look that was read is a sound preset, which the family's own files hold, too. With a volume and without.
inline void fuzzLook(const LookFormat& format, std::string_view text) {
  format.isMine(text);
  for (const std::optional<LookTarget>& target :
       {std::optional<LookTarget>(), std::optional(LookTarget{-1024.0, 3071.0, 0.7})})
    harmless([&] {
      for (const ReadLook& look : format.read(text, "input", target)) {
        if (!std::ranges::is_sorted(look.preset.transferFunction.points, {}, &ControlPoint::value))
          fault("points that do not ascend");
        const std::string kept = presetToJson(look.preset);
        if (presetToJson(parsePreset(kept, "kept")) != kept)
          fault("a look was read that is kept as another preset");
        if (format.write && format.read(format.write(look.preset, target).text, "written", target).empty())
          fault("a look was written that is none");
      }
    });
}

} // namespace limn::test
