# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The gait cycle, the joints of the leg, and the chapter."""

import json
import pathlib
import sys
import tempfile
import unittest

import gait_cycle
import gait_page
import gait_scene
import leg
import measured
import numpy as np

ROUNDING = 1e-9
HIP, KNEE, ANKLE = [0.0, 0, 800], [0.0, 0, 400], [0.0, 0, 50]
LEFT = [1.0, 0, 0]  # the axis of all joints here


def write(path, content):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(content if isinstance(content, str) else json.dumps(content))


def about(point, degrees):
    """Right-handed about +x, written out."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    y, z = point[1:]
    return np.array([
        [1, 0, 0, 0],
        [0, c, -s, y - c * y + s * z],
        [0, s, c, z - s * y - c * z],
        [0, 0, 0, 1],
    ])


def write_data(data, sign=1):
    """A leg that hangs along z, and its poses; with `sign` -1 all joints are turned
    the wrong way, in axes and poses alike."""
    axis = [sign * LEFT[0], 0, 0]
    write(data / "bodyparts3d/joints.json", {"hip_r": {"center": HIP}})
    write(data / "bodyparts3d_shank/joints.json", {
        "knee_r": {"point": KNEE, "direction_lateral_to_medial": axis},
        "ankle_r": {
            "lateral_malleolus_tip": ANKLE, "direction_lateral_to_medial": axis
        },
    })
    write(data / "bodyparts3d_shank/uniform/toe_1_distal.obj", "v 0 -150 10\n")
    for name, poses in leg.POSES.items():
        given = []
        for pose, angles, body in poses:
            femur = about(HIP, -angles.get("hip", 0))
            tibia = femur @ about(KNEE, sign * angles.get("knee", 0))
            foot = tibia @ about(ANKLE, -sign * angles.get("ankle", 0))
            bodies = {"femur": femur, "tibia": tibia, "foot": foot}
            given.append({"name": pose, body: bodies[body].tolist()})
        write(data / name / "poses.json", {"poses": given})


class CycleTest(unittest.TestCase):

    def test_table_gives_a_hundred_frames_within_the_ranges(self):
        frames, outside = gait_cycle.gait_cycle()
        self.assertEqual(list(range(100)), [frame.percent for frame in frames])
        self.assertEqual({"hip": 0, "knee": 0, "ankle": 0}, outside)
        rows = gait_cycle.table_rows()
        self.assertEqual([row["knee"] for row in rows[:-1]], [f.knee for f in frames[::2]])

    def test_midway_a_cubic_is_met(self):
        values = [x**3 - 4 * x for x in (0, 2, 4, 6, 8)]
        between = gait_cycle.doubled(values)[3:7:2]
        np.testing.assert_allclose(between, [x**3 - 4 * x for x in (3, 5)])

    def test_angles_beyond_the_range_are_cut_and_counted(self):
        self.assertEqual(([0, 30, 60], 2), gait_cycle.limited([-3, 30, 61], "knee"))


class LegTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.data = pathlib.Path(folder.name)

    def test_joints_reach_the_poses_and_move_the_bones_as_they_are_named(self):
        write_data(self.data)
        some = leg.Leg(self.data)
        leg.check_leg(some, self.data)
        bodies = some.bodies("pelvis", hip=90, knee=90)
        # Sitting: the knee in front of the hip, the ankle below the knee.
        knee, ankle = (leg.moved(bodies["tibia"], np.array(p)) for p in (KNEE, ANKLE))
        np.testing.assert_allclose(knee, [0, -400, 800], atol=ROUNDING)
        np.testing.assert_allclose(ankle, [0, -400, 450], atol=ROUNDING)

    def test_joint_that_turns_the_wrong_way_is_refused(self):
        write_data(self.data, sign=-1)
        with self.assertRaisesRegex(ValueError, "heel"):
            leg.check_leg(leg.Leg(self.data), self.data)

    def test_pose_that_is_not_reached_is_refused(self):
        write_data(self.data)
        some = leg.Leg(self.data)
        some.given["flexion_45"]["femur"][1][3] += 1
        with self.assertRaisesRegex(ValueError, "flexion_45"):
            leg.check_leg(some, self.data)

    def test_scene_is_that_of_the_poses_with_other_poses(self):
        write_data(self.data)
        path = self.data / "out/scene.json"
        self.assertEqual("", gait_scene.write_scene(self.data, "thigh", path))
        scene = json.loads(path.read_text())
        source = json.loads(gait_scene.source_of(self.data, "thigh").read_text())
        self.assertEqual(source["muscles"], scene["muscles"])
        self.assertNotIn("poses_file", scene)
        times = [pose["time"] for pose in scene["poses"]]
        self.assertEqual(100, len(times))
        self.assertEqual(sorted(set(times)), times)
        self.assertEqual({"femur", "tibia"}, set(scene["poses"][7]["bodies"]))


def muscle():
    return {
        "mean_contact_displacement_mm": 0.25,
        "max_contact_displacement_mm": 3.5,
        "folded_triangles": 1,
        "volume_error": 1e-9,
        "attachments": [{"max_drift_mm": 0.5}],
        "shape": {"triangle_stretch": {"quantile_999": 1.5, "largest": 1.75}},
    }


def frame(index):
    return {
        "index": index, "name": f"gait_{index:02d}", "time": index / 100,
        "usable": index != 1, "shortcomings": ["muscles cross"] * (index == 1),
        "stop_reason": "converged", "wall_ms": 9000 if index == 0 else 900,
        "certify_ms": 100, "moment_arms_ms": 0, "pose_steps": 7 if index == 0 else 2,
        "smallest_gap_mm": 0.11, "muscles": [muscle(), muscle()],
    }


def report(count):
    return {
        "machine": {"processor": "Abacus", "threads": 1},
        "code": "0.1.0 abc",
        "prepare": {
            "wall_ms": 4000, "contact_ms": 36000,
            "muscles": [{"fine_vertices": 100}] * 2, "bones": [{}],
        },
        "frames": [frame(index) for index in range(count)],
        "summary": {"finished": True},
    }


class PageTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = pathlib.Path(folder.name) / "out"
        self.page = pathlib.Path(folder.name) / "page.md"
        begin, end = gait_page.markers("Gait", gait_page.SCRIPT)
        self.source = f"before\n\n{begin}\n\nnot measured\n\n{end}\n\nafter\n"
        self.page.write_text(self.source)

    def run_scene(self, name, count):
        write(self.out / name / "run/report.json", report(count))
        write(self.out / name / "prepared.json", report(1))
        write(self.out / name / "preparation.json", {"wall_s": 50, "peak_mb": 800})
        write(self.out / name / "motion.json", {"wall_s": 150.4, "peak_mb": 700})

    def test_chapter_has_table_and_plots_and_all_else_stays(self):
        for name in gait_page.SCENES:
            self.run_scene(name, 100)
        gait_page.write_page(self.out, self.page)
        text = self.page.read_text()
        self.assertTrue(text.startswith("before\n") and text.endswith("\nafter\n"))
        self.assertNotIn("not measured", text)
        for row in ("| usable frames | 99 of 100 | 99 of 100 |",
                    "| preparation, cold, s | 40 | 40 |",
                    "| first frame, from rest: s, steps | 9.1, 7 | 9.1, 7 |",
                    "| steps of later frames: all, mean, most | 198, 2.00, 2 |"):
            self.assertIn(row, text)
        self.assertIn("gait_01. The first: muscles cross.", text.replace("\n", " "))
        for plot in ("gait_times.svg", "gait_angles.svg"):
            self.assertIn(f"(page/{plot})", text)
            self.assertTrue((self.page.parent / "page" / plot).exists())

    def test_part_of_a_cycle_is_printed_but_no_page(self):
        self.run_scene("thigh", 4)
        self.assertIn("3 of 4", gait_page.gait_table(gait_page.read_walks(self.out)))
        with self.assertRaisesRegex(ValueError, "4 of 100"):
            gait_page.write_page(self.out, self.page)
        self.assertEqual(self.source, self.page.read_text())

    def test_page_of_the_repository_has_its_markers(self):
        text = (gait_scene.REPOSITORY / "docs/performance.md").read_text()
        gait_page.replaced(text, "Gait", [], gait_page.SCRIPT)


class MeasuredTest(unittest.TestCase):

    def test_exit_code_time_and_memory_are_those_of_the_program(self):
        program = "b = bytearray(64 << 20); raise SystemExit(1)"
        code, figures = measured.measure([sys.executable, "-c", program])
        self.assertEqual(1, code)
        self.assertGreater(figures["peak_mb"], 64)


if __name__ == "__main__":
    unittest.main()
