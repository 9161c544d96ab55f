#!/usr/bin/env python3
"""The page of a folder of runs: ./rubble stress report FOLDER [--compare OTHER] [--publish].

Reads NAME_SEED.json files, and writes FOLDER/report.html: a table of all runs, then for each run its plots, images and
what failed. With --compare the figures of another folder, as of another build, stand beside them, and changes of more
than a tenth are marked. --publish writes the rows of these runs into the table of OPERATING_ENVELOPE.md; the rows of
other scenarios and seeds stay."""
import argparse
import base64
import html
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
STYLE = """body{font:15px/1.5 sans-serif;max-width:1180px;margin:2em auto;padding:0 1em;color:#222}
table{border-collapse:collapse;font-size:13px}td,th{padding:2px 9px;text-align:right;border-bottom:1px solid #ddd}
td:first-child,th:first-child,.text{text-align:left}.bad{background:#fdd}.good{background:#dfd}
h2{margin-top:2em;border-top:2px solid #888;padding-top:.5em}figure{display:inline-block;margin:6px}
figcaption{font-size:12px;color:#555}pre{background:#f4f4f4;padding:8px;overflow-x:auto}
svg text{font-size:10px;fill:#777}dt{font-weight:bold;float:left;clear:left;margin-right:.6em}dd{margin:0 0 .2em}
summary{cursor:pointer}"""
STAGES = {
    "edits": "holes, explosions and other commands, and the pieces that come off",
    "physics": "contacts, joints, water and motion",
    "poses": "bodies take their new places",
    "impacts": "what hits hard breaks",
    "shadow": "the shadow volume follows; in a game another thread does that",
    "step": "all of them",
}
PLOTS = ["step, ms", "bodies", "awake bodies", "contacts", "kinetic energy, kJ", "standing voxels", "voxels in pieces",
         "removed voxels", "shadow lag, steps", "heap, MiB"]
COLUMNS = {
    "steps": "of the world that were played, 60 a second",
    "replayed": "steps that were played again from a recording, without scripts, and gave the same hash of the state",
    "p50, p95, p99": "half, 95 % and 99 % of the steps took no longer than this: wall clock, with whatever else the "
                     "machine did",
    "processor": "mean of all steps: processor time of all threads, without the checks",
    "heap": "the most memory in use at once",
    "bodies": "the most at once: what stands, and all pieces",
    "kinetic energy": "of all bodies",
    "shadow lag": "how many steps the shadow volume is behind",
}


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def are_numbers(values):
    return isinstance(values, list) and all(map(is_number, values))


def fault_of(run):
    """What the figures of a run lack, or nothing."""
    kinds = {"scenario": str, "seed": int, "steps": int, "replayed_steps": int, "loads": int, "hash": str,
             "ms_p50_p95_p99_max": dict, "plots": dict}
    if not isinstance(run, dict):
        return "expected the figures of a run"
    for key, kind in kinds.items():
        if not isinstance(run.get(key), kind):
            return f"expected {key}"
    times, seconds, failure = run["ms_p50_p95_p99_max"], run.get("processor_seconds", {}), run.get("failure")
    if not all(are_numbers(times.get(stage)) and len(times[stage]) == 4 for stage in STAGES):
        return "expected four times of each stage"
    if not all(are_numbers(run["plots"].get(title)) for title in PLOTS):
        return "expected the points of each plot"
    if not isinstance(seconds, dict) or not are_numbers(list(seconds.values())):
        return "expected seconds of processor time"
    if failure is not None and not (isinstance(failure, dict) and is_number(failure.get("step")) and all(
            isinstance(failure.get(key), str) for key in ("check", "message", "script"))):
        return "expected check, message, step and script of the failure"
    return None


class Folder:
    """What a folder has: figures of runs by name and seed, names and seeds of runs that began and have none, and files
    that cannot be read, with the reason."""

    def __init__(self, folder):
        self.runs, self.ended, self.damaged = {}, [], {}
        for path in sorted(pathlib.Path(folder).glob("*_*.json")):
            run = self.read(path, fault_of)
            if run is not None:
                self.runs[run["scenario"], run["seed"]] = run
        for path in sorted(pathlib.Path(folder).glob("*_*.json.part")):
            name, _, seed = path.name.removesuffix(".json.part").rpartition("_")
            self.ended.append((name, seed))

    def read(self, path, fault):
        """The object of a file; nothing if it is damaged."""
        try:
            value = json.loads(path.read_text(encoding="utf-8"))
            reason = fault(value)
        except (OSError, ValueError, RecursionError) as error:
            reason = str(error)
        if reason is None:
            return value
        self.damaged[path.name] = reason
        return None


def describe(scenario):
    """What a scenario does: the first line of its script, or nothing if there is no such script."""
    path = ROOT / "samples/stress/scenarios" / f"{scenario}.lua"
    return path.read_text().split("\n")[0].removeprefix("-- ") if path.exists() else ""


def number(value):
    """A number as people read it: 12,345 or 3.21."""
    return f"{value:,.0f}" if abs(value) >= 100 or value == int(value) else f"{value:.3g}"


def plot(title, values, seconds, other=None, width=260, height=104):
    """A curve over the run, as SVG, from 0 to its largest value; that of another build behind it in grey."""
    top = max(values + (other or []) + [1e-9])
    low, high = height - 16, 14

    def line(points, colour):
        step = width / max(1, len(points) - 1)
        path = " ".join(f"{i * step:.1f},{low - value / top * (low - high):.1f}" for i, value in enumerate(points))
        return f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.2"/>'

    curves = (line(other, "#aaa") if other else "") + line(values, "#06c")
    axis = (f'<path d="M0 {low}H{width}M0 {high}H{width}" stroke="#ddd"/>'
            f'<text x="2" y="{high - 3}">{number(top)}</text>'
            f'<text x="2" y="{height - 4}">0 s</text>'
            f'<text x="{width - 2}" y="{height - 4}" text-anchor="end">{number(seconds)} s</text>')
    return (f'<figure><svg width="{width}" height="{height}" style="background:#f8f8f8">{axis}{curves}</svg>'
            f"<figcaption>{html.escape(title)}</figcaption></figure>")


def plots(run, before):
    """All curves of a run. What was zero all the time is named in a line."""
    drawn, zero = [], []
    for title in PLOTS:
        values, other = run["plots"][title], before["plots"].get(title) if before else None
        if any(values) or any(other or []):
            drawn.append(plot(title, values, run["steps"] / 60, other))
        else:
            zero.append(title.split(",")[0])
    return "".join(drawn) + (f"<p>Zero in every step: {', '.join(zero)}.</p>" if zero else "")


def images(folder, run):
    """The drawn games of a run."""
    found = []
    name = re.compile(re.escape(f"{run['scenario']}_{run['seed']}_") + r"(\d+)\.png")
    paths = [path for path in pathlib.Path(folder).glob("*.png") if name.fullmatch(path.name)]
    for path in sorted(paths, key=lambda path: int(name.fullmatch(path.name)[1])):
        data = base64.b64encode(path.read_bytes()).decode()
        found.append(f'<figure><img width="360" src="data:image/png;base64,{data}"></figure>')
    return "".join(found)


def cell(value, before, larger_is_worse=True):
    """A cell of a table; what it was in another build behind it, marked if it has changed by more than a tenth."""
    if before is None:
        return f"<td>{value:.2f}</td>"
    mark = ""
    if abs(value - before) > 0.1 * max(abs(before), 0.05):
        mark = ' class="bad"' if (value > before) == larger_is_worse else ' class="good"'
    return f"<td{mark}>{value:.2f} <small>({before:.2f})</small></td>"


def held(run):
    """What is said of a run without a failure."""
    return "all checks held" + (" until it was interrupted" if run.get("interrupted") else "")


def step_processor(run):
    """Processor time of a step, in ms; an old file has none."""
    seconds = run.get("processor_seconds", {}).get("steps", 0.0)
    return 1000 * seconds / max(1, run["steps"])


def differences(run, before):
    """Options on which the steps of a run depend, and which another run had otherwise; old files say none."""
    words = {"minutes": "--minutes", "check_every": "--check-every", "threads": "--threads"}
    return [f"{word} {run[key]}, was {before[key]}" for key, word in words.items()
            if key in run and key in before and run[key] != before[key]]


def comparison(run, before):
    """What the last column says of another build."""
    if not before:
        return ""
    other = differences(run, before)
    if other:
        return "; hashes not compared: " + html.escape(", ".join(other))
    return "; same hash" if before["hash"] == run["hash"] else "; other hash"


def row(run, before):
    """The row of a run in the table of all."""
    failure = run.get("failure")
    state = f"step {failure['step']}: {failure['check']}: {failure['message']}" if failure else held(run)
    times = run["ms_p50_p95_p99_max"]["step"]
    old = before["ms_p50_p95_p99_max"]["step"] if before else [None] * 4
    peak = max(run["plots"]["heap, MiB"] or [0])
    old_peak = max(before["plots"]["heap, MiB"] or [0]) if before else None
    scenario = html.escape(run["scenario"])
    return (f'<tr><td><a href="#{scenario} {run["seed"]}">{scenario}, seed {run["seed"]}</a></td>'
            f'<td>{run["steps"]}</td><td>{run["replayed_steps"]}</td>'
            + "".join(cell(value, was) for value, was in zip(times, old))
            + cell(step_processor(run), step_processor(before) if before else None) + cell(peak, old_peak)
            + f'<td>{max(run["plots"]["bodies"] or [0]):g}</td>'
            + f'<td class="text{" bad" if failure else ""}">{html.escape(state)}{comparison(run, before)}</td></tr>')


def processor(run):
    """How much processor time a run took, and what for."""
    seconds = run.get("processor_seconds", {})
    total = sum(seconds.values())
    parts = [f"{name} {100 * value / total:.0f} %" for name, value in sorted(seconds.items(), key=lambda row: -row[1])
             if value >= 0.005 * total > 0]
    where = "".join(f" {word} {html.escape(run[key])}." for word, key in (("Build", "build"), ("Machine:", "machine"))
                    if run.get(key))
    return f"<p>{number(total)} s of processor time: {', '.join(parts)}.{where}</p>" if parts else ""


def details(folder, run, before):
    """Plots, stages and images of a run."""
    rows = ""
    for stage, meaning in STAGES.items():
        old = before["ms_p50_p95_p99_max"][stage] if before else [None] * 4
        rows += f"<tr><td>{stage}</td>" + "".join(
            cell(value, was) for value, was in zip(run["ms_p50_p95_p99_max"][stage], old)) + (
                f'<td class="text">{meaning}</td></tr>')
    failure = run.get("failure")
    script = ""
    if failure:
        what = html.escape(f"{failure['check']}: {failure['message']}")
        script = f'<p class="bad">Step {failure["step"]}: {what}</p>'
        if failure["script"]:
            script += f"<p>This fails the same way:</p><pre>{html.escape(failure['script'])}</pre>"
        elif failure.get("no_script"):
            script += f"<p>There is no short script: {html.escape(failure['no_script'])}.</p>"
    if run.get("command"):
        script += f"<p>Again: <code>{html.escape(run['command'])}</code></p>"
    scenario = html.escape(run["scenario"])
    return (f'<h2 id="{scenario} {run["seed"]}">{scenario}, seed {run["seed"]}</h2>'
            f'<p>{html.escape(describe(run["scenario"]))}</p>'
            f"{script}{images(folder, run)}{processor(run)}<div>{plots(run, before)}</div>"
            f'<table><tr><th>stage of a step, ms</th><th>p50</th><th>p95</th><th>p99</th><th>max</th>'
            f'<th class="text">what it does</th></tr>{rows}</table>')


def count(number, word):
    return f"{number:,} {word}" + ("" if number == 1 else "s")


def summary(folder):
    """How many runs there are, and what came of them."""
    runs = folder.runs.values()
    failed = sum("failure" in run for run in runs)
    interrupted = sum(bool(run.get("interrupted")) and "failure" not in run for run in runs)
    counts = {"failed": failed, "interrupted, all checks held until then": interrupted,
              "ended without figures": len(folder.ended), "unreadable": len(folder.damaged)}
    parts = [f"{number} {what}" for what, number in counts.items() if number]
    good = len(runs) - failed - interrupted
    if not parts:
        parts = ["all checks held in all of them" if good > 1 else "all checks held"]
    elif good:
        parts.append(f"all checks held in {good}")
    total = len(runs) + len(folder.ended) + len(folder.damaged)
    return f"{count(total, 'run')}, {count(sum(run['steps'] for run in runs), 'step')}: {'; '.join(parts)}"


def without_figures(folder):
    """Rows of the table of all for runs that have no figures."""
    rows = [(f"{name}, seed {seed}", "ended without figures, or still goes on") for name, seed in folder.ended]
    rows += [(name, f"unreadable: {reason}") for name, reason in folder.damaged.items()]
    return "".join(f'<tr><td>{html.escape(name)}</td><td colspan="9"></td>'
                   f'<td class="text bad">{html.escape(what)}</td></tr>' for name, what in rows)


def only_one_side(folder, others):
    """What is said of runs that only one of two folders has."""
    def names(keys):
        return html.escape(", ".join(f"{name} {seed}" for name, seed in sorted(keys)))

    text = ""
    for where, keys in (("this folder", folder.runs.keys() - others.runs.keys()),
                        ("the other folder", others.runs.keys() - folder.runs.keys())):
        text += f"<p>Only in {where}: {names(keys)}.</p>" if keys else ""
    for name, reason in others.damaged.items():
        text += f'<p class="bad">Unreadable in the other folder: {html.escape(name)}: {html.escape(reason)}</p>'
    return text


def headline(folder, others):
    """What was done and what came of it, for someone who sees such a page for the first time."""
    words = "".join(f"<dt>{name}</dt><dd>{meaning}</dd>" for name, meaning in COLUMNS.items())
    head = (f"<h1>Stress scenarios</h1><p><b>{summary(folder)}.</b></p>"
            "<p>Each run is a script that breaks things in a world of voxels, with a seed for everything random. After "
            "every step: no voxel is lost or appears, handles are of things that are there, motion is finite, mass is "
            "that of the voxels, no energy comes from nowhere, lights are on something. Every few seconds: the budgets "
            "of pieces hold, the shadow volume is that of a world built from scratch, a saved game goes on as the one "
            "that was saved, the hash tells worlds apart, and recordings give the same hashes again, with two threads "
            "and without the script.</p>"
            f"<details><summary>What the words mean</summary><dl>{words}</dl></details>")
    if others:
        head += "<p>In brackets and grey: the other folder. Red: worse by more than a tenth; green: better.</p>"
        head += only_one_side(folder, others)
    return head


def page(path, folder, others=None):
    """The whole page of a folder, whose images lie at a path."""
    before = others.runs if others else {}
    table = ('<table><tr><th>scenario</th><th>steps</th><th>replayed</th><th>p50, ms</th><th>p95</th><th>p99</th>'
             '<th>max</th><th>processor, ms</th><th>heap, MiB</th><th>bodies</th><th class="text">result</th></tr>'
             + "".join(row(run, before.get(key)) for key, run in folder.runs.items())
             + without_figures(folder) + "</table>")
    body = "".join(details(path, run, before.get(key)) for key, run in folder.runs.items())
    return (f"<!doctype html><meta charset=utf-8><title>Stress scenarios</title><style>{STYLE}</style>"
            f"{headline(folder, others)}{table}{body}")


TITLE = "# Stress scenarios"
ENVELOPE = [TITLE, "",
            "What the engine has gone through with everything checked at every step "
            "([docs/stress.md](docs/stress.md)). Each row is a run, with its build and its machine; bodies, "
            "contacts and memory are the most at once, the time of a step is the mean processor time of all threads. "
            "Written by `./rubble stress report FOLDER --publish`, which replaces the rows of the runs in FOLDER; do "
            "not edit.", "",
            "| scenario | seed | minutes | steps replayed | bodies | contacts | voxels removed | loads | heap, MiB | "
            "ms a step | build | machine | result |", "|" + " --- |" * 13]


def envelope_row(run):
    """The row of a run in OPERATING_ENVELOPE.md."""
    def most(title):
        return number(max(run["plots"][title] or [0]))

    failure = run.get("failure")
    result = f"{failure['check']} at step {failure['step']}" if failure else held(run)
    return (f"| {run['scenario']} | {run['seed']} | {number(run['steps'] // 60 / 60)} | {run['replayed_steps']:,} | "
            f"{most('bodies')} | {most('contacts')} | {most('removed voxels')} | {run['loads']} | "
            f"{most('heap, MiB')} | {step_processor(run):.2f} | "
            f"{run.get('build') or 'unknown'} | {run.get('machine') or 'unknown'} | {result} |")


def published_rows(part):
    """The rows of a table that envelope() has written, by scenario and seed."""
    rows = {}
    for line in part.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("| ") and len(cells) == 13 and cells[1].isdigit():
            rows[cells[0], int(cells[1])] = line
    return rows


def minutes_of(row):
    """How long the run of a row was."""
    return float(row.split("|")[3].replace(",", ""))


def envelope(runs, before=""):
    """The part of OPERATING_ENVELOPE.md with the rows of these runs, and those of other runs that it had before. A
    shorter run replaces no longer one."""
    rows = published_rows(before)
    for key, run in runs.items():
        line = envelope_row(run)
        if key in rows and minutes_of(rows[key]) > minutes_of(line):
            print(f"kept: {key[0]}, seed {key[1]}: the published run is longer")
        else:
            rows[key] = line
    return "\n".join(ENVELOPE + [rows[key] for key in sorted(rows)]) + "\n"


def publish(runs):
    """Puts the rows of these runs into the last part of OPERATING_ENVELOPE.md."""
    path = ROOT / "OPERATING_ENVELOPE.md"
    before, _, part = path.read_text().partition(f"\n{TITLE}\n")
    before = before.rstrip("\n")
    path.write_text(f"{before}\n\n{envelope(runs, part)}")
    print(f"published: {path}")


def main():
    parser = argparse.ArgumentParser(description="The page of a folder of stress runs")
    parser.add_argument("folder")
    parser.add_argument("--compare", metavar="OTHER", help="a folder of another build's runs")
    parser.add_argument("--publish", action="store_true",
                        help="write the rows of these runs into OPERATING_ENVELOPE.md")
    parser.add_argument("--build", help="the commit of runs that do not say theirs")
    parser.add_argument("--machine", help="the machine of runs that do not say theirs")
    options = parser.parse_args()
    folder = Folder(options.folder)
    others = Folder(options.compare) if options.compare else None
    for path, each in ((options.folder, folder), (options.compare, others)):
        for name, reason in each.damaged.items() if each else ():
            print(f"stress report: {pathlib.Path(path) / name}: {reason}", file=sys.stderr)
    for run in folder.runs.values():
        run["build"] = run.get("build") or options.build
        run["machine"] = run.get("machine") or options.machine
    if not (folder.runs or folder.ended or folder.damaged):
        sys.exit(f"stress report: expected NAME_SEED.json files in {options.folder}, found none")
    if others and not others.runs.keys() & folder.runs.keys():
        sys.exit(f"stress report: --compare: expected runs of the same names in {options.compare}, found none")
    target = pathlib.Path(options.folder) / "report.html"
    target.write_text(page(options.folder, folder, others), encoding="utf-8")
    print(f"report: {target}")
    if options.publish:
        publish(folder.runs)
    if folder.damaged or (others and others.damaged):
        sys.exit(1)


if __name__ == "__main__":
    main()
