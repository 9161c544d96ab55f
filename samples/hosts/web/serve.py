#!/usr/bin/env python3
"""Serves the page of samples/hosts/web, as any static file server can, or lets headless Chromium play its script.

    serve.py PAGE [--port N]                  serves the folder until Ctrl+C
    serve.py PAGE --script OUT [OPTIONS...]   plays the script: images go to the folder OUT, lines to standard output.
                                              OPTIONS are those of the page, as size=320x240 or speed=10
"""

import argparse
import functools
import http.server
import pathlib
import subprocess
import sys
import tempfile
import threading

# The system's OpenGL: Chromium's own software renderer takes several times as long as Mesa's.
CHROMIUM = ["chromium", "--headless", "--no-sandbox", "--use-angle=gl-egl", "--ignore-gpu-blocklist", "--disable-dev-shm-usage"]


class Page(http.server.SimpleHTTPRequestHandler):
    """Files of a folder, and what a script reports: images, and at the end the lines of the program."""

    out = None  # folder of images
    result = None  # name and text of the last report
    is_over = threading.Event()

    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, ".wasm": "application/wasm"}

    def do_POST(self):
        name = pathlib.PurePosixPath(self.path.partition("?")[0]).name
        length = self.headers["Content-Length"] or ""
        if not length.isdecimal():
            self.send_error(411, "expected a Content-Length")
            return
        body = self.rfile.read(int(length))
        self.send_response(204)
        self.end_headers()
        if not Page.out:
            return
        if name in ("end", "failed"):
            Page.result = name, body.decode()
            Page.is_over.set()
        else:
            (Page.out / f"{name}.png").write_bytes(body)

    def log_message(self, *arguments):
        pass


class Server(http.server.ThreadingHTTPServer):
    def handle_error(self, request, address):
        if not isinstance(sys.exc_info()[1], ConnectionError):
            super().handle_error(request, address)


def play_script(server, out, options):
    """Starts a browser, waits for the end of its script, and prints the lines of it. Returns an exit code."""
    Page.out = pathlib.Path(out)
    Page.out.mkdir(parents=True, exist_ok=True)
    address = f"http://127.0.0.1:{server.server_port}/?{'&'.join(['script=1', *options])}"
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory() as profile:
        browser = subprocess.Popen([*CHROMIUM, f"--user-data-dir={profile}", address],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        errors = []
        watch = threading.Thread(target=lambda: (errors.append(browser.communicate()[1]), Page.is_over.set()), daemon=True)
        watch.start()
        Page.is_over.wait()
        browser.terminate()
        watch.join()
    if not Page.result:
        print("serve.py: the browser ended before the script did:\n" + "".join(errors), file=sys.stderr)
        return 1
    name, text = Page.result
    for line in text.splitlines():
        # Images are named by their files.
        print(f"{Page.out}/{line.replace(':', '.png:', 1)}" if ": pieces " in line else line)
    return 0 if name == "end" else 1


def fail(text):
    print(f"serve.py: {text}", file=sys.stderr)
    sys.exit(2)


def open_server(arguments):
    """A server for the page's folder. Ends the program with a line where there can be none."""
    if not (pathlib.Path(arguments.page) / "index.html").is_file():
        fail(f'expected the folder of the page, found "{arguments.page}"')
    if not 0 <= arguments.port <= 65535:
        fail(f"--port: expected 0 to 65535, found {arguments.port}")
    handler = functools.partial(Page, directory=arguments.page)
    port = 0 if arguments.script else arguments.port
    try:
        return Server(("127.0.0.1", port), handler)
    except OSError as error:
        return fail(f"--port {port}: {error.strerror}")


def main():
    parser = argparse.ArgumentParser(description="Serves the page of the browser host.")
    parser.add_argument("page")
    parser.add_argument("--port", type=int, default=8080, help="0: any")
    parser.add_argument("--script", metavar="OUT")
    parser.add_argument("options", nargs="*")
    arguments = parser.parse_intermixed_args()
    server = open_server(arguments)
    if arguments.script:
        return play_script(server, arguments.script, arguments.options)
    print(f"http://127.0.0.1:{server.server_port}/ (Ctrl+C ends it)")
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        pass
    return 0


if __name__ == "__main__":
    sys.exit(main())
