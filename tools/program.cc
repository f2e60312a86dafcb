// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/program.h"

#include <gflags/gflags.h>
#include <glog/logging.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "musclewarp/base/input_error.h"
#include "musclewarp/build_info/build_info.h"
#include "musclewarp/deformer/length_options.h"

DECLARE_bool(help);
DECLARE_bool(helpshort);
DECLARE_bool(version);

namespace GFLAGS_NAMESPACE {
// gflags calls this after it has printed what is wrong with a flag. The library
// exports it, but does not declare it in a header.
extern void (*gflags_exitfunc)(int);
}  // namespace GFLAGS_NAMESPACE

namespace musclewarp {
namespace {

// Flags of the libraries underneath (glog, gflags) are left out: a user of the
// program has no use for them.
void PrintHelp(const std::string& usage) {
  std::cout << "usage: " << usage
            << "\n\nFlags (--flagfile=F reads them from a "
            << "file):\n";
  std::vector<gflags::CommandLineFlagInfo> flags;
  gflags::GetAllFlags(&flags);
  for (const auto& flag : flags) {
    if (flag.filename.find("tools/") == std::string::npos) continue;
    std::cout << "  --" << flag.name;
    if (flag.type != "bool") {
      std::cout << "=" << (flag.type == "string" ? "TEXT" : "NUMBER");
    }
    std::cout << "\n      " << flag.description;
    if (flag.type == "double") {
      // gflags has all digits, as in 0.10000000000000001.
      std::cout << " [" << std::stod(flag.default_value) << "]";
    } else if (!flag.default_value.empty()) {
      std::cout << " [" << flag.default_value << "]";
    }
    std::cout << "\n";
  }
}

// Has OpenMP threads sleep while they wait for each other, after some thousand
// instructions, unless the user has set OMP_WAIT_POLICY. By default they spin
// for milliseconds, which costs several times as much as it saves on a machine
// that is busy otherwise; sleeping at once costs a twentieth of a frame.
//
// The program executes itself again because there is no other way: OpenMP takes
// its wait policy from the environment alone (no routine sets it), and libgomp
// reads the environment when it is loaded, before any code of the program runs.
// If execv fails, the program goes on with the default.
void WaitPassively(char** argv) {
  if (std::getenv("OMP_WAIT_POLICY")) return;
  setenv("OMP_WAIT_POLICY", "passive", /*overwrite=*/1);
  setenv("GOMP_SPINCOUNT", "1000", /*overwrite=*/0);
  execv("/proc/self/exe", argv);
}

}  // namespace

int RunProgram(
    int argc,
    char** argv,
    const std::string& usage,
    const std::function<int(const std::vector<std::string>&)>& command) {
  WaitPassively(argv);
  const std::string name = std::filesystem::path(argv[0]).filename().string();
  FLAGS_logtostderr = true;  // no log files
  FLAGS_log_prefix = false;
  google::InitGoogleLogging(argv[0]);
  gflags::SetVersionString(VersionText());
  GFLAGS_NAMESPACE::gflags_exitfunc = [](int) { std::exit(kExitBadInput); };
  gflags::ParseCommandLineNonHelpFlags(&argc, &argv, /*remove_flags=*/true);
  if (FLAGS_help || FLAGS_helpshort) {
    PrintHelp(usage);
    return kExitUsable;
  }
  if (FLAGS_version) {
    std::cout << name << " " << VersionText() << "\n";
    return kExitUsable;
  }
  try {
    return command(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const InputError& error) {
    std::cerr << name << ": " << error.what() << "\n";
    return kExitBadInput;
  }
}

std::set<std::string> LengthsGiven() {
  std::set<std::string> given;
  for (const std::string& name : LengthsThatCanBeAskedFor()) {
    gflags::CommandLineFlagInfo flag;
    if (gflags::GetCommandLineFlagInfo(name.c_str(), &flag) &&
        !flag.is_default) {
      given.insert(name);
    }
  }
  return given;
}

void CheckThreads(int threads) {
  constexpr int kMostThreads = 1024;
  if (threads >= 0 && threads <= kMostThreads) return;
  throw InputError("--threads",
                   "is " + std::to_string(threads),
                   "allowed: 0 (all cores) to " + std::to_string(kMostThreads));
}

void RefuseArguments(const std::vector<std::string>& arguments) {
  if (arguments.empty()) return;
  throw InputError(arguments[0], "is not a flag", "see --help");
}

}  // namespace musclewarp
