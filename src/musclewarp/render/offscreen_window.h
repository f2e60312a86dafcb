// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <vtkSmartPointer.h>

class vtkRenderWindow;

namespace musclewarp {

// A window that draws into memory through EGL: neither a display nor a
// graphics card is needed, Mesa's software renderer will do. (The windows of
// VTK itself, as Debian builds it, want an X server.)
class OffscreenWindow {
 public:
  // Its OpenGL context is current in the calling thread until the window is
  // gone; one at a time. Throws InputError if the machine offers no OpenGL 3.2.
  OffscreenWindow();
  ~OffscreenWindow();
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  vtkRenderWindow* get() const { return window_; }

 private:
  class Context;
  // In this order: the window frees what it holds in the context.
  std::unique_ptr<Context> context_;
  vtkSmartPointer<vtkRenderWindow> window_;
};

}  // namespace musclewarp
