// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/programs_data.h"

#include "support/data_root.h"
#include "tools/run_program.h"

namespace musclewarp {

void ProgramsDataTest::SetUp() {
  root_ = DataRoot();
  if (root_.empty()) GTEST_SKIP() << kNoDataRoot;
}

nlohmann::json ProgramsDataTest::DeformFile(const std::string& scene_file,
                                            const std::string& out,
                                            const std::string& flags) {
  const ProgramRun run =
      RunCommandLine(MUSCLEWARP_DEFORM,
                     "--scene=" + scene_file + " --data_root=" + root_ +
                         " --out=" + out + " " + flags);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.errors;
  return nlohmann::json::parse(FileText(out + "/report.json"));
}

nlohmann::json ProgramsDataTest::Deform(const std::string& scene,
                                        const std::string& solver,
                                        const std::string& out,
                                        const std::string& flags) {
  return DeformFile(MUSCLEWARP_DATA_DIR "/scenes/" + scene + ".json",
                    out,
                    "--contact=none --solver=" + solver + " " + flags);
}

}  // namespace musclewarp
