# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Designs of postures, and functions fitted to their runs."""
import json

import numpy as np
import pytest

import musclewarp as mw

COUNT = 10
RANGES = {"hip_flexion_r": (0, 40), "hip_adduction_r": (-10, 10)}
SETTINGS = {"coarse_vertices": 100, "contact": "none", "fibres": 6}
OTHER = "pelvis_list"  # moves the whole hip: no muscle crosses it

PIN = f"""<PinJoint name="ground_pelvis">
        <socket_parent_frame>/ground</socket_parent_frame>
        <socket_child_frame>/bodyset/pelvis</socket_child_frame>
        <coordinates><Coordinate name="{OTHER}"/></coordinates>
      </PinJoint>"""


def scene_file(folder, design, count):
    """The embedded hip with a design in place of its motion, and with a pelvis
    that turns about the ground."""
    mw.demo_scene(folder)
    model = folder / "scene/hip.osim"
    text = model.read_text(encoding="utf-8")
    begin = text.index("<WeldJoint")
    end = text.index("</WeldJoint>") + len("</WeldJoint>")
    model.write_text(text[:begin] + PIN + text[end:], encoding="utf-8")
    path = folder / "scene/postures.json"
    scene = json.loads((folder / "scene/motion.json").read_text(encoding="utf-8"))
    scene["motion"] = {"design": design, "postures": count, "coordinates": RANGES}
    path.write_text(json.dumps(scene), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    folder = tmp_path_factory.mktemp("postures")
    return mw.read_scene(scene_file(folder, "latin_hypercube", COUNT))


@pytest.fixture(scope="module")
def run(scene):
    return mw.run(scene, **SETTINGS)


@pytest.fixture(scope="module")
def paths(run):
    return run.fit_paths()


def postures_of(run, paths):
    """The coordinates of the frames in rad, as `lengths` takes them."""
    return np.radians([[frame.coordinates.get(name, 0) for name in paths.coordinates]
                       for frame in run.frames])


def drawn(paths, beyond=0.0, count=20):
    """Postures in the range of the run, or by so much of it beyond."""
    random = np.random.default_rng(1)
    q = np.zeros((count, len(paths.coordinates)))
    path = paths[paths.names[0]]
    for name, low, high in zip(path.coordinates, path.low, path.high):
        part = random.uniform(-beyond, 1 + beyond, count)
        q[:, paths.coordinates.index(name)] = low + part * (high - low)
    return q


def differences(paths, q, step=1e-5):
    """Moment arms by central differences of lengths, mm per rad."""
    arms = np.zeros((len(q), len(paths), q.shape[1]))
    for k in range(q.shape[1]):
        move = step * np.eye(q.shape[1])[k]
        arms[:, :, k] = (paths.lengths(q - move) - paths.lengths(q + move)) / (2 * step)
    return arms


def test_a_latin_hypercube_has_one_posture_in_each_interval(scene, run):
    assert scene.design == "latin_hypercube"
    assert not scene.is_motion
    assert len(scene.poses) == COUNT
    for name, (low, high) in RANGES.items():
        values = np.array([frame.coordinates[name] for frame in run.frames])
        intervals = np.floor(COUNT * (values - low) / (high - low))
        assert sorted(intervals) == list(range(COUNT)), name


def test_a_grid_has_the_ends_of_the_ranges(tmp_path):
    scene = mw.read_scene(scene_file(tmp_path, "grid", 9))
    assert scene.design == "grid"
    assert 4 <= len(scene.poses) <= 9


def test_scenes_without_a_design_have_none():
    assert mw.demo_scene().design == ""


def test_frames_know_from_which_they_were_reached(run):
    """What lies beyond a posture follows it; -1 is the rest pose."""
    origins = [frame.reached_from for frame in run.frames]
    assert origins[0] == -1
    assert all(-1 <= origin < i for i, origin in enumerate(origins))
    assert any(origin >= 0 for origin in origins)


def test_postures_may_be_asked_for_in_any_order(scene, run):
    deformer = mw.Deformer(scene, **SETTINGS)
    for number in (COUNT - 1, 3, 0):
        frame = deformer.solve(number)
        assert frame.index == number
        assert frame.reached_from == run.frames[number].reached_from
        for name in ("psoas_major_r", "gluteus_medius_r"):
            np.testing.assert_array_equal(frame[name].points,
                                          run.frames[number][name].points)


def test_poses_that_are_no_design_were_reached_from_none(scene):
    deformer = mw.Deformer(scene, **SETTINGS)
    assert deformer.solve_alone(scene.poses[0]).reached_from is None


def test_lengths_and_arms_have_a_shape(paths):
    assert paths.names[0] == "glut_med1_r" and len(paths) == 7
    assert {*RANGES, "hip_rotation_r", OTHER} == set(paths.coordinates)
    q = drawn(paths)
    assert paths.lengths(q).shape == (20, 7)
    assert paths.inside(q).shape == (20, 7)
    assert paths.moment_arms(q).shape == (20, 7, 4)
    # One posture may be given alone.
    np.testing.assert_array_equal(paths.lengths(q[3]), paths.lengths(q)[3:4])


def test_arms_are_derivatives_of_lengths(paths):
    q = drawn(paths)
    np.testing.assert_allclose(paths.moment_arms(q), differences(paths, q),
                               atol=1e-4)


def test_a_length_is_the_sum_of_its_terms(paths):
    q = drawn(paths)
    for p, name in enumerate(paths.names):
        path = paths[name]
        assert path.name == name
        of_path = q[:, [paths.coordinates.index(c) for c in path.coordinates]]
        terms = np.prod(of_path[:, None, :] ** path.exponents, axis=2)
        np.testing.assert_allclose(terms @ path.coefficients,
                                   paths.lengths(q)[:, p], rtol=1e-9)


def test_paths_depend_on_the_coordinates_that_they_cross(paths):
    q = drawn(paths)
    other = paths.coordinates.index(OTHER)
    assert all(OTHER not in paths[name].coordinates for name in paths.names)
    assert (paths.moment_arms(q)[:, :, other] == 0).all()
    turned = q.copy()
    turned[:, other] = 0.5
    np.testing.assert_array_equal(paths.lengths(q), paths.lengths(turned))
    for name in paths.names:
        assert paths[name].figures["largest_other_arm_mm"] < 0.01


def test_functions_are_near_what_was_measured(run, paths):
    q = postures_of(run, paths)
    assert paths.inside(q).all()
    lengths, arms = paths.lengths(q), paths.moment_arms(q)
    for i, frame in enumerate(run.frames):
        for p, name in enumerate(paths.names):
            muscle = frame[paths[name].muscle]
            assert lengths[i, p] == pytest.approx(
                muscle.line_lengths[name], abs=0.2)
            for k, coordinate in enumerate(paths.coordinates):
                assert arms[i, p, k] == pytest.approx(
                    muscle.line_moment_arms[name][coordinate], abs=1)


def test_what_is_held_back_is_predicted(paths):
    for name in paths.names:
        errors = paths[name].figures["held_back"]
        assert 0 < errors["length_error_mm"]["mean"] < 0.3, name
        assert errors["length_error_mm"]["worst_frame"].startswith("run: frame_00")
        assert errors["arm_error_mm"]["mean"] <= errors["arm_error_mm"]["largest"]


def test_outside_of_the_range_functions_go_on_linearly(paths):
    path = paths["psoas_r"]
    k = path.coordinates.index("hip_flexion_r")
    column = paths.coordinates.index("hip_flexion_r")
    p = paths.names.index("psoas_r")
    end = path.high[k]
    q = np.tile(drawn(paths)[:1], (5, 1))
    q[:, column] = end + np.array([-1e-7, 1e-7, 0.1, 0.2, 0.3])
    np.testing.assert_array_equal(paths.inside(q)[:, p],
                                  [True, False, False, False, False])
    arms, lengths = paths.moment_arms(q)[:, p], paths.lengths(q)[:, p]
    np.testing.assert_allclose(arms[0], arms[1], atol=1e-3)
    np.testing.assert_allclose(arms[1:, column], arms[1, column], rtol=1e-9)
    np.testing.assert_allclose(np.diff(lengths[2:]), -0.1 * arms[2, column],
                               rtol=1e-9)
    far = drawn(paths, beyond=2)
    np.testing.assert_allclose(paths.moment_arms(far), differences(paths, far),
                               atol=1e-3)


def test_other_shapes_are_refused(paths):
    for q in (np.zeros((2, 3)), np.zeros(5), np.zeros((1, 2, 4)), 0.1, "flexed"):
        with pytest.raises(mw.InputError, match="q: is no array of postures.*4"):
            paths.lengths(q)
    with pytest.raises(KeyError, match="soleus"):
        paths["soleus"]


def test_paths_may_be_bands_of_fibres(run):
    bands = run.fit_paths(paths_per_muscle=2)
    assert bands.names == [f"{muscle}_{band}" for muscle in (
        "gluteus_medius_r", "gluteus_minimus_r", "psoas_major_r") for band in (1, 2)]
    fibres = [bands[name].figures["fibres"] for name in bands.names]
    assert min(fibres) >= 1 and sum(fibres[:2]) == SETTINGS["fibres"]
    with pytest.raises(mw.InputError, match="paths_per_muscle: is -1"):
        run.fit_paths(paths_per_muscle=-1)


def test_runs_without_a_model_have_no_functions(deformer):
    run = mw.Run(deformer)
    run.append(deformer.rest_frame)
    with pytest.raises(mw.InputError, match="run: has no model"):
        run.fit_paths()


def test_written_runs_have_the_same_functions(run, paths, tmp_path):
    run.write(tmp_path / "out", bones="once")
    again = mw.fit_paths(tmp_path / "out")
    assert again.names == paths.names
    for name in paths.names:
        np.testing.assert_array_equal(again[name].exponents, paths[name].exponents)
        np.testing.assert_allclose(again[name].coefficients,
                                   paths[name].coefficients, rtol=1e-6, atol=1e-6)
    bands = mw.fit_paths([tmp_path / "out"], paths_per_muscle=1)
    assert bands.names[-1] == "psoas_major_r_1"
    with pytest.raises(mw.InputError, match="paths_per_muscle: is -1"):
        mw.fit_paths(tmp_path / "out", paths_per_muscle=-1)
    with pytest.raises(mw.InputError, match="missing"):
        mw.fit_paths(tmp_path / "missing")


def test_the_record_is_that_of_the_program(paths):
    record = paths.record()
    assert [each["name"] for each in record["coordinates"]] == paths.coordinates
    assert {each["unit"] for each in record["coordinates"]} == {"rad"}
    assert record["frames"] == COUNT and record["frames_left_out"] == []
    psoas = record["muscles"]["psoas_r"]
    assert psoas["coefficients_mm"] == list(paths["psoas_r"].coefficients)
    assert psoas["exponents"] == paths["psoas_r"].exponents.tolist()
    assert psoas["range"]["hip_flexion_r"] == [
        paths["psoas_r"].low[1], paths["psoas_r"].high[1]]
    assert "psoas_r" in str(paths) and f"7 functions of {COUNT} frames" in str(paths)
