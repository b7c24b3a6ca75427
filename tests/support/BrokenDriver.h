// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Drivers that refuse, reset or forget, beneath real code: libepoxy's pointers to the driver's functions are
/// changed and put back. One object of a class at a time.
namespace limn::test {

/// While it lives, every shader gets a line that the driver's own compiler refuses: "a line of a test".
class BrokenShaders {
public:
  BrokenShaders();
  ~BrokenShaders();
  BrokenShaders(const BrokenShaders&) = delete;
  BrokenShaders& operator=(const BrokenShaders&) = delete;
};

/// While it lives, the driver says that it was reset, as it does until a new context is made.
class ResetDriver {
public:
  ResetDriver();
  ~ResetDriver();
  ResetDriver(const ResetDriver&) = delete;
  ResetDriver& operator=(const ResetDriver&) = delete;
};

/// While it lives, every 3D texture is refused, as by a driver out of memory.
class DriverWithoutTextures {
public:
  DriverWithoutTextures();
  ~DriverWithoutTextures();
  DriverWithoutTextures(const DriverWithoutTextures&) = delete;
  DriverWithoutTextures& operator=(const DriverWithoutTextures&) = delete;
};

/// Deletes the ray caster's programs in the current context, which alone know of rays, under its hands.
void forgetRayCasterPrograms();

} // namespace limn::test
