#!/usr/bin/env python3
"""The server of the browser host, with a program in place of Chromium: what it refuses, and what is left at its end."""

import http.client
import os
import re
import select
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SERVE = Path(__file__).resolve().parents[3] / 'samples/hosts/web/serve.py'

# Says where its temporary files are, and stays, with a child. Both hold the FIFO open.
CHROMIUM = '''#!/bin/sh
exec 3>"$STARTED"
echo file >"$TMPDIR/file"
sleep 1000 &
echo "$TMPDIR" >&3
wait
'''


class Serve(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / 'page').mkdir()
        (self.folder / 'page/index.html').write_text('the page')

    def start(self, *options, **environment):
        server = subprocess.Popen([sys.executable, SERVE, self.folder / 'page', *options], env={**os.environ, **environment},
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(server.kill)
        return server

    def end(self, server, number):
        """Its exit code, and what it wrote to standard error."""
        server.send_signal(number)
        errors = server.communicate(timeout=20)[1]
        return server.returncode, errors

    def test_options_are_refused_with_what_is_expected(self):
        out = str(self.folder / 'out')
        for options, expected in (
                (['--script', out, 'bogus=1'], 'expected --port N, --script OUT, or with a script size='),
                (['bogus'], 'found "bogus"'),
                (['--bogus'], 'found "--bogus"'),
                (['size=320x240'], 'expected --script OUT'),
                (['--script', out, 'speed=-1'], 'speed: expected whole seconds'),
                (['--script', out, 'cycles=1.5'], 'cycles: expected a whole number'),
                (['--script', out, 'size=0x10'], 'size: expected WIDTHxHEIGHT'),
                (['--script', out, 'presets=fast,best'], 'presets: expected names of presets'),
                (['--script', ''], '--script: expected a folder'),
                (['--script', '/dev/null/out'], '--script: expected a folder'),
                (['--port', '65536'], '--port: expected 0 to 65535')):
            with self.subTest(options=options):
                server = self.start(*options, PATH='')
                errors = server.communicate(timeout=20)[1]
                self.assertEqual(server.returncode, 2)
                self.assertRegex(errors, '^rubble host web: [^\n]*\n$')
                self.assertIn(expected, errors)

    def test_a_path_of_no_file_is_not_found(self):
        server = self.start('--port', '0')
        address = re.search('//(.*)/', server.stdout.readline())[1]
        for path, status in (('/', 200), ('/%00', 404), ('/%00/', 404), ('/%ff', 404), ('/' + 3000 * 'a', 404)):
            with self.subTest(path=path[:9]):
                connection = http.client.HTTPConnection(address)
                connection.request('GET', path)
                self.assertEqual(connection.getresponse().status, status)
                connection.close()
        self.assertEqual(self.end(server, signal.SIGINT), (0, ''))

    def test_a_signal_ends_all_of_the_browser(self):
        (self.folder / 'chromium').write_text(CHROMIUM)
        (self.folder / 'chromium').chmod(0o755)
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            with self.subTest(signal=number):
                fifo = self.folder / f'started_{number}'
                os.mkfifo(fifo)
                server = self.start('--script', str(self.folder / 'out'), STARTED=str(fifo),
                                    PATH=f'{self.folder}:{os.environ["PATH"]}')
                with open(fifo, 'rb', buffering=0) as started:
                    temporary = started.read(4096).decode().strip()
                    self.assertTrue(Path(temporary, 'file').is_file())
                    self.assertEqual(self.end(server, number), (128 + number, ''))
                    self.assertFalse(Path(temporary).exists())
                    is_over = select.select([started], [], [], 10)[0] and not started.read(1)
                    self.assertTrue(is_over, 'a process of the browser goes on')

    def test_without_chromium(self):
        server = self.start('--script', str(self.folder / 'out'), PATH='')
        self.assertIn('rubble host web: expected the program chromium', server.communicate(timeout=20)[1])
        self.assertEqual(server.returncode, 2)


if __name__ == '__main__':
    unittest.main()
