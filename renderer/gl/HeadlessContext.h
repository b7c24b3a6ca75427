// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

namespace limn {

/// An OpenGL context without window or display (EGL surfaceless), current on the calling thread while it
/// lives. Throws Error (openGl) with what to install where there is none.
class HeadlessContext {
public:
  HeadlessContext();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

private:
  struct Handles;
  std::unique_ptr<Handles> m_handles;
};

/// The renderer string of the current context, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
std::string rendererName();

} // namespace limn
