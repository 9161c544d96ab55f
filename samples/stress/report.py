#!/usr/bin/env python3
"""The page of a folder of runs: ./rubble stress report FOLDER [--compare OTHER].

Reads NAME_SEED.json files, and writes FOLDER/report.html: a table of all runs, then for each run its plots, images and
what failed. With --compare the figures of another folder, as of another build, stand beside them, and changes of more
than a tenth are marked."""
import argparse
import base64
import html
import json
import pathlib
import sys

STYLE = """body{font:15px/1.5 sans-serif;max-width:1180px;margin:2em auto;padding:0 1em;color:#222}
table{border-collapse:collapse;font-size:13px}td,th{padding:2px 9px;text-align:right;border-bottom:1px solid #ddd}
td:first-child,th:first-child,td.text{text-align:left}.bad{background:#fdd}.good{background:#dfd}
h2{margin-top:2em;border-top:2px solid #888;padding-top:.5em}figure{display:inline-block;margin:6px}
figcaption{font-size:12px;color:#555}pre{background:#f4f4f4;padding:8px;overflow-x:auto}"""
STAGES = ["edits", "physics", "poses", "impacts", "shadow", "step"]


def load(folder):
    """The runs of a folder, by name and seed."""
    runs = {}
    for path in sorted(pathlib.Path(folder).glob("*_*.json")):
        run = json.loads(path.read_text())
        runs[run["scenario"], run["seed"]] = run
    return runs


def plot(title, values, other=None, width=260, height=90):
    """A curve over the run, as SVG; that of another build behind it in grey."""
    top = max(values + (other or []) + [1e-9])

    def line(points, colour):
        step = width / max(1, len(points) - 1)
        path = " ".join(f"{i * step:.1f},{height - 2 - value / top * (height - 6):.1f}" for i, value in enumerate(points))
        return f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.2"/>'

    curves = (line(other, "#aaa") if other else "") + line(values, "#06c")
    return (f'<figure><svg width="{width}" height="{height}" style="background:#f8f8f8">{curves}</svg>'
            f"<figcaption>{html.escape(title)}: up to {top:g}</figcaption></figure>")


def images(folder, run):
    """The drawn games of a run."""
    found = []
    for path in sorted(pathlib.Path(folder).glob(f"{run['scenario']}_{run['seed']}_*.png")):
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


def row(run, before):
    """The row of a run in the table of all."""
    failure = run.get("failure")
    state = f"step {failure['step']}: {failure['check']}: {failure['message']}" if failure else "all checks held"
    times = run["ms_p50_p95_p99_max"]["step"]
    old = before["ms_p50_p95_p99_max"]["step"] if before else [None] * 4
    peak = max(run["plots"]["heap, MiB"] or [0])
    old_peak = max(before["plots"]["heap, MiB"] or [0]) if before else None
    same = "" if not before else (" same hash" if before["hash"] == run["hash"] else " other hash")
    name = f"{run['scenario']} {run['seed']}"
    return (f'<tr><td><a href="#{name}">{name}</a></td><td>{run["steps"]}</td><td>{run["replayed_steps"]}</td>'
            + "".join(cell(value, was) for value, was in zip(times, old)) + cell(peak, old_peak)
            + f'<td>{max(run["plots"]["bodies"] or [0]):g}</td>'
            + f'<td class="text{" bad" if failure else ""}">{html.escape(state)}{same}</td></tr>')


def details(folder, run, before):
    """Plots, stages and images of a run."""
    rows = ""
    for stage in STAGES:
        old = before["ms_p50_p95_p99_max"][stage] if before else [None] * 4
        rows += f"<tr><td>{stage}</td>" + "".join(
            cell(value, was) for value, was in zip(run["ms_p50_p95_p99_max"][stage], old)) + "</tr>"
    plots = "".join(plot(title, values, before["plots"].get(title) if before else None)
                    for title, values in run["plots"].items())
    failure = run.get("failure")
    script = f"<pre>{html.escape(failure['script'] or failure['message'])}</pre>" if failure else ""
    name = f"{run['scenario']} {run['seed']}"
    return (f'<h2 id="{name}">{name}</h2>{script}{images(folder, run)}<div>{plots}</div>'
            f"<table><tr><th>stage, ms</th><th>p50</th><th>p95</th><th>p99</th><th>max</th></tr>{rows}</table>")


def page(folder, runs, others):
    """The whole page."""
    failed = sum("failure" in run for run in runs.values())
    steps = sum(run["steps"] for run in runs.values())
    head = (f"<h1>Stress scenarios</h1><p>{len(runs)} runs, {steps} steps, {failed} failed. Every step: voxels accounted "
            "for, handles, motion, mass, energy, budgets, lights; every few seconds: the shadow volume against a rebuilt "
            "one, hashes, and a replay of the recording with two threads.</p>")
    if others:
        head += "<p>In brackets and grey: the other folder. Red: worse by more than a tenth.</p>"
    table = ("<table><tr><th>scenario, seed</th><th>steps</th><th>replayed</th><th>p50 ms</th><th>p95</th><th>p99</th>"
             "<th>max</th><th>heap MiB</th><th>bodies</th><th>result</th></tr>"
             + "".join(row(run, others.get(key)) for key, run in runs.items()) + "</table>")
    body = "".join(details(folder, run, others.get(key)) for key, run in runs.items())
    return f"<!doctype html><meta charset=utf-8><title>Stress scenarios</title><style>{STYLE}</style>{head}{table}{body}"


def main():
    parser = argparse.ArgumentParser(description="The page of a folder of stress runs")
    parser.add_argument("folder")
    parser.add_argument("--compare", metavar="OTHER", help="a folder of another build's runs")
    options = parser.parse_args()
    runs = load(options.folder)
    if not runs:
        sys.exit(f"stress report: expected NAME_SEED.json files in {options.folder}, found none")
    others = load(options.compare) if options.compare else {}
    target = pathlib.Path(options.folder) / "report.html"
    target.write_text(page(options.folder, runs, others))
    print(f"report: {target}")


if __name__ == "__main__":
    main()
