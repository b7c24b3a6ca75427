// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

/// Registers the icons and the style sheet of this library: a linker drops a static library's resources
/// unless somebody asks for them. Cheap to call again.
void loadWidgetResources();

} // namespace limn
