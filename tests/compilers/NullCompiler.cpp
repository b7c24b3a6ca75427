// SPDX-License-Identifier: GPL-3.0-or-later
#include "NullCompiler.h"

#include <vulkan/vulkan.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

namespace limn::test {
namespace {

void require(VkResult result, const char* what) {
  if (result != VK_SUCCESS)
    throw std::runtime_error(std::string(what) + " failed (VkResult " + std::to_string(result) + ")");
}

// Vulkan's structures say what they are; all else starts at 0.
template <typename Structure>
Structure typed(VkStructureType type) {
  Structure structure{};
  structure.sType = type;
  return structure;
}

/// An object of a device that goes with its owner.
template <typename Handle, auto destroy>
class Owned {
public:
  explicit Owned(VkDevice device) : m_device(device) {}
  ~Owned() { destroy(m_device, m_handle, nullptr); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;

  Handle* operator&() { return &m_handle; }
  operator Handle() const { return m_handle; }

private:
  VkDevice m_device;
  Handle m_handle = VK_NULL_HANDLE;
};

using ShaderModule = Owned<VkShaderModule, vkDestroyShaderModule>;
using SetLayout = Owned<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using PipelineLayout = Owned<VkPipelineLayout, vkDestroyPipelineLayout>;
using RenderPass = Owned<VkRenderPass, vkDestroyRenderPass>;
using Pipeline = Owned<VkPipeline, vkDestroyPipeline>;

using Bindings = std::map<std::uint32_t, VkDescriptorSetLayoutBinding>;

/// What a shader reads, as its own words say: samplers, and the buffer of its other uniforms.
void addBindings(const Spirv& words, Bindings& bindings) {
  constexpr std::uint32_t headerWords = 5, opVariable = 59, opDecorate = 71, decorationBinding = 33;
  constexpr std::uint32_t storageUniformConstant = 0, storageUniform = 2;
  std::map<std::uint32_t, std::uint32_t> placeOf; // by the variable's id; decorations come first
  for (std::size_t at = headerWords; at < words.size(); at += std::max(words[at] >> 16, 1u)) {
    const std::uint32_t operation = words[at] & 0xffff;
    if (operation == opDecorate && words[at + 2] == decorationBinding)
      placeOf[words[at + 1]] = words[at + 3];
    if (operation != opVariable || !placeOf.contains(words[at + 2]))
      continue;
    VkDescriptorSetLayoutBinding binding{};
    binding.binding = placeOf[words[at + 2]];
    binding.descriptorCount = 1;
    binding.stageFlags = VK_SHADER_STAGE_ALL_GRAPHICS;
    if (words[at + 3] == storageUniformConstant)
      binding.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    else if (words[at + 3] == storageUniform)
      binding.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    else
      throw std::runtime_error("a shader reads what is neither a texture nor a uniform");
    bindings[binding.binding] = binding;
  }
}

void makeModule(VkDevice device, const Spirv& words, ShaderModule& module) {
  auto info = typed<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
  info.codeSize = words.size() * sizeof(std::uint32_t);
  info.pCode = words.data();
  require(vkCreateShaderModule(device, &info, nullptr, &module), "vkCreateShaderModule");
}

// Both stages share what they read: the translator gives one place to one name.
void makeLayout(VkDevice device, const Spirv& vertex, const Spirv& fragment, SetLayout& set,
                PipelineLayout& layout) {
  Bindings byPlace;
  addBindings(vertex, byPlace);
  addBindings(fragment, byPlace);
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const auto& [place, binding] : byPlace)
    bindings.push_back(binding);
  auto setInfo = typed<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
  setInfo.bindingCount = static_cast<std::uint32_t>(bindings.size());
  setInfo.pBindings = bindings.data();
  require(vkCreateDescriptorSetLayout(device, &setInfo, nullptr, &set), "vkCreateDescriptorSetLayout");
  const VkDescriptorSetLayout sets[] = {set};
  auto info = typed<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
  info.setLayoutCount = 1;
  info.pSetLayouts = sets;
  require(vkCreatePipelineLayout(device, &info, nullptr, &layout), "vkCreatePipelineLayout");
}

// A picture of floats, as PictureTarget has it: what a fragment exports is part of its program.
void makeRenderPass(VkDevice device, RenderPass& pass) {
  VkAttachmentDescription picture{};
  picture.format = VK_FORMAT_R32G32B32A32_SFLOAT;
  picture.samples = VK_SAMPLE_COUNT_1_BIT;
  picture.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  picture.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  picture.finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &reference;
  auto info = typed<VkRenderPassCreateInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO);
  info.attachmentCount = 1;
  info.pAttachments = &picture;
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  require(vkCreateRenderPass(device, &info, nullptr, &pass), "vkCreateRenderPass");
}

VkPipelineShaderStageCreateInfo stageOf(VkShaderStageFlagBits stage, VkShaderModule module) {
  auto info = typed<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
  info.stage = stage;
  info.module = module;
  info.pName = "main";
  return info;
}

void makePipeline(VkDevice device, const std::array<VkPipelineShaderStageCreateInfo, 2>& stages,
                  VkPipelineLayout layout, VkRenderPass pass, Pipeline& pipeline) {
  const VkVertexInputBindingDescription corners{0, 4 * sizeof(float), VK_VERTEX_INPUT_RATE_VERTEX};
  const VkVertexInputAttributeDescription corner{0, 0, VK_FORMAT_R32G32B32A32_SFLOAT, 0};
  auto input =
      typed<VkPipelineVertexInputStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
  input.vertexBindingDescriptionCount = 1;
  input.pVertexBindingDescriptions = &corners;
  input.vertexAttributeDescriptionCount = 1;
  input.pVertexAttributeDescriptions = &corner;
  auto assembly = typed<VkPipelineInputAssemblyStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  const VkViewport viewport{0.0f, 0.0f, 64.0f, 64.0f, 0.0f, 1.0f};
  const VkRect2D scissor{{0, 0}, {64, 64}};
  auto view = typed<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
  view.viewportCount = view.scissorCount = 1;
  view.pViewports = &viewport;
  view.pScissors = &scissor;
  auto raster = typed<VkPipelineRasterizationStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
  raster.lineWidth = 1.0f;
  auto samples =
      typed<VkPipelineMultisampleStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineColorBlendAttachmentState written{};
  written.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT |
                           VK_COLOR_COMPONENT_A_BIT;
  auto blend =
      typed<VkPipelineColorBlendStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
  blend.attachmentCount = 1;
  blend.pAttachments = &written;
  auto info = typed<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
  info.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
  info.stageCount = static_cast<std::uint32_t>(stages.size());
  info.pStages = stages.data();
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &view;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pColorBlendState = &blend;
  info.layout = layout;
  info.renderPass = pass;
  require(vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          "vkCreateGraphicsPipelines");
}

int numberOf(const VkPipelineExecutableStatisticKHR& statistic) {
  switch (statistic.format) {
  case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
    return static_cast<int>(statistic.value.i64);
  case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR:
    return static_cast<int>(statistic.value.u64);
  default:
    return 0;
  }
}

// A figure that the driver does not tell must not read as 0.
StageFigures figuresOf(const std::vector<VkPipelineExecutableStatisticKHR>& statistics) {
  std::map<std::string, int> told;
  for (const VkPipelineExecutableStatisticKHR& statistic : statistics)
    told[statistic.name] = numberOf(statistic);
  return {told.at("Instructions"),  told.at("VGPRs"),         told.at("SGPRs"),
          told.at("Spilled VGPRs"), told.at("Spilled SGPRs"), told.at("Scratch size")};
}

} // namespace

struct NullCompiler::Handles {
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice chip = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties{};
  PFN_vkGetPipelineExecutablePropertiesKHR getExecutables = nullptr;
  PFN_vkGetPipelineExecutableStatisticsKHR getStatistics = nullptr;

  ~Handles() {
    if (device != VK_NULL_HANDLE)
      vkDestroyDevice(device, nullptr);
    if (instance != VK_NULL_HANDLE)
      vkDestroyInstance(instance, nullptr);
  }

  void makeInstance();
  void findChip(const std::string& name);
  void makeDevice();
  ProgramFigures figures(VkPipeline pipeline) const;
};

void NullCompiler::Handles::makeInstance() {
  auto application = typed<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
  application.apiVersion = VK_API_VERSION_1_2;
  auto info = typed<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
  info.pApplicationInfo = &application;
  if (vkCreateInstance(&info, nullptr, &instance) != VK_SUCCESS) {
    instance = VK_NULL_HANDLE;
    throw NoCompiler("this machine has no driver of Vulkan (Debian package mesa-vulkan-drivers)");
  }
}

// Only RADV knows RADV_FORCE_FAMILY; other drivers, and true cards of theirs, are passed over.
void NullCompiler::Handles::findChip(const std::string& name) {
  std::uint32_t count = 0;
  vkEnumeratePhysicalDevices(instance, &count, nullptr);
  std::vector<VkPhysicalDevice> found(count);
  vkEnumeratePhysicalDevices(instance, &count, found.data());
  for (VkPhysicalDevice one : found) {
    vkGetPhysicalDeviceProperties(one, &properties);
    if (std::string(properties.deviceName).starts_with("Null hardware"))
      chip = one;
    if (chip != VK_NULL_HANDLE)
      return;
  }
  throw NoCompiler("no driver of this machine pretends to be " + name +
                   " (Mesa's RADV does, Debian package mesa-vulkan-drivers)");
}

void NullCompiler::Handles::makeDevice() {
  const char* const extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
  auto telling = typed<VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR);
  telling.pipelineExecutableInfo = VK_TRUE;
  const float priority = 1.0f;
  auto queue = typed<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  auto info = typed<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
  info.pNext = &telling;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = 1;
  info.ppEnabledExtensionNames = &extension;
  if (vkCreateDevice(chip, &info, nullptr, &device) != VK_SUCCESS) {
    device = VK_NULL_HANDLE;
    throw NoCompiler(std::string(properties.deviceName) + " does not tell what it makes of a program");
  }
  getExecutables = reinterpret_cast<PFN_vkGetPipelineExecutablePropertiesKHR>(
      vkGetDeviceProcAddr(device, "vkGetPipelineExecutablePropertiesKHR"));
  getStatistics = reinterpret_cast<PFN_vkGetPipelineExecutableStatisticsKHR>(
      vkGetDeviceProcAddr(device, "vkGetPipelineExecutableStatisticsKHR"));
}

ProgramFigures NullCompiler::Handles::figures(VkPipeline pipeline) const {
  auto asked = typed<VkPipelineInfoKHR>(VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR);
  asked.pipeline = pipeline;
  std::uint32_t count = 0;
  require(getExecutables(device, &asked, &count, nullptr), "vkGetPipelineExecutablePropertiesKHR");
  std::vector<VkPipelineExecutablePropertiesKHR> executables(
      count, typed<VkPipelineExecutablePropertiesKHR>(VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR));
  require(getExecutables(device, &asked, &count, executables.data()), "vkGetPipelineExecutablePropertiesKHR");
  ProgramFigures program;
  for (std::uint32_t i = 0; i < count; ++i) {
    auto executable = typed<VkPipelineExecutableInfoKHR>(VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR);
    executable.pipeline = pipeline;
    executable.executableIndex = i;
    std::uint32_t told = 0;
    require(getStatistics(device, &executable, &told, nullptr), "vkGetPipelineExecutableStatisticsKHR");
    std::vector<VkPipelineExecutableStatisticKHR> statistics(
        told, typed<VkPipelineExecutableStatisticKHR>(VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR));
    require(getStatistics(device, &executable, &told, statistics.data()),
            "vkGetPipelineExecutableStatisticsKHR");
    const bool isFragment = (executables[i].stages & VK_SHADER_STAGE_FRAGMENT_BIT) != 0;
    (isFragment ? program.fragment : program.vertex) = figuresOf(statistics);
  }
  return program;
}

NullCompiler::NullCompiler(const std::string& chip) : m_handles(std::make_unique<Handles>()) {
  // Read by RADV whenever it looks for devices. Programs are compiled, not found in a cache of the user's.
  setenv("RADV_FORCE_FAMILY", chip.c_str(), 1);
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  m_handles->makeInstance();
  m_handles->findChip(chip);
  m_handles->makeDevice();
}

NullCompiler::~NullCompiler() = default;

std::string NullCompiler::deviceName() const {
  return m_handles->properties.deviceName;
}

std::string NullCompiler::mesaVersion() const {
  const std::uint32_t version = m_handles->properties.driverVersion;
  return std::to_string(VK_VERSION_MAJOR(version)) + "." + std::to_string(VK_VERSION_MINOR(version)) + "." +
         std::to_string(VK_VERSION_PATCH(version));
}

int NullCompiler::subTexelBits() const {
  return static_cast<int>(m_handles->properties.limits.subTexelPrecisionBits);
}

ProgramFigures NullCompiler::compile(const Spirv& vertex, const Spirv& fragment) const {
  const VkDevice device = m_handles->device;
  ShaderModule vertexModule(device), fragmentModule(device);
  makeModule(device, vertex, vertexModule);
  makeModule(device, fragment, fragmentModule);
  SetLayout set(device);
  PipelineLayout layout(device);
  makeLayout(device, vertex, fragment, set, layout);
  RenderPass pass(device);
  makeRenderPass(device, pass);
  Pipeline pipeline(device);
  makePipeline(device,
               {stageOf(VK_SHADER_STAGE_VERTEX_BIT, vertexModule),
                stageOf(VK_SHADER_STAGE_FRAGMENT_BIT, fragmentModule)},
               layout, pass, pipeline);
  return m_handles->figures(pipeline);
}

} // namespace limn::test
