// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/Engine.h"
#include "scene/Scene.h"
#include "widgets/view/pictures/PictureState.h"

#include <QString>

#include <optional>

namespace limn {

/// From here on it is told how long drawing takes.
inline constexpr double longSeconds = 10.0;

/// Whether the picture of a scene on screen, complete, is all that a saved one of its size is to be: of
/// physical light it has the paths that are asked for and no filter of their noise, as the view shows none.
bool isAsSaved(const Scene& scene, const SideState& shown);

/// How long a picture of a scene takes whose like stands on screen, s, if it has so many times its pixels;
/// absent where what was drawn for the screen does not tell, as before it is complete.
std::optional<double> secondsToDraw(const Scene& scene, const SideState& shown, double timesThePixels);

/// Whether light is found anew for each direction of view, beside the picture: a lamp that turns with the
/// camera casts shadows that are looked up. Along paths the processor finds it with each picture.
bool findsLightForEachView(const Scene& scene, Engine engine);

/// What is to be said of how long the frames of a turntable take an engine to draw, as for secondsToDraw;
/// empty where that is short.
QString framesTimeText(const Scene& scene, Engine engine, const SideState& shown, double timesThePixels,
                       int frames);

/// How far a saved picture of physical light is drawn, in words: "256 paths a pixel, noise filtered".
QString savedPathsText(const PhysicalLight& light);

} // namespace limn
