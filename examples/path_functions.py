# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""A moment arm over two coordinates, from functions that are fitted to a run.

usage: path_functions.py [--run=DIR] [--path=NAME] [--arm=COORDINATE]
                         [--over=COORDINATE] [--postures=N] [--plot=FILE.png]

Without a run it deforms the hip that is inside the package in a few postures.
"""
import argparse
import json
import pathlib
import tempfile

import numpy as np

import musclewarp as mw

RANGES = {"hip_flexion_r": [0, 40], "hip_adduction_r": [-10, 10]}  # degrees


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--run", metavar="DIR",
                        help="run of musclewarp-deform [the hip inside the package]")
    parser.add_argument("--path", metavar="NAME", help="line of a muscle [the last]")
    parser.add_argument("--arm", metavar="COORDINATE",
                        help="about which the arm is [that of the widest range]")
    parser.add_argument("--over", metavar="COORDINATE",
                        help="the other one [that of the second widest range]")
    parser.add_argument("--postures", type=int, metavar="N", default=12,
                        help="of the hip inside the package [12]")
    parser.add_argument("--plot", metavar="FILE.png",
                        help="surface; needs matplotlib [a table is printed]")
    return parser.parse_args()


def fit_demo(count):
    """Functions of the hip inside the package, in a design of postures."""
    with tempfile.TemporaryDirectory() as folder:
        mw.demo_scene(folder)
        files = pathlib.Path(folder) / "scene"
        scene = json.loads((files / "motion.json").read_text())
        scene["motion"] = {"design": "latin_hypercube", "postures": count,
                           "coordinates": RANGES}
        (files / "postures.json").write_text(json.dumps(scene))
        run = mw.run(mw.read_scene(files / "postures.json"), coarse_vertices=100)
    return run.fit_paths()


def widest(path):
    """The coordinates of a path, those of the widest range first."""
    order = np.argsort(path.low - path.high, kind="stable")
    return [path.coordinates[k] for k in order]


def values_of(path, coordinate, count):
    """Values over the range of a coordinate, rad or m."""
    k = path.coordinates.index(coordinate)
    return np.linspace(path.low[k], path.high[k], count)


def arms_over(paths, path, about, over, count):
    """The arm about a coordinate on a grid over it and another one, mm per rad
    or m. Others are in the middle of their ranges."""
    across, along = np.meshgrid(values_of(path, about, count),
                                values_of(path, over, count), indexing="ij")
    q = np.zeros((across.size, len(paths.coordinates)))
    for name, low, high in zip(path.coordinates, path.low, path.high):
        q[:, paths.coordinates.index(name)] = (low + high) / 2
    q[:, paths.coordinates.index(about)] = across.ravel()
    q[:, paths.coordinates.index(over)] = along.ravel()
    arms = paths.moment_arms(q)[:, paths.names.index(path.name),
                                paths.coordinates.index(about)]
    return across, along, arms.reshape(across.shape)


def shown(paths, coordinate, values):
    """The unit of a coordinate on paper, and the values in it."""
    units = {each["name"]: each["unit"] for each in paths.record()["coordinates"]}
    if units[coordinate] == "rad":
        return "degrees", np.degrees(values)
    return "m", values


options = parse()
if options.plot:
    try:
        from matplotlib import pyplot
    except ImportError:
        raise SystemExit("--plot needs matplotlib: pip install matplotlib")
paths = mw.fit_paths(options.run) if options.run else fit_demo(options.postures)
print(paths, end="")
path = paths[options.path or paths.names[-1]]
about = options.arm or widest(path)[0]
over = options.over or [name for name in widest(path) if name != about][0]
title = f"moment arm of {path.name} about {about}, mm"
across, along, arms = arms_over(paths, path, about, over,
                                40 if options.plot else 5)
unit, across = shown(paths, about, across)
other_unit, along = shown(paths, over, along)
if options.plot:
    axes = pyplot.figure(figsize=(7, 6)).add_subplot(projection="3d")
    axes.plot_surface(across, along, arms, cmap="viridis")
    axes.set_xlabel(f"{about}, {unit}")
    axes.set_ylabel(f"{over}, {other_unit}")
    axes.set_title(title)
    pyplot.savefig(options.plot, dpi=150)
    print(f"wrote {options.plot}")
else:
    print(f"{title}; down: {about}, {unit}; across: {over}, {other_unit}")
    print("        " + "".join(f"{value:8.1f}" for value in along[0]))
    for value, row in zip(across[:, 0], arms):
        print(f"{value:8.1f}" + "".join(f"{arm:8.1f}" for arm in row))
