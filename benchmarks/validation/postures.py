# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Functions of the coordinates over a design of postures: errors at postures that
they do not know, and jumps of their moment arms on lines through the range."""

from table import Row, Section, commands, number, paragraphs, prose, table

LENGTH, ARM, LARGEST_ARM = 0.3, 1.0, 5.0  # mm
MICROSECONDS = 10.0


def worst(functions, value):
    """The largest value, and the path that has it."""
    name = max(functions, key=lambda path: value(functions[path]))
    return value(functions[name]), name


def rows_of(run, fit):
    """What is asked of the functions of a run, each of the worst path."""
    functions = fit["muscles"]
    usable = sum(frame["usable"] for frame in run.frames)

    def error(kind, figure):
        return worst(functions, lambda path: path["held_back"][kind][figure])

    length, of_length = error("length_error_mm", "mean")
    arm, of_arm = error("arm_error_mm", "mean")
    largest, of_largest = error("arm_error_mm", "largest")
    jumps = sum(path["lines_through_range"]["jumps"] for path in functions.values())
    what = f"{run.name}, errors at postures that functions do not know"
    return [
        Row(
            f"{run.name}: usable postures",
            "all",
            f"{usable} of {len(run.frames)} (in {len(fit['frames_doubtful'])} bones "
            "lie in each other)",
            usable == len(run.frames),
        ),
        Row(
            f"{what}: length, mean, worst path",
            f"at most {LENGTH} mm",
            f"{length:.2f} mm ({of_length})",
            length <= LENGTH,
        ),
        Row(
            f"{what}: moment arm, mean, worst path",
            f"at most {ARM:g} mm",
            f"{arm:.2f} mm ({of_arm})",
            arm <= ARM,
        ),
        Row(
            f"{what}: moment arm, largest",
            f"at most {LARGEST_ARM:g} mm",
            f"{largest:.1f} mm ({of_largest})",
            largest <= LARGEST_ARM,
        ),
        Row(
            f"{run.name}: jumps of moment arms on lines through the range",
            "none",
            number(jumps),
            jumps == 0,
        ),
        Row(
            f"{run.name}: time of all functions with their arms",
            f"at most {MICROSECONDS:g} microseconds",
            f"{fit['microseconds']:.1f} microseconds",
            fit["microseconds"] <= MICROSECONDS,
        ),
    ]


def row_of_path(name, path):
    held_back, survey = path["held_back"], path["lines_through_range"]
    errors = [
        f"{held_back[kind][figure]:.2f}"
        for kind in ("length_error_mm", "arm_error_mm")
        for figure in ("mean", "quantile_95", "largest")
    ]
    return [
        f"`{name}`",
        path["terms"],
        *errors,
        survey["jumps"],
        f"{survey['with_sign_change']} of {survey['lines']}",
    ]


def postures_section(run, fit):
    """The section on a run over a design of postures, and its fit.json."""
    rows = [row_of_path(name, path) for name, path in fit["muscles"].items()]
    text = paragraphs(
        prose(
            "Postures all over the ranges of the joints",
            "([designs of postures](motion.md#designs-of-postures)), and one polynomial",
            "for each path, whose derivatives are its moment arms",
            "([path functions](export.md#path-functions)). Errors are those at postures",
            "that a function does not know (each tenth held back in turn), mm, of arms",
            "mm per rad. Jumps and changes of sign of arms are looked for on straight",
            "lines through the range.",
        ),
        commands(
            [
                run.command,
                f"musclewarp-export --format=fit --in=OUT/{run.name} "
                f"--out=OUT/{run.name}.fit.json",
            ]
        ),
        table(
            ["path", "terms", "length, mean", "95 %", "largest", "arm, mean", "95 %",
             "largest", "jumps", "lines with a change of sign"],
            rows,
        ),
    )
    return Section("Functions over a design of postures", text, rows_of(run, fit))
