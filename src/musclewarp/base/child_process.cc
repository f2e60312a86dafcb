// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>
#include <thread>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/stopwatch.h"

extern char** environ;

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

constexpr char kOutputFile[] = "output.txt";

// Also asked of folders of PATH that must not be searched.
bool IsExecutable(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
}

// Returns the last part of a file, as much as a message may want.
std::string EndOf(const fs::path& path) {
  constexpr std::streamoff kMost = 2000;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  if (size > kMost) file.seekg(size - kMost);
  if (size <= kMost) file.seekg(0);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string LastLine(const std::string& text) {
  const size_t end = text.find_last_not_of(" \r\n\t");
  if (end == std::string::npos) return "";
  const size_t newline = text.find_last_of('\n', end);
  const size_t begin = newline == std::string::npos ? 0 : newline + 1;
  return text.substr(begin, end + 1 - begin);
}

pid_t Start(const std::vector<std::string>& arguments, const std::string& dir) {
  std::vector<char*> argv;
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, dir.c_str());
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(
      &actions, 1, kOutputFile, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  pid_t child = 0;
  const int error =
      posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == 0) return child;
  throw InputError(arguments[0],
                   std::string("cannot be started (") + strerror(error) + ")",
                   "check the program");
}

}  // namespace

std::string ChildResult::Text() const {
  std::ostringstream text;
  if (timed_out) {
    text << "ran out of time";
  } else if (signal != 0) {
    text << "was killed by signal " << signal << " (" << strsignal(signal)
         << ")";
  } else {
    text << "ended with exit code " << exit_code;
  }
  const std::string line = LastLine(output);
  if (!line.empty()) text << ", having said \"" << line << "\"";
  return text.str();
}

std::string FindProgram(const std::string& name) {
  if (name.find('/') != std::string::npos) {
    return IsExecutable(name) ? fs::absolute(name).string() : "";
  }
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (folder.empty()) continue;
    const fs::path program = fs::path(folder) / name;
    if (!name.empty() && IsExecutable(program)) {
      return fs::absolute(program).string();
    }
  }
  return "";
}

ChildResult RunChild(const std::vector<std::string>& arguments,
                     const std::string& dir,
                     double timeout_s) {
  const Stopwatch watch;
  const pid_t child = Start(arguments, dir);
  ChildResult result;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (watch.Milliseconds() > 1e3 * timeout_s) {
      result.timed_out = true;
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  result.output = EndOf(fs::path(dir) / kOutputFile);
  return result;
}

}  // namespace musclewarp
