// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/EngineChoice.h"

#include "app/core/drawing/ProcessCost.h"
#include "cpu/CpuRenderer.h"

#include <algorithm>
#include <array>

namespace limn {
namespace {

// Drivers that compute on the processor what a graphics card would.
bool isSoftware(const std::string& renderer) {
  constexpr std::array names{"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SWR"};
  return std::ranges::any_of(names,
                             [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

Message trialSentence(const EngineTimes& times) {
  return Message::
      tr("In a trial on this computer a small picture took %1 ms with OpenGL and %2 ms with the processor.")
          .arg(Message::fixed(times.openGlMs, 1))
          .arg(Message::fixed(times.processorMs, 1));
}

} // namespace

std::string machineWith(const std::string& renderer) {
  return renderer + "; " + machineName() + "; " + CpuRenderer().name();
}

EngineChoice chosenEngine(const EngineFacts& facts) {
  if (!facts.problem.empty())
    return {Engine::cpu, false, facts.problem};
  if (facts.setting)
    return {*facts.setting, false, Message::tr("Chosen in the settings.")};
  if (facts.times)
    return {facts.times->processorMs < facts.times->openGlMs ? Engine::cpu : Engine::rayCaster, false,
            trialSentence(*facts.times)};
  if (isSoftware(facts.renderer))
    return {Engine::cpu, true,
            Message::tr(
                "The graphics driver has no card and draws on the processor itself, where the CPU engine is "
                "likely to be faster.")};
  return {Engine::rayCaster, true, Message::tr("A graphics card is likely to be faster than the processor.")};
}

} // namespace limn
