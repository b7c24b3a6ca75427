// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/Resources.h"

#include <QResource>

// Qt's macro declares a function and so must stand outside every namespace.
static void initialiseResources() {
  Q_INIT_RESOURCE(limn_widgets);
}

namespace limn {

void loadWidgetResources() {
  initialiseResources();
}

} // namespace limn
