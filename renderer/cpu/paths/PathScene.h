// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/paths/PathTerms.h"
#include "cpu/rays/PictureTerms.h"
#include "scene/Scene.h"

namespace limn::cpu {

/// The scene whose tissue random paths go through: the curve's, and the looks' of labels, as dense as
/// physical light asks for, without anything that it does not know (DEFINITION section 12).
Scene mediumOf(const Scene& scene);

/// The scene whose picture has the alpha of a picture of physical light: the same tissue without light, each
/// ray to its end.
Scene alphaOf(const Scene& scene);

/// What paths share in a picture of a medium whose terms are these, but for majorants and looks.
PathTerms pathTerms(const Scene& medium, const PictureTerms& terms);

/// Where the paths of a pixel begin.
PathStart pathStart(const PathTerms& paths, const PictureTerms& terms, int x, int y);

} // namespace limn::cpu
