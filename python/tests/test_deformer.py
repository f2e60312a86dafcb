# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Deformers: results, options, progress, threads."""
import inspect
import threading
import time

import numpy as np
import pytest

import musclewarp as mw
from musclewarp import _core
from conftest import muscle, pushed, quick, small_scene, spindle


def test_muscles_give_way_and_keep_their_volume(deformer):
    frame = deformer.move_to(pushed(10))  # 4 mm into the iliacus
    assert frame.usable, frame
    assert frame.crossing_pairs == 0
    iliacus = frame["iliacus"]
    assert iliacus.max_bone_push + iliacus.max_contact_displacement > 1
    # What both solvers and contact keep the volume to.
    assert frame.worst_volume_error < 2e-8
    assert frame.smallest_gap >= 0.1


def test_bones_move_with_their_bodies(deformer):
    frame = deformer.solve_alone(pushed(5))
    expected = deformer.rest_frame["femur"].points - (5, 0, 0)
    np.testing.assert_allclose(frame["femur"].points, expected, atol=1e-12)


def test_a_frame_on_its_own_does_not_depend_on_others(deformer):
    first = deformer.solve_alone(pushed(8))
    deformer.move_to(pushed(3))
    second = deformer.solve_alone(pushed(8))
    for name in ("psoas", "iliacus"):
        np.testing.assert_array_equal(first[name].points, second[name].points)


def test_goes_on_from_a_state_that_is_put_back(deformer):
    deformer.reset()
    deformer.move_to(pushed(5))
    state = deformer.state
    first = deformer.move_to(pushed(8))
    deformer.state = state
    second = deformer.move_to(pushed(8))
    np.testing.assert_array_equal(first["psoas"].points,
                                  second["psoas"].points)


def test_a_state_of_another_deformer_is_refused(deformer):
    with pytest.raises(mw.InputError, match="another deformer"):
        quick().state = deformer.state


def test_the_scene_is_copied():
    scene = small_scene()
    deformer = quick(scene)
    scene.muscles.clear()
    assert "psoas" in deformer.move_to(pushed(1))


def test_threads_make_no_difference(deformer):
    expected = deformer.solve_alone(pushed(8))["iliacus"].points
    assert mw.threads() == 0
    mw.set_threads(1)
    try:
        alone = deformer.solve_alone(pushed(8))["iliacus"].points
    finally:
        mw.set_threads(0)
    np.testing.assert_array_equal(alone, expected)


@pytest.mark.parametrize("threads", [-1, 1025])
def test_other_numbers_of_threads_are_refused(threads):
    with pytest.raises(mw.InputError, match="threads: is .*allowed: 0"):
        mw.set_threads(threads)


@pytest.mark.parametrize("choice, words", [
    ({"gap": 0}, "gap is 0|gap: is 0"),
    ({"gap": 1}, "gap: is 1.*at most 0.5"),
    ({"gap": float("nan")}, "gap"),
    ({"gap": "wide"}, "gap: is 'wide'; allowed: a number"),
    ({"contact": "rubber"}, "contact=rubber.*certified, paper, none"),
    ({"contact": 3}, "contact: is 3; allowed: a text"),
    ({"coarse_vertices": 5}, "coarse_vertices: is 5; allowed: 20 to 5000"),
    ({"coarse_vertices": 60.5}, "coarse_vertices: is 60.5; allowed: a whole"),
    ({"max_iterations": 0}, "max_iterations: is 0"),
    ({"seed": -1}, "seed: is -1; allowed: a whole number"),
    ({"solver": "newton"}, "solver=newton"),
    ({"max_step_turn": 0}, "max_step_turn"),
])
def test_values_that_are_not_allowed_name_the_keyword(choice, words):
    with pytest.raises(mw.InputError, match=words):
        mw.Deformer(small_scene(), **choice)


def test_an_equal_deformer_is_read_from_the_cache(tmp_path):
    def points_and_origin(**choices):
        deformer = quick(cache=tmp_path / "cache", **choices)
        run = mw.Run(deformer)
        run.append(deformer.move_to(pushed(2)))
        return (run.frames[0]["psoas"].points,
                run.report()["prepare"]["cached"])

    first, is_first_cached = points_and_origin()
    second, is_second_cached = points_and_origin()
    assert (is_first_cached, is_second_cached) == (False, True)
    assert np.array_equal(first, second)
    assert not points_and_origin(gap=0.2)[1]


def test_keywords_are_those_of_the_library_with_its_defaults():
    parameters = inspect.signature(mw.Deformer).parameters
    keywords = {
        name: parameter.default
        for name, parameter in parameters.items()
        if name not in ("scene", "progress")
    }
    assert keywords == _core.default_settings["DeformerSettings"]


@pytest.mark.parametrize("pose, words", [
    (mw.Pose("bent", bodies={"tibia": np.eye(4)}), '"tibia".*bodies in use'),
    (mw.Pose("bent", lines={"psoas": [(0, 0, 0)]}), "has 1 points.*has 2"),
    (mw.Pose("bent", lines={"soleus": [(0, 0, 0)]}), "no muscle has such"),
])
def test_poses_that_contradict_the_scene_are_refused(deformer, pose, words):
    for solve in (deformer.move_to, deformer.solve_alone):
        with pytest.raises(mw.InputError, match=words):
            solve(pose)


def test_scenes_that_contradict_themselves_are_refused():
    scene = small_scene()
    scene.muscles.append(scene.muscles[0])
    with pytest.raises(mw.InputError, match='the scene: the name "psoas"'):
        quick(scene)
    with pytest.raises(mw.InputError, match="psoas"):
        points, triangles = spindle(0)
        quick(mw.Scene([mw.Muscle("psoas", points, triangles[:100])]))


def test_what_is_no_pose_or_scene_is_a_type_error(deformer):
    with pytest.raises(TypeError):
        deformer.move_to({"femur": np.eye(4)})
    with pytest.raises(AttributeError):
        mw.Deformer([muscle("psoas", 0)])


def test_progress_is_told_and_may_stop_the_computation(deformer):
    told = []
    quick(progress=lambda *args: told.append(args))
    assert {stage for stage, _, _ in told} >= {"preparing"}
    assert all(0 <= done and (done <= total or not total)
               for _, done, total in told)

    class Enough(Exception):
        pass

    def stop(stage, done, total):
        if is_over:
            raise Enough

    is_over = False
    stoppable = quick(progress=stop)
    expected = stoppable.move_to(pushed(3))["psoas"].points
    state = stoppable.state
    is_over = True
    with pytest.raises(Enough):
        stoppable.move_to(pushed(10))
    is_over = False
    stoppable.reset()
    again = stoppable.move_to(pushed(3))["psoas"].points
    np.testing.assert_array_equal(again, expected)
    stoppable.state = state


def test_a_bar_shows_progress():
    tqdm = pytest.importorskip("tqdm").tqdm
    with tqdm(disable=False, file=open("/dev/null", "w")) as bar:
        quick(progress=bar)
        assert bar.n > 0
        assert bar.total is not None


def test_what_is_no_bar_is_a_type_error():
    with pytest.raises(TypeError, match="neither a function.*nor a bar"):
        quick(progress=3)


def test_the_interpreter_is_free_meanwhile():
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.005)

    thread = threading.Thread(target=tick)
    thread.start()
    began = time.monotonic()
    mw.Deformer(small_scene())
    took = time.monotonic() - began
    done.set()
    thread.join()
    # Had the interpreter been held, there would be a handful.
    assert len([t for t in ticks if t > began]) > min(20, took / 0.05)


def test_several_threads_take_turns(deformer):
    expected = {d: deformer.solve_alone(pushed(d)) for d in (2, 5, 8)}
    frames = {}

    def work(distance):
        frames[distance] = deformer.solve_alone(pushed(distance))

    threads = [threading.Thread(target=work, args=(d,)) for d in expected]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for distance, frame in expected.items():
        np.testing.assert_array_equal(frames[distance]["iliacus"].points,
                                      frame["iliacus"].points)


def test_progress_cannot_use_the_deformer_that_it_is_of():
    caught = []

    def meddle(stage, done, total):
        if deformer and not caught:
            try:
                deformer.move_to(pushed(1))
            except RuntimeError as error:
                caught.append(str(error))

    deformer = None
    deformer = quick(progress=meddle)
    deformer.move_to(pushed(5))
    assert "in use by the call" in caught[0]


def test_progress_may_use_another_deformer(deformer):
    frames = []

    def use(stage, done, total):
        if not frames:
            frames.append(deformer.solve_alone(pushed(2)))

    quick(progress=use)
    np.testing.assert_array_equal(
        frames[0]["psoas"].points,
        deformer.solve_alone(pushed(2))["psoas"].points)
