#!/usr/bin/env python3
"""Serves the page of samples/hosts/web, as any static file server can, or lets headless Chromium play its script.

    serve.py PAGE [--port N]                  serves the folder until Ctrl+C
    serve.py PAGE --script OUT [OPTIONS...]   plays the script: images go to the folder OUT, lines to standard output.
                                              OPTIONS are those of the page, as size=320x240 or speed=10
"""

import argparse
import functools
import http.server
import os
import pathlib
import queue
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

# The system's OpenGL: Chromium's own software renderer takes several times as long as Mesa's.
CHROMIUM = ["chromium", "--headless", "--no-sandbox", "--use-angle=gl-egl", "--ignore-gpu-blocklist", "--disable-dev-shm-usage"]

PRESET = "(draft|fast|balanced|accurate)"
NUMBER = "[1-9][0-9]{0,5}"
# Options of the page in a script: what they are, and the values that they take.
OPTIONS = {
    "size": ("WIDTHxHEIGHT, each 1 to 9999", "[1-9][0-9]{0,3}x[1-9][0-9]{0,3}"),
    "preset": ("draft, fast, balanced or accurate", PRESET),
    "presets": ("names of presets with commas between them", f"{PRESET}(,{PRESET})*"),
    "speed": ("whole seconds, 1 to 999999", NUMBER),
    "cycles": ("a whole number, 1 to 999999", NUMBER),
    "skip": ("1", "1"),
}

# What ends the program, as (kind, value): "end" or "failed" and the script's lines, "closed" and the browser's errors,
# "signal" and its number. Signal handlers may put into such a queue.
events = queue.SimpleQueue()


class Page(http.server.SimpleHTTPRequestHandler):
    """Files of a folder, and what a script reports: images, and at the end the lines of the program."""

    out = None  # folder of images

    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, ".wasm": "application/wasm"}

    def send_head(self):
        try:
            return super().send_head()
        except (OSError, ValueError):  # no path of a file, such as one with a zero byte
            self.send_error(404, "File not found")
            return None

    def do_POST(self):
        name = re.fullmatch("/report/([A-Za-z0-9_]+)", self.path)
        length = self.headers["Content-Length"] or ""
        if not name:
            self.send_error(404, "expected report/NAME")
            return
        if not re.fullmatch("[0-9]{1,9}", length):
            self.send_error(411, "expected a Content-Length")
            return
        body = self.rfile.read(int(length))
        if Page.out:
            self.keep(name[1], body)
        self.send_response(204)
        self.end_headers()

    def keep(self, name, body):
        """Writes an image, or passes on the end of a script."""
        if name in ("end", "failed"):
            events.put((name, body.decode(errors="replace")))
            return
        try:
            (Page.out / f"{name}.png").write_bytes(body)
        except OSError as error:
            events.put(("failed", f"{error.filename}: {error.strerror}"))

    def log_message(self, *arguments):
        pass


class Server(http.server.ThreadingHTTPServer):
    def handle_error(self, request, address):
        if not isinstance(sys.exc_info()[1], ConnectionError):
            super().handle_error(request, address)


class Browser:
    """Headless Chromium, in a process group of its own, with all of its temporary files in one folder."""

    def __init__(self, address):
        self.folder = tempfile.mkdtemp(prefix="rubble-web-")
        try:
            self.process = subprocess.Popen(
                [*CHROMIUM, f"--user-data-dir={self.folder}/profile", address], env={**os.environ, "TMPDIR": self.folder},
                start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace")
        except OSError as error:
            self.remove_folder()
            fail(f"expected the program chromium: {error.strerror}")
        self.watch = threading.Thread(target=self.wait_for_end, daemon=True)
        self.watch.start()

    def wait_for_end(self):
        """Until all processes that hold its standard error are gone."""
        events.put(("closed", self.process.communicate()[1]))

    def end(self):
        """Ends all of its processes, waits for them, and removes its files."""
        for number in (signal.SIGTERM, signal.SIGKILL):
            try:
                os.killpg(self.process.pid, number)
            except ProcessLookupError:
                pass
            self.watch.join(10)
        self.remove_folder()

    def remove_folder(self):
        """A process that is being killed may still write to it: hence more than one try."""
        for _ in range(50):
            shutil.rmtree(self.folder, ignore_errors=True)
            if not os.path.exists(self.folder):
                return
            time.sleep(0.1)


def play_script(server, out, options):
    """Starts a browser, waits for the end of its script, and prints the lines of it. Returns an exit code."""
    Page.out = pathlib.Path(out)
    try:
        Page.out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        fail(f'--script: expected a folder to write images to, found "{out}": {error.strerror}')
    browser = Browser(f"http://127.0.0.1:{server.server_port}/?{'&'.join(['script=1', *options])}")
    try:
        kind, value = events.get()
    finally:
        browser.end()
    if kind == "signal":
        return 128 + value
    if kind == "closed":
        print(f"rubble host web: the browser ended before the script did:\n{value}", file=sys.stderr)
        return 1
    for line in value.splitlines():
        # Images are named by their files.
        print(f"{Page.out}/{line.replace(':', '.png:', 1)}" if ": pieces " in line else line)
    return 0 if kind == "end" else 1


def fail(text):
    print(f"rubble host web: {text}", file=sys.stderr)
    sys.exit(2)


def open_server(arguments):
    """A server for the page's folder. Ends the program with a line where there can be none."""
    if not (pathlib.Path(arguments.page) / "index.html").is_file():
        fail(f'expected the folder of the page, found "{arguments.page}"')
    if not re.fullmatch("[0-9]{1,5}", arguments.port) or int(arguments.port) > 65535:
        fail(f'--port: expected 0 to 65535, found "{arguments.port}"')
    handler = functools.partial(Page, directory=arguments.page)
    port = int(arguments.port) if arguments.script is None else 0
    try:
        return Server(("127.0.0.1", port), handler)
    except OSError as error:
        return fail(f"--port {port}: {error.strerror}")


def check_options(options, is_script):
    """Ends the program with a line if the page has no such option, or no such value of it."""
    for option in options:
        name, _, value = option.partition("=")
        if "=" not in option or name not in OPTIONS:
            fail(f'expected --port N, --script OUT, or with a script {"=, ".join(OPTIONS)}=; found "{option}"')
        expected, pattern = OPTIONS[name]
        if not re.fullmatch(pattern, value):
            fail(f'{name}: expected {expected}, found "{value}"')
        if not is_script:
            fail(f'{option}: expected --script OUT with it; without a script it belongs into the address, as in /?{option}')


class Parser(argparse.ArgumentParser):
    def error(self, message):
        fail(message)


def main():
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda number, frame: events.put(("signal", number)))
    parser = Parser(prog="rubble host web", description="Serves the page of the browser host.", allow_abbrev=False)
    parser.add_argument("page")
    parser.add_argument("--port", default="8080", help="0: any")
    parser.add_argument("--script", metavar="OUT")
    parser.add_argument("options", nargs="*")
    arguments, others = parser.parse_known_intermixed_args()
    check_options([*others, *arguments.options], arguments.script is not None)
    if arguments.script == "":
        fail('--script: expected a folder to write images to, found ""')
    server = open_server(arguments)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    if arguments.script is not None:
        return play_script(server, arguments.script, arguments.options)
    print(f"http://127.0.0.1:{server.server_port}/ (Ctrl+C ends it)", flush=True)
    number = events.get()[1]
    return 0 if number == signal.SIGINT else 128 + number


if __name__ == "__main__":
    sys.exit(main())
