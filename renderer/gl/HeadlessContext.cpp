// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/HeadlessContext.h"

#include "scene/basics/Error.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace limn {
namespace {

[[noreturn]] void refuse(const Message& what) {
  throw Error(Error::Kind::openGl,
              Message::tr("No OpenGL without a display: %1. Install the packages libegl1 and libgl1-mesa-dri "
                          "(or the graphics card's driver), or use --engine cpu.")
                  .arg(what));
}

// Mesa's surfaceless platform where it exists, otherwise the first EGL device (drivers of graphics cards).
EGLDisplay openDisplay() {
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    const EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr))
      return display;
  }
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
      epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (eglQueryDevicesEXT(1, &device, &count) && count > 0) {
      const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
      if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr))
        return display;
    }
  }
  const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr))
    return display;
  refuse(Message::tr("no EGL display could be opened"));
}

// Where it can, the driver tells of its resets instead of drawing nothing from then on.
EGLContext makeContext(EGLDisplay display, EGLConfig config) {
  if (epoxy_has_egl_extension(display, "EGL_EXT_create_context_robustness")) {
    const EGLint robust[] = {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT,
                             EGL_LOSE_CONTEXT_ON_RESET_EXT, EGL_NONE};
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, robust);
    if (context != EGL_NO_CONTEXT)
      return context;
  }
  return eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
}

} // namespace

struct HeadlessContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

HeadlessContext::HeadlessContext() : m_handles(std::make_unique<Handles>()) {
  m_handles->display = openDisplay();
  if (!epoxy_has_egl_extension(m_handles->display, "EGL_KHR_surfaceless_context"))
    refuse(Message::tr("the driver cannot draw without a surface"));
  if (!eglBindAPI(EGL_OPENGL_API))
    refuse(Message::tr("the driver offers OpenGL ES only"));
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(m_handles->display, wanted, &config, 1, &count) || count < 1)
    refuse(Message::tr("the driver has no configuration for OpenGL"));
  m_handles->context = makeContext(m_handles->display, config);
  if (m_handles->context == EGL_NO_CONTEXT)
    refuse(Message::tr("the driver could not make an OpenGL context"));
  if (!eglMakeCurrent(m_handles->display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_handles->context)) {
    eglDestroyContext(m_handles->display, m_handles->context);
    refuse(Message::tr("the OpenGL context could not be made current"));
  }
}

// The display stays open: terminating it would end every other context of the process.
HeadlessContext::~HeadlessContext() {
  eglMakeCurrent(m_handles->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(m_handles->display, m_handles->context);
}

std::string rendererName() {
  const GLubyte* name = glGetString(GL_RENDERER);
  return name ? reinterpret_cast<const char*>(name) : "unknown";
}

} // namespace limn
