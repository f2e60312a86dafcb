// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <vtkSmartPointer.h>

class vtkRenderWindow;

namespace musclewarp {

// A window of VTK that draws into memory, for machines without a display. The
// OpenGL context comes from EGL; a graphics card is not needed, as Mesa's
// software renderer is sufficient. (The windows of VTK itself, as Debian builds
// it, need an X server.)
class OffscreenWindow {
 public:
  // Makes the context current in the calling thread, for as long as the window
  // lives; there may be one window at a time. Throws InputError if the machine
  // offers no OpenGL 3.2.
  OffscreenWindow();
  ~OffscreenWindow();
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  // Returns the window, which this object owns.
  vtkRenderWindow* get() const { return window_; }

 private:
  class Context;
  // Declared in this order because the window, which is destroyed first, frees
  // what it holds in the context.
  std::unique_ptr<Context> context_;
  vtkSmartPointer<vtkRenderWindow> window_;
};

}  // namespace musclewarp
