#!/usr/bin/env python3
"""The page and the table of stress runs, from figures that are made up. report_test.py FOLDER_OF_REPORT_PY"""
import pathlib
import sys
import unittest

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
    """As load() gives them."""
    return {(run["scenario"], run["seed"]): run for run in runs}


class Report(unittest.TestCase):
    FAILURE = {"check": "mass", "message": "1 < 2", "step": 7, "script": "Box(<)"}

    def test_page_says_what_a_scenario_does_and_what_failed(self):
        page = report.page("nowhere", runs_of(run_of("flood", 1), run_of("scales", 2, self.FAILURE)), {})
        self.assertIn("2 runs, 72,060 steps: 1 failed", page)
        self.assertIn("Water rises through a room", page)
        self.assertIn("Step 7: mass: 1 &lt; 2", page)
        self.assertIn("<pre>Box(&lt;)</pre>", page)
        self.assertIn("200 s of processor time: steps 75 %, replay 25 %. Build 1a2b. Machine: X1, 2 processors.", page)
        self.assertIn("Zero in every step: step, awake bodies", page)

    def test_comparison_marks_what_is_worse(self):
        slow = run_of("flood", 1)
        slow["ms_p50_p95_p99_max"]["step"] = [9.0, 2.0, 3.0, 4.0]
        page = report.page("nowhere", runs_of(slow), runs_of(run_of("flood", 1)))
        self.assertIn('<td class="bad">9.00 <small>(1.00)</small></td>', page)
        self.assertIn("all checks held; same hash", page)

    def test_page_and_envelope_say_that_a_run_was_interrupted(self):
        runs = runs_of(run_of("flood", 1) | {"interrupted": True})
        self.assertIn("all checks held until it was interrupted", report.page("nowhere", runs, {}))
        self.assertIn("all checks held until it was interrupted", report.envelope(runs))

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


if __name__ == "__main__":
    unittest.main()
