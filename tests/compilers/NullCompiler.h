// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

/// The compiler of a graphics card without the card: Mesa's RADV pretends to be any AMD chip and compiles for
/// it.
namespace limn::test {

/// A shader as Vulkan takes it.
using Spirv = std::vector<std::uint32_t>;

/// What the compiler made of one stage of a program.
struct StageFigures {
  int instructions = 0;
  int vgprs = 0; ///< registers that each fragment has to itself
  int sgprs = 0; ///< registers that the fragments drawn together share
  int spilledVgprs = 0;
  int spilledSgprs = 0;
  int scratchBytes = 0; ///< memory in the place of registers

  bool spillsNothing() const { return spilledVgprs == 0 && spilledSgprs == 0 && scratchBytes == 0; }
};

struct ProgramFigures {
  StageFigures vertex;
  StageFigures fragment;
};

/// This machine has no such compiler; says what it lacks.
class NoCompiler : public std::runtime_error {
  using runtime_error::runtime_error;
};

/// The compiler for one chip.
class NullCompiler {
public:
  /// A chip as Mesa's RADV_FORCE_FAMILY names it, such as "navi21". Throws NoCompiler.
  explicit NullCompiler(const std::string& chip);
  ~NullCompiler();

  /// What the driver calls its device, and the version of Mesa that it belongs to, such as "22.3.6".
  std::string deviceName() const;
  std::string mesaVersion() const;

  /// In how many bits the chip's samplers weigh texels.
  int subTexelBits() const;

  /// Compiles a program whose only attribute is a vector at 0 and whose output is a picture of floats. Throws
  /// std::runtime_error where the compiler refuses it.
  ProgramFigures compile(const Spirv& vertex, const Spirv& fragment) const;

private:
  struct Handles;
  std::unique_ptr<Handles> m_handles;
};

} // namespace limn::test
