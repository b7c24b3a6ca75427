// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/SystemInfo.h"

#include "gl/HeadlessContext.h"
#include "scene/Error.h"

#include <QString>
#include <QSysInfo>
#include <QtGlobal>

#include <cstdio>
#include <thread>

namespace limn {

void printSystemInfo() {
  std::printf("limn        %s\n", LIMN_VERSION);
  std::printf("Qt          %s\n", qVersion());
  std::printf("system      %s, %s\n", QSysInfo::prettyProductName().toUtf8().constData(),
              QSysInfo::currentCpuArchitecture().toUtf8().constData());
  std::printf("processors  %u\n", std::thread::hardware_concurrency());
  try {
    const HeadlessContext context;
    std::printf("OpenGL      %s\n", rendererName().c_str());
  } catch (const Error& error) {
    std::printf("OpenGL      none: %s\n", error.what());
  }
}

} // namespace limn
