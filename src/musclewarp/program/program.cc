// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/program/program.h"

#include <gflags/gflags.h>
#include <glog/logging.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/setting_names.h"
#include "musclewarp/base/threads.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/program/flag_names.h"
#include "musclewarp/program/flags.h"
#include "musclewarp/program/help.h"
#include "musclewarp/settings/checked_settings.h"

DECLARE_bool(version);

namespace GFLAGS_NAMESPACE {
// gflags calls this after it has printed what is wrong with a flag. The library
// exports it, but does not declare it in a header.
extern void (*gflags_exitfunc)(int);
}  // namespace GFLAGS_NAMESPACE

namespace musclewarp {
namespace {

// Makes threads of OpenMP sleep while they wait for each other, after some
// thousand instructions, unless the user has set OMP_WAIT_POLICY. By default
// they spin for milliseconds, which costs several times as much as it saves on
// a machine with other work; sleeping at once costs a twentieth of a frame.
//
// The program executes itself again because there is no other way: OpenMP takes
// its wait policy from the environment alone (no routine sets it), and libgomp
// reads the environment when it is loaded, before any code of the program runs.
// If execv fails, the program continues with the default.
void WaitPassively(char** argv) {
  if (std::getenv("OMP_WAIT_POLICY")) return;
  setenv("OMP_WAIT_POLICY", "passive", /*overwrite=*/1);
  setenv("GOMP_SPINCOUNT", "1000", /*overwrite=*/0);
  execv("/proc/self/exe", argv);
}

// Prints log messages to the screen, with settings named as flags.
class ScreenLog : public google::LogSink {
 public:
  void send(google::LogSeverity severity,
            const char* /*full_filename*/,
            const char* /*base_filename*/,
            int /*line*/,
            const google::LogMessageTime& /*time*/,
            const char* message,
            size_t length) override {
    if (severity == google::GLOG_FATAL) return;  // glog prints it itself
    std::cerr << WithFlags(std::string(message, length)) + "\n";
  }
};

int PrintBadInput(const std::string& program, const InputError& error) {
  std::cerr << program << ": " << error.WithFlags() << "\n";
  return kExitBadInput;
}

// What a look at a file throws if it cannot be told whether it is there.
InputError InputErrorOf(const std::filesystem::filesystem_error& error) {
  return InputError(error.path1().string(),
                    "cannot be reached (" + error.code().message() + ")",
                    "check the name, and the rights of its folders");
}

void LogToScreen(const char* program) {
  for (int severity = 0; severity < google::NUM_SEVERITIES; ++severity) {
    google::SetLogDestination(severity, "");  // no log files
  }
  FLAGS_stderrthreshold = google::GLOG_FATAL;
  google::InitGoogleLogging(program);
  // Never destroyed, because messages may be logged while the process ends.
  google::AddLogSink(new ScreenLog);
}

}  // namespace

int RunProgram(
    int argc,
    char** argv,
    const ProgramText& text,
    const std::function<int(const std::vector<std::string>&)>& command) {
  WaitPassively(argv);
  const std::string name = std::filesystem::path(argv[0]).filename().string();
  LogToScreen(argv[0]);
  gflags::SetVersionString(VersionText());
  GFLAGS_NAMESPACE::gflags_exitfunc = [](int) { std::exit(kExitBadInput); };
  try {
    if (AsksForHelp(argc, argv)) {
      PrintHelp(text, ProgramFlags(), std::cout);
      return kExitUsable;
    }
    if (AsksForShortHelp(argc, argv)) {
      PrintShortHelp(text, ProgramFlags(), std::cout);
      return kExitUsable;
    }
    CheckNamesOfFlags({argv + 1, argv + argc});
    CheckTypesOfFlags(argc, argv);
    gflags::ParseCommandLineNonHelpFlags(&argc, &argv, /*remove_flags=*/true);
    if (FLAGS_version) {
      std::cout << name << " " << VersionText() << "\n";
      return kExitUsable;
    }
    return command(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const InputError& error) {
    return PrintBadInput(name, error);
  } catch (const std::filesystem::filesystem_error& error) {
    return PrintBadInput(name, InputErrorOf(error));
  }
}

void UseThreads(const ThreadSettings& settings) {
  CheckSettings<ThreadSettings>(settings);
  if (settings.threads > 0) SetNumThreads(settings.threads);
}

void RefuseArguments(const std::vector<std::string>& arguments) {
  if (arguments.empty()) return;
  throw InputError(arguments[0], "is not a flag", "see {help}");
}

}  // namespace musclewarp
