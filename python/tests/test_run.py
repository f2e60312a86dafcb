# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs: tables, reports, pages, files."""
import base64
import fcntl
import json
import re
import zlib

import numpy as np
import pytest

import musclewarp as mw
from conftest import pushed, quick, small_scene
from same_files import files_of


def figures_of(html):
    """What a page holds but for positions."""
    text = re.search(r'id="runs">([^<]*)<', html).group(1)
    return json.loads(zlib.decompress(base64.b64decode(text)))


@pytest.fixture(scope="module")
def run(deformer):
    result = mw.Run(deformer)
    for distance in (1, 4, 7):
        result.append(deformer.move_to(pushed(distance)))
    return result


def test_numbers_its_frames(run):
    assert [frame.index for frame in run.frames] == [0, 1, 2]
    assert [frame.name for frame in run.frames] == [
        "pushed by 1", "pushed by 4", "pushed by 7"]


def test_frames_of_another_deformer_are_refused(run):
    with pytest.raises(mw.InputError, match="another deformer"):
        run.append(quick(gap=0.2).rest_frame)
    scene = small_scene()
    psoas = scene.muscles[0]
    area = mw.Attachment("femur", psoas.mesh.points[:3], 5)
    scene.muscles[0] = mw.Muscle("psoas", psoas.mesh.points, psoas.mesh.triangles,
                                 lines=psoas.lines, attachments=[area])
    with pytest.raises(mw.InputError, match="another deformer"):
        run.append(quick(scene).rest_frame)


def test_the_report_is_a_dict(run):
    report = run.report()
    assert report["summary"]["frames"] == 3
    assert report["summary"]["usable"] is True
    muscles = report["frames"][2]["muscles"]
    assert [muscle["name"] for muscle in muscles] == ["psoas", "iliacus"]
    assert muscles[0]["volume_mm3"] == run.frames[2]["psoas"].volume


def test_tables_are_arrays(run):
    volumes = run.volumes
    assert volumes.labels == ["psoas", "iliacus"]
    assert volumes.values.shape == (3, 2)
    np.testing.assert_allclose(
        volumes["iliacus"] * 1e9,  # m^3 in tables
        [frame["iliacus"].volume for frame in run.frames], rtol=1e-12)
    np.testing.assert_array_equal(volumes.values[:, 1], volumes["iliacus"])
    assert "psoas" in run.lengths and "soleus" not in run.lengths
    assert len(run.moment_arms.labels) == 0
    with pytest.raises(KeyError, match="soleus"):
        volumes["soleus"]


def test_tables_are_written_and_read(run, tmp_path):
    path = str(tmp_path / "volumes.sto")
    run.volumes.write(path)
    again = mw.read_table(path)
    assert again.labels == run.volumes.labels
    np.testing.assert_array_equal(again.values, run.volumes.values)
    np.testing.assert_array_equal(again.times, run.volumes.times)


def test_writes_files_that_hold_the_frames(run, tmp_path):
    run.write(tmp_path / "out", format="ply,obj")
    files = files_of(tmp_path / "out")
    assert "report.json" in files and "rest/femur.obj" in files
    for i, frame in enumerate(run.frames):
        mesh = mw.read_mesh(str(tmp_path / f"out/frame_000{i}/iliacus.ply"))
        np.testing.assert_array_equal(mesh.points, frame["iliacus"].points)


def test_bones_may_be_written_once(run, tmp_path):
    run.write(tmp_path / "every")
    run.write(tmp_path / "once", bones="once")
    every, once = files_of(tmp_path / "every"), files_of(tmp_path / "once")
    assert once.keys() - every.keys() == {
        f"frame_000{i}/bones.json" for i in range(3)}
    assert every.keys() - once.keys() == {
        f"frame_000{i}/femur.ply" for i in range(3)}
    once_page, every_page = (
        figures_of(mw.page(tmp_path / name).html) for name in ("once", "every"))
    # The folder's name is in the page; nothing else differs.
    for page in (once_page, every_page):
        del page["runs"][0]["folder"]
    assert once_page == every_page


def test_what_cannot_be_written_is_refused(run, deformer, tmp_path):
    with pytest.raises(mw.InputError, match="format=docx"):
        run.write(tmp_path / "out", format="docx")
    with pytest.raises(mw.InputError, match="bones=twice"):
        run.write(tmp_path / "out", bones="twice")
    (tmp_path / "file").touch()
    with pytest.raises(mw.InputError, match="out=.*cannot|not a folder"):
        run.write(tmp_path / "file")
    with pytest.raises(mw.InputError, match="run: has no frames"):
        mw.Run(deformer).write(tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_folder_that_another_run_writes_to_is_refused(run, tmp_path):
    run.write(tmp_path / "out")
    with open(tmp_path / "out/.musclewarp.lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        lock.write("process 7 on mule")
        lock.flush()
        with pytest.raises(mw.InputError, match="another run.*process 7 on mule"):
            run.write(tmp_path / "out")
    run.write(tmp_path / "out")
    assert ".musclewarp.lock" not in files_of(tmp_path / "out")


def test_becomes_a_page(run, tmp_path):
    page = run.page()
    assert page.html.startswith("<!doctype html>") or "<html" in page.html[:200]
    assert "iliacus" in str(figures_of(page.html))
    shown = page._repr_html_()
    assert shown.startswith('<iframe srcdoc="')
    assert shown.count('"') < 12  # those of the page are escaped
    page.write(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text(encoding="utf-8") == page.html
    run.write(tmp_path / "run")
    # But for the folder's name and paths of files nothing differs.
    again = figures_of(mw.page(tmp_path / "run").html)
    shown = figures_of(page.html)
    for key in ("frames", "muscles", "bones"):
        assert again["runs"][0][key] == shown["runs"][0][key]
    with pytest.raises(mw.InputError, match="missing"):
        mw.page(tmp_path / "missing")


def test_the_poses_of_a_scene_are_run():
    scene = small_scene()
    scene.poses = [pushed(2), pushed(6)]
    told = []
    alone = mw.run(scene, coarse_vertices=60,
                   progress=lambda *args: told.append(args))
    assert told[-1] == ("frames", 2, 2)
    scene.is_motion = True
    motion = mw.run(scene, coarse_vertices=60)
    np.testing.assert_array_equal(
        alone.frames[1]["psoas"].points,
        quick(scene).solve_alone(pushed(6))["psoas"].points)
    # In a motion a frame starts from the one before.
    deformer = quick(scene)
    deformer.move_to(pushed(2))
    np.testing.assert_array_equal(
        motion.frames[1]["psoas"].points,
        deformer.move_to(pushed(6))["psoas"].points)
