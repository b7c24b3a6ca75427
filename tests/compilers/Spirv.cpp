// SPDX-License-Identifier: GPL-3.0-or-later
#include "Spirv.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <memory>

namespace limn::test {
namespace {

// Uniforms outside blocks, and samplers without places, are OpenGL's: the relaxed rules let them be.
constexpr auto rules = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);

// The first version that can be translated for Vulkan; it has all of 1.30 that Limn uses.
constexpr int version = 450;

std::unique_ptr<glslang::TShader> parsed(const ShaderSource& source, EShLanguage stage) {
  auto shader = std::make_unique<glslang::TShader>(stage);
  const char* text = source.text.c_str();
  shader->setStrings(&text, 1);
  shader->setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
  shader->setEnvInputVulkanRulesRelaxed();
  shader->setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
  shader->setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  shader->setAutoMapBindings(true);
  shader->setAutoMapLocations(true);
  if (!shader->parse(GetDefaultResources(), version, ECoreProfile, true, false, rules))
    throw std::runtime_error(withFileLines(shader->getInfoLog(), source));
  return shader;
}

Spirv translated(const glslang::TProgram& program, EShLanguage stage) {
  spv::SpvBuildLogger log;
  Spirv words;
  glslang::GlslangToSpv(*program.getIntermediate(stage), words, &log);
  if (const std::string said = log.getAllMessages(); !said.empty())
    throw std::runtime_error(said);
  return words;
}

} // namespace

SpirvProgram spirvOf(const ShaderSource& vertex, const ShaderSource& fragment) {
  static const bool isReady = glslang::InitializeProcess();
  if (!isReady)
    throw std::runtime_error("glslang does not start");
  const auto vertexShader = parsed(vertex, EShLangVertex);
  const auto fragmentShader = parsed(fragment, EShLangFragment);
  glslang::TProgram program;
  program.addShader(vertexShader.get());
  program.addShader(fragmentShader.get());
  if (!program.link(rules) || !program.mapIO())
    throw std::runtime_error(program.getInfoLog());
  return {translated(program, EShLangVertex), translated(program, EShLangFragment)};
}

} // namespace limn::test
