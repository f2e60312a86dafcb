#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""scripts/setup.sh installs what is missing, and says what a release does not have.

The programs of apt are played by scripts; nothing is installed.
"""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]

# What is installed, and what apt offers, a package and version a line, are files
# beside the programs.
PROGRAMS = {
    "dpkg-query": 'sed "s/ .*/=installed/" "$0.txt"',
    "apt-cache": '''shift
for package in "$@"; do
  offer=$(sed -n "s/^$package //p" "$0.txt")
  [ -n "$offer" ] && printf "%s:\\n  Candidate: %s\\n" "$package" "$offer"
done''',
    "apt-get": '''case "$*" in
  indextargets*) cat "$0.lists" ;;
  *install*) printf "%s\\n" "$@" >"$0.installed"
    sed "s/$/ 1/" "$0.installed" >>"${0%/*}/dpkg-query.txt" ;;
esac''',
    "id": "echo 0",
    "node": "true",
    "npm": "true",
}


def listed(group):
    """The packages of a group, but for Node.js, which is played."""
    said = subprocess.run([SOURCE / "scripts/setup.sh", "--list", group], check=True,
                          text=True, capture_output=True).stdout
    return [name for name in said.split() if name not in ("nodejs", "npm")]


class SetupTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.packages = listed("build")
        cls.all_packages = listed("test")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.bin = pathlib.Path(folder.name)
        for name, text in PROGRAMS.items():
            (self.bin / name).write_text(f"#!/bin/sh\n{text}\n")
            (self.bin / name).chmod(0o755)
        self.offers = dict.fromkeys(self.all_packages, "99:99.0-1")
        self.installed = []
        (self.bin / "apt-get.lists").write_text("a list\n")

    def setup(self, *arguments):
        environment = dict(os.environ, PATH=f"{self.bin}:{os.environ['PATH']}")
        return subprocess.run([SOURCE / "scripts/setup.sh", *arguments], text=True,
                              capture_output=True, env=environment)

    def run_setup(self, *arguments):
        """What setup.sh says and installs."""
        (self.bin / "dpkg-query.txt").write_text(
            "".join(f"{package} 1\n" for package in self.installed))
        (self.bin / "apt-cache.txt").write_text(
            "".join(f"{package} {version}\n"
                    for package, version in self.offers.items()))
        record = self.bin / "apt-get.installed"
        record.unlink(missing_ok=True)
        run = self.setup(*arguments)
        new = record.read_text().split() if record.exists() else []
        return run, [package for package in new if package in self.packages
                     or package in self.offers]

    def test_installs_what_is_missing_and_says_how_long_it_takes(self):
        self.installed = ["g++", "cmake"]
        run, new = self.run_setup("build")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(sorted(new + self.installed), sorted(self.packages))
        self.assertIn(f"{len(new)} packages are missing", run.stdout)
        self.assertIn("one to three minutes", run.stdout)
        self.assertIn("setup: done", run.stdout)

    def test_says_nothing_if_nothing_is_missing(self):
        self.installed = self.packages
        run, new = self.run_setup("build")
        self.assertEqual((run.returncode, run.stdout, new), (0, "", []))

    def test_a_needed_package_that_is_not_there_ends_it(self):
        del self.offers["libcereal-dev"]
        run, new = self.run_setup("build")
        self.assertEqual((run.returncode, new), (1, []))
        self.assertIn("libcereal-dev is not in this release (the cache of "
                      "preparations)", run.stderr)
        self.assertIn("docs/install.md", run.stderr)

    def test_a_needed_package_that_is_too_old_ends_it(self):
        self.offers.update({"libcgal-dev": "5.4-1", "nlohmann-json3-dev": "3.10.5-2",
                            "libpugixml-dev": "1.12.1-1", "cmake": "3.22.1-1ubuntu1"})
        run, new = self.run_setup("build")
        self.assertEqual((run.returncode, new), (1, []))
        self.assertIn("libcgal-dev is 5.4-1 in this release, and 5.5 is needed",
                      run.stderr)
        self.assertIn("nlohmann-json3-dev is 3.10.5-2", run.stderr)
        self.assertNotIn("pugixml", run.stderr)
        self.assertNotIn("cmake is", run.stderr)

    def test_vtk_is_left_out_with_the_command_that_builds_without_it(self):
        del self.offers["libvtk9-dev"]
        run, new = self.run_setup("build")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotIn("libvtk9-dev", new)
        self.assertIn("libegl-dev", new)
        self.assertIn("libvtk9-dev is not in this release (.vtp files, label images, "
                      "pictures): left out", run.stdout)
        self.assertIn("-DMUSCLEWARP_WITH_VTK=OFF", run.stdout)

    def test_what_cannot_be_had_needs_no_root_again(self):
        self.installed = [package for package in self.offers if package != "chromium"]
        del self.offers["chromium"]
        (self.bin / "id").write_text("#!/bin/sh\necho 1000\n")
        (self.bin / "sudo").write_text("#!/bin/sh\nexit 1\n")
        (self.bin / "sudo").chmod(0o755)
        run, new = self.run_setup("test")
        self.assertEqual((run.returncode, run.stderr, new), (0, "", []))
        self.assertIn("chromium is not in this release", run.stdout)

    def test_tools_of_checks_are_left_out_where_there_are_none(self):
        self.installed = self.packages
        run, new = self.run_setup("build", "checks")
        self.assertEqual((run.returncode, new), (0, []))
        self.assertIn("clang-format-14 is not in this release (the check of the "
                      "format): left out", run.stdout)

    def test_every_version_that_is_asked_for_is_found(self):
        self.offers = dict.fromkeys(self.offers, "0.1-1")
        run, _ = self.run_setup("test")
        for package in ("cmake", "libeigen3-dev", "libceres-dev", "libcgal-dev",
                        "nlohmann-json3-dev", "libpugixml-dev", "python3-dev",
                        "pybind11-dev"):
            self.assertRegex(run.stderr, rf"{package} is 0.1-1 in this release, "
                             r"and [0-9.]+ is needed")

    def test_check_installs_nothing(self):
        run, new = self.run_setup("--check", "build")
        self.assertEqual((run.returncode, new), (1, []))
        self.assertIn("setup: missing: g++ cmake", run.stdout)


if __name__ == "__main__":
    if not shutil.which("dpkg"):
        print("skipped: no dpkg, which compares versions")
        raise SystemExit(77)
    unittest.main()
