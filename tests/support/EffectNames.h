// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace limn::test {

/// The rows that people and scripts are told of, as the scene format documents them, in its order.
inline const std::vector<std::string> documentedEffects{"gradient",
                                                        "lighting",
                                                        "specular",
                                                        "exponent_map",
                                                        "opacity_map",
                                                        "gradient_curve",
                                                        "robust",
                                                        "fog",
                                                        "crop",
                                                        "early_termination",
                                                        "preintegration",
                                                        "empty_space_skipping",
                                                        "gradient_opacity",
                                                        "isosurface",
                                                        "jitter",
                                                        "knee",
                                                        "two_sided",
                                                        "region",
                                                        "label_looks",
                                                        "shadow",
                                                        "occlusion",
                                                        "smooth_normals",
                                                        "physical",
                                                        "own_weights"};

} // namespace limn::test
