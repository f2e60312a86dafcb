// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/run_program.h"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "support/temp_dir.h"

namespace musclewarp {

std::string FileText(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

ProgramRun RunCommandLine(const std::string& program,
                          const std::string& arguments) {
  // Beside the folder of the test, which may be looked at for what was written.
  const std::string base = TestTempPath() + ".run";
  const int status = std::system(
      (program + " " + arguments + " >" + base + ".out 2>" + base + ".err")
          .c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          FileText(base + ".out"),
          FileText(base + ".err")};
}

}  // namespace musclewarp
