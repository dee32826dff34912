#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`crossgrain view`: serves the files of one folder to this machine, and nothing else."""

import contextlib
import http.client
import os
import re
import signal
import socket
import stat
import subprocess
import time
import unittest
import urllib.error
import urllib.request

from program import PROGRAM, CommandTest

USAGE, INPUT, OUTPUT = 2, 3, 4
PAGE = "<!doctype html><title>A field</title>"


class View(CommandTest):
    def setUp(self):
        super().setUp()
        self.field = self.folder / "part.frames"
        self.field.mkdir()
        (self.field / "report.html").write_text(PAGE)
        (self.field / "report.json").write_text('{"schema": 4}')
        (self.field / "field.vtu").write_bytes(bytes(range(256)) * 4000)

    def start(self, *arguments, **environment):
        """The address that is printed, and the running process."""
        variables = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER")}
        process = subprocess.Popen([PROGRAM, "view", "part.frames", *map(str, arguments)], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, cwd=self.folder, env={**variables, **environment})
        self.addCleanup(self.end, process)
        address = process.stdout.readline().decode().strip()
        self.assertRegex(address, r"^http://127\.0\.0\.1:\d+/report\.html$")
        return address, process

    @staticmethod
    def end(process):
        if process.poll() is None:
            process.kill()
        process.communicate()

    def serve(self):
        address, _ = self.start("--no-browser")
        self.port = int(re.search(r":(\d+)/", address).group(1))

    def ask(self, path, method="GET", **headers):
        """The response, its headers and its body; the path as it is."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        connection.putrequest(method, path, skip_host="Host" in headers, skip_accept_encoding=True)
        for name, value in headers.items():
            connection.putheader(name, value)
        connection.endheaders()
        response = connection.getresponse()
        body = response.read()
        connection.close()
        return response, body

    def status(self, path, **headers):
        return self.ask(path, **headers)[0].status

    def test_the_page_is_at_the_printed_address_and_at_the_root(self):
        address, _ = self.start("--no-browser")
        for url in (address, address.removesuffix("report.html")):
            with urllib.request.urlopen(url, timeout=20) as response:
                self.assertEqual(response.read().decode(), PAGE)
                self.assertEqual(response.url, address)

    def test_files_have_their_type_and_are_not_cached(self):
        self.serve()
        for name, kind in (("report.html", "text/html"), ("report.json", "application/json"), ("field.vtu", "application/xml")):
            response, body = self.ask("/" + name)
            self.assertEqual(response.status, 200)
            self.assertTrue(response.headers["Content-Type"].startswith(kind))
            self.assertEqual(response.headers["Cache-Control"], "no-store")
            self.assertEqual(body, (self.field / name).read_bytes())

    def test_heads_and_ranges(self):
        self.serve()
        content = (self.field / "field.vtu").read_bytes()
        response, body = self.ask("/field.vtu", "HEAD")
        self.assertEqual((response.status, body), (200, b""))
        self.assertEqual(int(response.headers["Content-Length"]), len(content))
        response, body = self.ask("/field.vtu", Range="bytes=1000-600000")
        self.assertEqual(response.status, 206)
        self.assertEqual(body, content[1000:600001])

    def test_an_empty_file_is_served(self):
        (self.field / "empty.json").write_bytes(b"")
        self.serve()
        self.assertEqual(self.ask("/empty.json")[1], b"")

    def test_what_is_not_a_file_of_the_folder_is_not_there(self):
        self.write("secret.txt", "secret")
        (self.field / ".hidden").write_text("secret")
        (self.field / "below").mkdir()
        (self.field / "below" / "deep.txt").write_text("secret")
        (self.field / "link.txt").symlink_to(self.folder / "secret.txt")
        os.mkfifo(self.field / "pipe")
        self.serve()
        for path in ("/none", "/../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/below/../../secret.txt", "//secret.txt",
                     str(self.folder / "secret.txt"), "/.hidden", "/%2ehidden", "/below", "/below/deep.txt", "/link.txt", "/pipe",
                     "/..", "/.", "/report.html%00.txt"):
            with self.subTest(path=path):
                response, body = self.ask(path)
                self.assertIn(response.status, (400, 404))
                self.assertNotIn(b"secret", body)

    def test_a_link_within_the_folder_is_a_file(self):
        (self.field / "same.json").symlink_to("report.json")
        self.serve()
        self.assertEqual(self.status("/same.json"), 200)

    def test_only_requests_for_this_machine_are_answered(self):
        self.serve()
        for host in (f"127.0.0.1:{self.port}", f"localhost:{self.port}"):
            self.assertEqual(self.status("/report.html", Host=host), 200)
        for host in ("example.com", f"example.com:{self.port}", "127.0.0.1:1", f"localhost.example.com:{self.port}", "localhost"):
            response, body = self.ask("/report.html", Host=host)
            self.assertEqual(response.status, 403, host)
            self.assertNotIn(b"field", body)

    def test_nothing_can_be_sent_to_it(self):
        self.serve()
        for method in ("POST", "PUT", "DELETE"):
            self.assertIn(self.ask("/report.json", method)[0].status, (400, 404))
        self.assertEqual((self.field / "report.json").read_text(), '{"schema": 4}')

    @contextlib.contextmanager
    def connected(self, count, sent=b""):
        """So many connections that send this and then nothing."""
        with contextlib.ExitStack() as stack:
            for _ in range(count):
                connection = stack.enter_context(socket.create_connection(("127.0.0.1", self.port), timeout=20))
                connection.sendall(sent)
            yield

    def assert_once_within(self, seconds, act):
        """A busy machine can delay an act, and none can hasten it: one that is in time of several will do."""
        taken = []
        while len(taken) < 5 and (not taken or taken[-1] >= seconds):
            taken.append(act())
        self.assertLess(min(taken), seconds, taken)

    def seconds_to_answer_beside(self, count, sent=b""):
        with self.connected(count, sent):
            start = time.monotonic()
            self.assertEqual(self.status("/report.json"), 200)
            return time.monotonic() - start

    def test_a_request_beside_500_idle_connections_is_answered_within_a_second(self):
        self.serve()
        for sent in (b"", b"GET /report.json HTTP/1.1\r\nHo"):
            self.assert_once_within(1, lambda sent=sent: self.seconds_to_answer_beside(500, sent))

    def test_more_connections_than_it_serves_at_once_delay_others_by_little(self):
        self.serve()
        # Those that send nothing are closed after a second, which makes room.
        self.assert_once_within(3, lambda: self.seconds_to_answer_beside(900))

    def test_idle_connections_do_not_delay_its_end(self):
        def act():
            address, process = self.start("--no-browser")
            self.port = int(re.search(r":(\d+)/", address).group(1))
            with self.connected(100):
                self.ask("/report.html")  # after these connections, so that they have been accepted
                start = time.monotonic()
                process.send_signal(signal.SIGTERM)
                self.assertEqual(process.wait(timeout=60), 0)
                return time.monotonic() - start
        self.assert_once_within(2, act)

    def seconds_of_a_slow_request(self, act):
        """How long a connection lasts that sends a byte of a request's head from time to time; `act` is called once it has begun."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=20) as connection:
            start = time.monotonic()
            connection.sendall(b"GET /report.json HTTP/1.1\r\nX: ")
            self.ask("/report.html")  # afterwards it has been accepted
            act()
            connection.settimeout(0.3)
            while time.monotonic() < start + 60:
                with contextlib.suppress(TimeoutError, ConnectionError):
                    connection.sendall(b"x")
                    if connection.recv(100):
                        continue
                    return time.monotonic() - start
            return 60

    def test_a_slow_request_does_not_delay_its_end(self):
        def act():
            address, process = self.start("--no-browser")
            self.port = int(re.search(r":(\d+)/", address).group(1))
            taken = self.seconds_of_a_slow_request(lambda: process.send_signal(signal.SIGINT))
            self.assertEqual(process.wait(timeout=60), 0)
            return taken
        self.assert_once_within(2, act)

    def test_a_slow_request_is_closed(self):
        self.serve()
        self.assertLess(self.seconds_of_a_slow_request(lambda: None), 20)

    def test_a_page_may_run_what_it_contains_and_load_nothing(self):
        self.serve()
        for path in ("/report.html", "/none"):
            policy = dict(part.strip().split(" ", 1) for part in self.ask(path)[0].headers["Content-Security-Policy"].split(";"))
            self.assertEqual(policy["default-src"], "'none'")
            for sources in policy.values():
                for source in sources.split():
                    self.assertIn(source, ("'none'", "'unsafe-inline'", "data:", "blob:"))

    def test_signals_end_it_and_that_is_no_error(self):
        # At once, so that it may not yet have begun to serve.
        for number in 3 * (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            _, process = self.start("--no-browser")
            process.send_signal(number)
            self.assertEqual(process.wait(timeout=20), 0)

    def test_the_port_can_be_chosen_and_a_taken_one_is_told(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        address, _ = self.start("--no-browser", "--port", port)
        self.assertIn(f":{port}/", address)
        self.assert_fails(self.run_here("view", "part.frames", "--no-browser", "--port", port), OUTPUT, str(port), "--port")

    def test_folders_without_a_page_are_refused(self):
        (self.field / "report.html").unlink()
        self.assert_fails(self.run_here("view", "part.frames"), INPUT, "part.frames", "report.html", "--no-report")
        self.assert_fails(self.run_here("view", "none.frames"), INPUT, "none.frames", "no such folder")
        self.write("file", "")
        self.assert_fails(self.run_here("view", "file"), INPUT, "file", "not a folder")

    def test_ports_that_are_none_are_refused(self):
        for port in ("0", "65536", "-1", "http"):
            self.assert_fails(self.run_here("view", "part.frames", "--port", port), USAGE, "--port")

    def make_browser(self):
        """A program that writes down what it is started with and then goes on for long."""
        path = self.write("browser", f'#!/bin/sh\necho "$@" > "{self.folder}/opened.new"\n'
                                     f'mv "{self.folder}/opened.new" "{self.folder}/opened"\nexec sleep 5\n')
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return str(path)

    def opened(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end and not (self.folder / "opened").exists():
            time.sleep(0.02)
        return (self.folder / "opened").read_text().split() if (self.folder / "opened").exists() else None

    def test_a_browser_is_started_where_there_is_a_display_and_not_waited_for(self):
        browser = self.make_browser()
        address, process = self.start(BROWSER=browser + " --new %s:other", DISPLAY=":99")
        self.assertEqual(self.opened(20), ["--new", address])
        with urllib.request.urlopen(address, timeout=20) as response:
            self.assertEqual(response.status, 200)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=4), 0)

    def test_without_a_display_no_browser_is_started(self):
        _, process = self.start(BROWSER=self.make_browser())
        self.assertIn(b"browser", process.stderr.readline())
        self.assertIsNone(self.opened(0.3))

    def test_no_browser_is_started_where_none_is_wanted(self):
        self.start("--no-browser", BROWSER=self.make_browser(), DISPLAY=":99")
        self.assertIsNone(self.opened(0.3))


if __name__ == "__main__":
    unittest.main()
