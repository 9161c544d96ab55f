#!/usr/bin/env python3
"""The page and the table of stress runs, from figures that are made up, and what the program leaves of runs of a few
steps. report_test.py FOLDER_OF_REPORT_PY PROGRAM"""
import contextlib
import fcntl
import io
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv.pop()).resolve()
sys.path.insert(0, sys.argv.pop())
import report  # noqa: E402


def run_of(scenario, seed, failure=None, bodies=12):
    """The figures of a run of ten minutes."""
    run = {"scenario": scenario, "seed": seed, "steps": 36030, "replayed_steps": 36000, "loads": 2, "hash": "1f",
           "build": "1a2b", "machine": "X1, 2 processors",
           "processor_seconds": {"steps": 150.0, "replay": 49.9, "motion": 0.1},
           "ms_p50_p95_p99_max": {stage: [1.0, 2.0, 3.0, 4.0] for stage in report.STAGES},
           "plots": {title: [0.0, 0.0] for title in report.PLOTS}}
    run["plots"]["bodies"] = [1, bodies]
    if failure:
        run["failure"] = failure
    return run


def runs_of(*runs):
    """As Folder.runs has them."""
    return {(run["scenario"], run["seed"]): run for run in runs}


def folder_of(*runs):
    """A folder with these runs."""
    folder = report.Folder("nowhere")
    folder.runs = runs_of(*runs)
    return folder


def main_of(*arguments):
    """The exit status of the report, and what it writes to the error output."""
    errors = io.StringIO()
    sys.argv[1:] = map(str, arguments)
    with contextlib.redirect_stderr(errors), contextlib.redirect_stdout(io.StringIO()):
        try:
            report.main()
            status = 0
        except SystemExit as end:
            status = end.code
    return status, errors.getvalue()


class Report(unittest.TestCase):
    FAILURE = {"check": "mass", "message": "1 < 2", "step": 7, "script": "Box(<)"}

    def test_page_says_what_a_scenario_does_and_what_failed(self):
        page = report.page("nowhere", folder_of(run_of("flood", 1), run_of("scales", 2, self.FAILURE)))
        self.assertIn("2 runs, 72,060 steps: 1 failed; all checks held in 1.", page)
        self.assertIn("Water rises through a room", page)
        self.assertIn("Step 7: mass: 1 &lt; 2", page)
        self.assertIn("<pre>Box(&lt;)</pre>", page)
        self.assertIn("200 s of processor time: steps 75 %, replay 25 %. Build 1a2b. Machine: X1, 2 processors.", page)
        self.assertIn("Zero in every step: step, awake bodies", page)

    def test_comparison_marks_what_is_worse(self):
        slow = run_of("flood", 1)
        slow["ms_p50_p95_p99_max"]["step"] = [9.0, 2.0, 3.0, 4.0]
        page = report.page("nowhere", folder_of(slow), folder_of(run_of("flood", 1)))
        self.assertIn('<td class="bad">9.00 <small>(1.00)</small></td>', page)
        self.assertIn("all checks held; same hash", page)

    def test_page_and_envelope_say_that_a_run_was_interrupted(self):
        run = run_of("flood", 1) | {"interrupted": True}
        page = report.page("nowhere", folder_of(run))
        self.assertIn("all checks held until it was interrupted", page)
        self.assertIn("<b>1 run, 36,030 steps: 1 interrupted, all checks held until then.</b>", page)
        self.assertIn("all checks held until it was interrupted", report.envelope(runs_of(run)))

    def test_hashes_of_runs_with_other_options_are_not_compared(self):
        page = report.page("nowhere", folder_of(run_of("flood", 1) | {"check_every": 4.0}),
                           folder_of(run_of("flood", 1) | {"check_every": 20.0}))
        self.assertIn("hashes not compared: --check-every 4.0, was 20.0", page)

    def test_comparison_names_runs_of_one_side(self):
        page = report.page("nowhere", folder_of(run_of("flood", 1), run_of("flood", 2)),
                           folder_of(run_of("flood", 1), run_of("scales", 7)))
        self.assertIn("Only in this folder: flood 2.", page)
        self.assertIn("Only in the other folder: scales 7.", page)

    def test_damaged_files_are_named_and_the_others_are_shown(self):
        with tempfile.TemporaryDirectory() as path:
            good = json.dumps(run_of("flood", 1))
            texts = {"flood_1.json": good, "a_1.json": "{", "b_1.json": "{}", "c_1.json": "[]", "d_1.json": "\xff",
                     "e_1.json": good.replace('"seed": 1', '"seed": "1"'), "f_1.json": "[" * 100000,
                     "flood_2.json.part": "{"}
            for name, text in texts.items():
                (pathlib.Path(path) / name).write_text(text, encoding="latin-1")
            status, errors = main_of(path)
            page = (pathlib.Path(path) / "report.html").read_text(encoding="utf-8")
        self.assertEqual(status, 1)
        for name in "abcdef":
            self.assertIn(f"/{name}_1.json: ", errors)
            self.assertIn(f"{name}_1.json</td>", page)
        self.assertIn("8 runs, 36,030 steps: 1 ended without figures; 6 unreadable; all checks held in 1.", page)
        self.assertIn("flood, seed 2</td>", page)

    def test_images_are_those_of_the_run(self):
        with tempfile.TemporaryDirectory() as path:
            for name in ("x_1_10.png", "x_1_2.png", "x_1_2_1.png"):
                (pathlib.Path(path) / name).write_bytes(name.encode())
            images = report.images(path, {"scenario": "x", "seed": 1})
        self.assertEqual(images.count("<img"), 2)
        self.assertLess(images.index("eF8xXzIu"), images.index("eF8xXzEw"))  # "x_1_2.", "x_1_10"

    def test_envelope_has_a_row_for_each_run(self):
        rest = "| 36,000 | {} | 0 | 0 | 2 | 0 | 4.16 | 1a2b | X1, 2 processors | {} |"
        rows = report.envelope(runs_of(run_of("flood", 1), run_of("flood", 2, bodies=4321),
                                       run_of("scales", 1, self.FAILURE))).splitlines()
        self.assertIn("| flood | 2 | 10 " + rest.format("4,321", "all checks held"), rows)
        self.assertIn("| scales | 1 | 10 " + rest.format("12", "mass at step 7"), rows)

    def test_envelope_keeps_the_rows_of_other_runs(self):
        before = report.envelope(runs_of(run_of("flood", 2, bodies=22), run_of("flood", 10, bodies=77)))
        after = report.envelope(runs_of(run_of("flood", 1), run_of("flood", 10, bodies=33)), before).splitlines()
        rows = [line.split(" | ") for line in after if line.startswith("| flood")]
        self.assertEqual([(row[1], row[4]) for row in rows], [("1", "12"), ("2", "22"), ("10", "33")])

    def test_no_shorter_run_replaces_a_longer_one(self):
        short = run_of("flood", 1, bodies=9)
        short["steps"] = 1201
        before = report.envelope(runs_of(run_of("flood", 1)))
        self.assertEqual(report.envelope(runs_of(short), before), before)
        self.assertNotEqual(report.envelope(runs_of(run_of("flood", 1, bodies=9)), before), before)


class Program(unittest.TestCase):
    """Runs of a few steps."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def play(self, text, *options, name="x", minutes="0.001"):
        """Plays a scenario of three steps, or more: the exit status, and what it prints to both outputs."""
        scenario = self.path / f"{name}.lua"
        scenario.write_text(text, encoding="utf-8")
        run = subprocess.run([PROGRAM, scenario, "--minutes", minutes, "--images", "0", "--out", self.path, *options],
                             capture_output=True, text=True, errors="replace")
        return run.returncode, run.stdout, run.stderr

    def figures(self, name="x_1.json"):
        return json.loads((self.path / name).read_text(encoding="utf-8"))

    def test_texts_of_a_short_script_are_those_of_the_run(self):
        text = r'"q\"b\\n\nr\rz\0a@1@b 1.2345 \u{e4}"'
        written = r'"q\"b\\n\nr\013z\000a\0641\064b 1.2345 \195\164"'
        self.play(f"function init() CollideAs(Box({text}, {{0, 2.12345, 0}}, {{4, 4, 4}}, 5), {text}) end")
        failure = self.figures()["failure"]
        self.assertIn(f"made[0] = Box({written}, {{0, 2.12, 0}}, {{4, 4, 4}}, 5)\n", failure["script"])
        self.assertIn(f"    CollideAs(made[0], {written})\n", failure["script"])
        for key in (written, '"end"'):
            self.play(f"function init() Settings({{[{key}] = 1, stress = true}}) end")
            self.assertIn(f"Settings({{[{key}] = 1, stress = true}})", self.figures()["failure"]["script"])

    # Functions that change the world or what later calls do to it. A new function is one of them until its name begins
    # as those of questions do, in command_log.cpp.
    EFFECTS = set("""AddHeat AddLight ApplyBodyImpulse Ball Bounds Box BreakRope Character ClearKey ClearShape
        ClosedSystem CollideAs ConstrainAngularVelocity ConstrainOrientation ConstrainPosition ConstrainVelocity
        CopyShapeContent CopyShapePalette Crack CreateShape Cut Delete DetachJointFromShape DrawShapeBox DrawShapeLine
        Drive DriveVehicle ExactHole Explosion Extinguish ExtrudeShape FreeFlight Glow Joint LightGroup LoadLevel
        LoadLoop LoadSound MakeHole MakeHoleLine MergeShape Paint PaintRGBA ParticleAlpha ParticleCollide
        ParticleColor ParticleDrag ParticleEmissive ParticleFlags ParticleGravity ParticleRadius ParticleReset
        ParticleRotation ParticleSticky ParticleStretch ParticleTile ParticleType PlayLoop PlayMusic PlaySound
        PointLight Pour Redo RegisterTool RemoveAabbFires RemoveTag RemoveWater ResizeShape SaveAndLoad
        SetBodyActive SetBodyAngularVelocity SetBodyDynamic SetBodyTransform SetBodyVelocity SetBool SetBrush
        SetFloat SetGravity SetInt SetJointMotor SetJointMotorTarget SetLightColor SetLightEnabled SetLightIntensity
        SetPlayerHealth SetPlayerTransform SetPlayerVelocity SetShapeCollisionFilter SetShapeDensity
        SetShapeEmissiveScale SetString SetTag SetTimeScale SetToolTransform Settings ShakeCamera Shoot Spawn
        SpawnFire SpawnParticle SplitShape StopMusic SwitchLightGroup TrimShape Undo UndoLimit UndoMark Walk
        Water""".split())
    FUNCTIONS = 280  # all of them, those without an effect among them

    def test_all_calls_with_an_effect_are_written_down(self):
        _, _, errors = self.play("""function init()
            local names = {}
            for name, value in pairs(_G) do
                if type(value) == "function" and name:match("^%u") and name ~= "WaitForStep" and name ~= "Expect" then
                    names[#names + 1] = name
                    pcall(value)
                end
            end
            print("functions", #names)
            Walk(0, {1, 2})
        end""", "--minimise", "1")
        script = self.figures()["failure"]["script"]
        written = set(re.findall(r"^    (?:made.* = )?(?:pcall\()?(\w+)", script.split("function init()")[1], re.M))
        self.assertEqual(written, self.EFFECTS)
        self.assertEqual(int(re.search(r"functions\t(\d+)", errors).group(1)), self.FUNCTIONS)

    def test_calls_of_a_short_script_have_their_arguments(self):
        calls = ['Settings({1, 2.0, {-0.0}, [-3] = 1, [2.5] = "a", [5] = 0.5, [true] = 3, stress = true})',
                 "Crack({0, 0, 0}, 1)", "Extinguish({0, 0, 0}, 2)", 'BreakRope(7, {0, 0, 0})',
                 "DetachJointFromShape(7, 8)"]
        self.play("function init() " + " ".join(f"pcall({call.replace('(', ', ', 1)}" for call in calls) +
                  " Walk(0, {1, 2}) end", "--minimise", "1")
        script = self.figures()["failure"]["script"]
        for call in calls:
            self.assertTrue(call in script or call.replace("(", ", ", 1) in script, script)

    def test_the_heap_is_that_of_one_world(self):
        self.play("function init() LoadLevel('town') end", "--check-every", "0.25", minutes="0.01")
        heap = [each for each in self.figures()["plots"]["heap, MiB"] if each > 8]
        self.assertLess(max(heap), 1.3 * min(heap), heap)  # a check has a copy of the world

    def short_script(self, text):
        """That of a scenario which fails by SetShapeDensity() of -1."""
        self.play(text)
        failure = self.figures()["failure"]
        lines = failure.get("script", failure.get("no_script")).splitlines()
        self.assertTrue(lines[0].startswith("-- script: SetShapeDensity: density: expected "), lines)
        return lines

    def test_what_calls_and_events_give_has_a_name_in_a_short_script(self):
        cut = """local c = Box("c", {0, 2, 0}, {9, 8, 8}, 5, {dynamic = true})
            wait(0)
            SetBrush("cube", 1, 0)
            DrawShapeBox(c, 4, 0, 0, 4, 7, 7)"""
        lines = self.short_script(f"function init() {cut} SetShapeDensity(SplitShape(c)[1], -1) end")
        self.assertRegex(lines[-3], r"^    made\[(\d)\] = SplitShape\(made\[0\]\)$")
        self.assertRegex(lines[-2], r"^    SetShapeDensity\(made\[\d\]\[1\], -1\)$")
        lines = self.short_script(f"function init() {cut} start(SplitShape, c) end "
                                  "function onSplit(_, list) SetShapeDensity(list[1], -1) end")
        self.assertRegex(lines[-3], r"^    made\[(\d)\] = FindShapes\(\)$")

    def test_what_was_found_early_stays_what_it_was(self):
        self.short_script("""function init()
            local bar = Box("bar", {0, 0, 0}, {23, 4, 4}, 5, {dynamic = true})
            wait(0)
            for i = 0, 1 do Cut(bar, {0.75 + 0.8 * i, 0.2, 0.2}, {0.05, 1, 1}, Quat()) end
            wait(0)
            local pieces = FindShapes()
            Delete(pieces[2])
            wait(0)
            SetShapeDensity(pieces[3], -1)
        end""")

    def test_exact_holes_of_one_step_and_refused_ones(self):
        status, _, errors = self.play("""function init()
            local a, b = Box("a", {0, 0, 0}, {8, 8, 8}, 5), Box("b", {2, 0, 0}, {8, 8, 8}, 5)
            wait(0)
            ExactHole(a, {4, 4, 4}, 2) ExactHole(a, {5, 4, 4}, 2) ExactHole(a, {0, 0, 0}, 2) ExactHole(b, {4, 4, 4}, 2)
            assert(not pcall(ExactHole, a, {0/0, 4, 4}, 2))
        end""")
        self.assertEqual(status, 0, errors)

    def test_events_of_a_step_that_a_check_makes_are_told(self):
        status, _, errors = self.play("""local removed = 0
        function onBreak(shape, count) removed = removed + count end
        function init()
            local a = Box("a", {0, 0, 0}, {8, 8, 8}, 5)
            wait(0)
            for i = 1, 12 do
                ExactHole(a, {i % 3 * 4, i % 2 * 4, i // 6 * 8}, 2)
                wait(0)
                Expect(GetShapeVoxelCount(a) + removed == 512, "voxels that events have told, after " .. i)
            end
        end""", "--check-every", "0.1", minutes="0.004")
        self.assertEqual(status, 0, errors)

    def test_nonsense_of_scene_functions_is_refused_and_leaves_nothing(self):
        status, _, errors = self.play("""function init()
            local a = Box("a", {0, 0, 0}, {8, 8, 8}, 5)
            wait(0)
            for _, call in ipairs{
                {Box, "x", {0, 5, 0}, {2000, 2000, 2000}, 5}, {Box, "x", {0, 5, 0}, {1.5, 1, 1}, 5},
                {Box, "x", {0, 5, 0}, {2, 2, 2}, 5, {voxels = 1}}, {Box, "x", {0, 5, 0}, {2, 2, 2}, 5, 5},
                {Box, "x", {0, 5, 0}, {2, 2, 2}, 5, {voxel = 1e-9}}, {Ball, "x", {0, 5, 0}, 4, 5, {Dynamic = true}},
                {Joint, "ball", a, 0, {0, 0, 0}, {axiss = {0, 1, 0}}}, {Water, {0, 0, 0}, {1, 1, 1}, {flows = {1}}},
                {Glow, a, 300, 1}, {UndoLimit, -1}, {UndoLimit, 2.5}, {LoadLevel, "nothing"}, {Settings, {nothing = 1}},
            } do assert(not pcall(table.unpack(call)), _) end
            wait(0)
            Expect(#FindBodies() == 1, "one body")
        end""")
        self.assertEqual(status, 0, errors)

    def test_a_short_script_fails_by_the_same_call(self):
        self.play("""function init()
            UndoLimit(3)
            UndoMark()
            pcall(MakeHole, {0, 0, 0}, 2000) pcall(Undo) pcall(Undo)
            Walk(0, {1, 2})
        end""")
        failure = self.figures()["failure"]
        self.assertIn("Walk: velocity: expected a vector", failure["script"].splitlines()[0])
        self.assertEqual(failure["script"].splitlines()[3:], ["    Walk(0, {1, 2})", "end"])

    def test_why_there_is_no_short_script(self):
        for text, why in (("Expect(false, 'x')", "Expect() is part of the scenario, not of the world"),
                          ("error('a\\xff')", "the calls with an effect alone do not fail"),
                          ("pcall(MakeHole, {0, 0, 0}, 2000) error('b')",
                           "the calls with an effect alone do not fail")):
            printed = self.play(f"function init() {text} end")[1]
            self.assertIn(f"no short script: {why}\n", printed)
            self.assertEqual(self.figures()["failure"]["no_script"], why)
        self.assertNotEqual(self.play("", "--minimise", "-5")[0], 0)

    def test_a_run_replaces_what_an_earlier_one_has_left(self):
        left = [f"x_1{ending}" for ending in (".json", "_1.png", "_failure.lua", ".rubblelog", ".rubblelog.part")]
        others = ["x_10.json", "x_1_2.json", "x_1_2_1.png"]
        for name in left + others:
            (self.path / name).write_text("{")
        self.play("")
        files = {path.name for path in self.path.iterdir()}
        self.assertEqual(files, {"x.lua", "x_1.json", *others})

    def test_a_killed_run_has_ended_without_figures(self):
        scenario = self.path / "x.lua"
        scenario.write_text("function init() print('begun') end")
        run = subprocess.Popen([PROGRAM, scenario, "--minutes", "99", "--images", "0", "--out", self.path],
                               stderr=subprocess.PIPE, text=True)
        with run:
            self.assertEqual(run.stderr.readline(), "x.lua: begun\n")
            run.kill()
        folder = report.Folder(self.path)
        self.assertEqual((folder.runs, folder.ended), ({}, [("x", "1")]))

    def test_a_run_leaves_those_alone_that_go_on(self):
        scenario = self.path / "x.lua"
        scenario.write_text("function init() print('begun') end")
        run = subprocess.Popen([PROGRAM, scenario, "--minutes", "99", "--images", "0", "--out", self.path],
                               stderr=subprocess.PIPE, text=True)
        with run:
            run.stderr.readline()
            status, _, errors = self.play("")
            self.assertEqual(status, 1)
            self.assertIn("x_1.json.part is of a run that goes on: expected another --out", errors)
            self.assertTrue((self.path / "x_1.json.part").exists() and not (self.path / "x_1.json").exists())
            run.kill()
        self.assertEqual(self.play("")[0], 0)
        with open(self.path / "x_1.json") as figures:  # as of a run that draws its images
            fcntl.flock(figures, fcntl.LOCK_EX)
            self.assertIn("is of a run that goes on", self.play("")[2])
        self.assertEqual({path.name for path in self.path.iterdir()}, {"x.lua", "x_1.json"})

    def test_signals_end_a_run_orderly(self):
        scenario = self.path / "x.lua"
        scenario.write_text("function init() print('begun') end")
        # Two signals that wait while the program is stopped arrive together.
        together = (signal.SIGSTOP, signal.SIGINT, signal.SIGTERM, signal.SIGCONT)
        for signals, statuses in (((signal.SIGTERM,), [143]), (together, [-signal.SIGINT, -signal.SIGTERM])):
            run = subprocess.Popen([PROGRAM, scenario, "--minutes", "99", "--images", "0", "--out", self.path],
                                   stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
            with run:
                run.stderr.readline()
                for each in signals:
                    run.send_signal(each)
                self.assertIn(run.wait(), statuses)
            self.assertEqual([path.name for path in self.path.glob("*.rubblelog*")], [])
        self.assertEqual(report.Folder(self.path).ended, [("x", "1")])

    def test_scenarios_of_one_name_do_not_replace_each_other(self):
        self.play("")
        (self.path / "b").mkdir()
        status, _, errors = self.play("", name="b/x")
        self.assertEqual(status, 1)
        self.assertIn(f"x_1.json is of another scenario, {self.path}/x.lua: expected another --out", errors)

    def test_jobs_are_lines_for_a_shell(self):
        out, scenario = "\u00f6 a/'b\n$(c)", str(self.path / "t 1's.lua")
        pathlib.Path(scenario).write_text("")
        lines = subprocess.run([PROGRAM, scenario, "--list-jobs", "--out", out, "--threads"], cwd=self.path,
                               capture_output=True, text=True).stdout
        self.assertEqual(lines.count("\n"), 1)
        words = subprocess.run(["bash", "-c", f"printf '%s\\0' {lines}"], capture_output=True, text=True).stdout
        words = words.split("\0")
        self.assertEqual(words[2], scenario)
        self.assertEqual(words[words.index("--out") + 1], out)

    def test_figures_say_how_to_play_the_run_again(self):
        self.play("", "--check-every", "0.5", "--seed", "7", "--threads")
        run = self.figures("x_7.json")
        self.assertEqual(run["command"], f"./rubble stress {self.path}/x.lua --seed 7 --minutes 0.001 "
                         "--check-every 0.5 --threads")
        self.assertEqual((run["check_every"], run["threads"]), (0.5, True))

    def test_the_log_has_what_a_scenario_prints_once(self):
        errors = self.play("function init() print('here') UndoMark() wait(0.02) MakeHole({0, 0, 0}, 2000) end")[2]
        self.assertEqual(errors.count("x.lua: here\n"), 1)
        self.assertEqual(errors.count("no marks are kept"), 1)


if __name__ == "__main__":
    unittest.main()
