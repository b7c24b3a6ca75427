// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Image.h"

#include <QImage>

namespace limn {

/// A picture over a background as 8 bits (Format_RGBA8888, opaque), rounded as picture files are.
QImage overBackground(const Image& picture, const glm::dvec3& background);

} // namespace limn
