// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowProgram.h"

int main(int argc, char** argv) {
  return limn::runCommandLine(argc, argv, limn::programWindows());
}
