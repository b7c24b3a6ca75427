// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QPainter;

namespace limn {

struct Overlay;
struct ViewGeometry;

/// Paints what stands above the pictures, in the painter's logical pixels.
void paintOverlay(QPainter& painter, const Overlay& overlay);

/// Paints it into the framebuffer bound in the current OpenGL context.
void paintOverlayInContext(const Overlay& overlay, const ViewGeometry& geometry);

} // namespace limn
