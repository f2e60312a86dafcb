// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/render/offscreen_window.h"

// GLEW must be included before every other OpenGL header.
#include <vtk_glew.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkAutoInit.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>

#include "musclewarp/base/input_error.h"

VTK_MODULE_INIT(vtkRenderingOpenGL2);
VTK_MODULE_INIT(vtkRenderingFreeType);

namespace musclewarp {
namespace {

[[noreturn]] void FailContext(const std::string& problem) {
  throw InputError("OpenGL",
                   problem,
                   "install Mesa's software renderer (Debian: libegl1 "
                   "libgl1-mesa-dri); no display is needed");
}

// Returns Mesa's display without a screen if there is one, otherwise the
// default display of the system.
EGLDisplay OpenDisplay() {
  const auto get_platform_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
          eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_platform_display != nullptr) {
    const EGLDisplay display = get_platform_display(
        EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (eglInitialize(display, nullptr, nullptr)) return display;
  }
  const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (eglInitialize(display, nullptr, nullptr)) return display;
  FailContext("there is no EGL display");
}

// VTK asks GLEW for the OpenGL functions; GLEW finds them and then fails
// because there is no X display, as intended.
class WindowWithoutX : public vtkGenericOpenGLRenderWindow {
 public:
  static WindowWithoutX* New();
  vtkTypeMacro(WindowWithoutX, vtkGenericOpenGLRenderWindow);

  void OpenGLInitContext() override {
    if (Initialized) return;
    ContextCreationTime.Modified();
    glewExperimental = GL_TRUE;
    const GLenum result = glewInit();
    GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
    if (!GlewInitValid) FailContext("its functions are not there");
    Initialized = true;
  }
};

vtkStandardNewMacro(WindowWithoutX);

}  // namespace

class OffscreenWindow::Context {
 public:
  Context() : display_(OpenDisplay()) {
    const EGLint wanted_config[] = {EGL_SURFACE_TYPE,
                                    EGL_PBUFFER_BIT,
                                    EGL_RENDERABLE_TYPE,
                                    EGL_OPENGL_BIT,
                                    EGL_NONE};
    const EGLint wanted_context[] = {
        EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglBindAPI(EGL_OPENGL_API) ||
        !eglChooseConfig(display_, wanted_config, &config, 1, &count) ||
        count == 0) {
      FailContext("EGL does not offer OpenGL");
    }
    context_ =
        eglCreateContext(display_, config, EGL_NO_CONTEXT, wanted_context);
    if (context_ == EGL_NO_CONTEXT) {
      FailContext("version 3.2 cannot be had");
    }
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
      eglDestroyContext(display_, context_);
      FailContext("it cannot draw without a screen");
    }
  }

  ~Context() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }

 private:
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

OffscreenWindow::OffscreenWindow() : context_(std::make_unique<Context>()) {
  auto window = vtkSmartPointer<WindowWithoutX>::New();
  window->SetOwnContext(false);
  window->SetIsCurrent(true);
  window->SetSupportsOpenGL(true);
  window_ = window;
}

OffscreenWindow::~OffscreenWindow() = default;

}  // namespace musclewarp
