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

// Keeps the first error instead of printing it.
class VtkErrorCatcher : public vtkOutputWindow {
 public:
  static VtkErrorCatcher* New();
  vtkTypeMacro(VtkErrorCatcher, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override;

  // Without the source file, class and address VTK puts before it.
  std::string FirstError() const;

 private:
  std::string first_error_;
};

// While it lives, errors of VTK go to the catcher and not to stderr. Window and
// log are global to VTK, so only one scope lives at a time; others wait.
class VtkErrorScope {
 public:
  VtkErrorScope();
  ~VtkErrorScope();
  VtkErrorScope(const VtkErrorScope&) = delete;
  VtkErrorScope& operator=(const VtkErrorScope&) = delete;

  std::string FirstError() const { return catcher_->FirstError(); }

 private:
  std::lock_guard<std::mutex> lock_;
  vtkSmartPointer<vtkOutputWindow> previous_;
  int displayed_;
  vtkLogger::Verbosity verbosity_;
  vtkNew<VtkErrorCatcher> catcher_;
};

}  // namespace musclewarp
