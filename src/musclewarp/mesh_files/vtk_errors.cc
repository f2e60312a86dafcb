// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/vtk_errors.h"

#include <vtkObjectFactory.h>

namespace musclewarp {
namespace {

std::mutex& ScopeMutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

vtkStandardNewMacro(VtkErrorCatcher);

void VtkErrorCatcher::DisplayErrorText(const char* text) {
  if (first_error_.empty()) first_error_ = text;
}

std::string VtkErrorCatcher::FirstError() const {
  const std::size_t begin = first_error_.find("): ");
  const std::string text = begin == std::string::npos
                               ? first_error_
                               : first_error_.substr(begin + 3);
  return text.substr(0, text.find_first_of("\r\n"));
}

VtkErrorScope::VtkErrorScope()
    : lock_(ScopeMutex()),
      previous_(vtkOutputWindow::GetInstance()),
      displayed_(vtkObject::GetGlobalWarningDisplay()),
      verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(catcher_);
  vtkObject::GlobalWarningDisplayOn();
}

VtkErrorScope::~VtkErrorScope() {
  vtkOutputWindow::SetInstance(previous_);
  vtkObject::SetGlobalWarningDisplay(displayed_);
  vtkLogger::SetStderrVerbosity(verbosity_);
}

}  // namespace musclewarp
