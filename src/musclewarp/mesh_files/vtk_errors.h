// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <mutex>
#include <string>

namespace musclewarp {

// VTK reports errors by printing them. The two classes below turn that into a
// text that can be put into an InputError: VtkErrorScope is what code uses, and
// VtkErrorCatcher is the window that it gives to VTK.

// Keeps the first error and drops all other output of VTK.
class VtkErrorCatcher : public vtkOutputWindow {
 public:
  static VtkErrorCatcher* New();
  vtkTypeMacro(VtkErrorCatcher, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override;

  // Returns the first line of the first error without the source file, class
  // and address that VTK puts before it; "" if there was none.
  std::string FirstError() const;

 private:
  std::string first_error_;
};

// As long as it lives, errors of VTK go to a catcher and not to stderr. The
// output window and the log are global to VTK, so only one scope lives at a
// time: a thread that opens another waits for the first to end.
class VtkErrorScope {
 public:
  VtkErrorScope();
  ~VtkErrorScope();
  VtkErrorScope(const VtkErrorScope&) = delete;
  VtkErrorScope& operator=(const VtkErrorScope&) = delete;

  // Returns the first error since the scope began, "" if there was none.
  std::string FirstError() const { return catcher_->FirstError(); }

 private:
  std::lock_guard<std::mutex> lock_;
  vtkSmartPointer<vtkOutputWindow> previous_;
  int displayed_;
  vtkLogger::Verbosity verbosity_;
  vtkNew<VtkErrorCatcher> catcher_;
};

}  // namespace musclewarp
