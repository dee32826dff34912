# SPDX-License-Identifier: Apache-2.0
"""crossgrain render, its files and its errors."""

import shutil
import signal
import struct
import subprocess
import time
import unittest
import zlib

import numpy as np
from program import PROGRAM, TIME_LIMIT, CommandTest, box_triangles, cylinder_triangles, run, stl_bytes


def read_png(path):
    """An array (height, width, channels) of an 8-bit PNG file without interlacing."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed, header = 8, b"", None
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + size]
        assert zlib.crc32(kind + body) == struct.unpack(">I", data[at + 8 + size : at + 12 + size])[0]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        packed += body if kind == b"IDAT" else b""
        at += 12 + size
    width, height, depth, colour = header[:4]
    channels = {2: 3, 6: 4}[colour]
    assert depth == 8
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + width * channels)
    image = np.zeros((height, width * channels), np.uint8)
    for y, row in enumerate(rows):
        above = image[y - 1] if y else np.zeros(width * channels, np.uint8)
        line = row[1:]
        if row[0] == 1:  # left of it: sums of each channel along the row
            image[y] = np.cumsum(line.reshape(width, channels), axis=0, dtype=np.uint8).ravel()
        elif row[0] == 2:
            image[y] = line + above
        else:
            assert row[0] == 0, "only the filters that are written"
            image[y] = line
    return image.reshape(height, width, channels)


class RenderTest(CommandTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.shared = CommandTest()
        cls.shared.setUp()
        cls.addClassCleanup(cls.shared.doCleanups)
        cls.shared.write("part.stl", stl_bytes(cylinder_triangles()))
        result = cls.shared.run_here("solve", "part.stl", "--resolution", 20, "--quiet")
        assert result.returncode == 0, result.stderr

    def setUp(self):
        super().setUp()
        shutil.copytree(self.shared.folder / "part.frames", self.folder / "part.frames")

    def render(self, *arguments, size="240x180"):
        result = self.run_here("render", "part.frames", "--size", size, *arguments)
        self.assert_succeeds(result)
        self.assertEqual(result.stderr, "")
        return result

    def picture(self, *arguments, size="240x180"):
        self.render("-o", "a.png", *arguments, size=size)
        return read_png(self.folder / "a.png")


class Files(RenderTest):
    def test_the_picture_is_named_after_the_folder_and_has_the_size(self):
        result = self.render()
        self.assertEqual(self.names(), ["part.frames", "part.png"])
        self.assertIn("240 x 180", result.stdout)
        self.assertEqual(read_png(self.folder / "part.png").shape, (180, 240, 3))

    def test_quiet_prints_nothing(self):
        self.assertEqual(self.render("--quiet").stdout, "")

    def test_the_bytes_are_the_same_every_time_and_for_any_number_of_threads(self):
        contents = set()
        for threads in (1, 2, 2):
            self.render("--cut", "z", "--colour", "alignment", "--threads", threads, "-o", "a.png")
            contents.add((self.folder / "a.png").read_bytes())
        self.assertEqual(len(contents), 1)

    def test_the_folder_of_the_field_stays_as_it_is(self):
        before = sorted(path.name for path in (self.folder / "part.frames").iterdir())
        self.render()
        self.assertEqual(sorted(path.name for path in (self.folder / "part.frames").iterdir()), before)


class Pixels(RenderTest):
    def test_background_is_where_nothing_is(self):
        light = self.picture("--without", "legend")
        self.assertEqual(light[0, 0].tolist(), [255, 255, 255])
        self.assertLess(self.picture("--without", "legend", "--background", "dark")[0, 0].max(), 40)
        clear = self.picture("--without", "legend", "--background", "transparent")
        self.assertEqual(clear[0, 0].tolist(), [0, 0, 0, 0])
        part = clear[:, :, 3] > 0
        self.assertGreater(part.mean(), 0.2)
        self.assertTrue((light[~part] == 255).all())

    def test_lines_are_seen_through_the_part(self):
        with_lines = self.picture("--without", "legend,creases").astype(int)
        without = self.picture("--without", "legend,creases,lines").astype(int)
        blueness = with_lines[:, :, 2] - with_lines[:, :, 0]
        self.assertGreater((blueness > 60).sum(), 50)
        self.assertEqual(((without[:, :, 2] - without[:, :, 0]) > 60).sum(), 0)

    def test_every_view_is_another(self):
        views = ["iso", "front", "back", "left", "right", "top", "bottom", "10,20", "200.5,-45"]
        pictures = {self.picture("--view", view).tobytes() for view in views}
        self.assertEqual(len(pictures), len(views))

    def test_a_named_view_is_the_one_of_its_angles(self):
        self.assertTrue((self.picture("--view", "front") == self.picture("--view=-90,0")).all())

    def test_cells_colour_a_surface_of_two_triangles_a_side(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        self.assert_succeeds(self.run_here("solve", "box.stl", "--resolution", 16, "--quiet"))
        arguments = ("render", "box.frames", "--view", "top", "--without", "legend,lines,creases",
                     "--size", "300x200", "--colour", "class", "-o", "box.png")
        self.assert_succeeds(self.run_here(*arguments))
        picture = read_png(self.folder / "box.png").astype(int)
        middle, rim = picture[100, 150], picture[100, 300 - 13]
        # A plane in the middle, a whole frame (green) in the cells along the edges.
        self.assertGreater(middle[2], middle[1])
        self.assertGreater(rim[1], rim[2])

    def test_a_cut_shows_frames_and_is_where_it_is_asked_for(self):
        pictures = {self.picture(*arguments).tobytes() for arguments in
                    ((), ("--cut", "z"), ("--cut", "z=0.2"), ("--cut", "z", "--frames", "crosses"),
                     ("--cut", "z", "--frames", "none"))}
        self.assertEqual(len(pictures), 5)


    def test_streamlines_are_drawn_where_they_have_been_traced(self):
        without = self.picture("--without", "lines")
        result = self.run_here("render", "part.frames", "--streamlines", "-o", "b.png")
        self.assert_fails(result, 3, "streamlines.vtu", "crossgrain streamlines")
        self.assert_succeeds(self.run_here("streamlines", "part.frames", "--count", 5, "--quiet"))
        self.assertFalse((self.picture("--without", "lines", "--streamlines") == without).all())


class Errors(RenderTest):
    def refused(self, code, *words_and_arguments, words=()):
        result = self.run_here("render", *words_and_arguments)
        self.assert_fails(result, code, *words)
        self.assertEqual([name for name in self.names() if name.endswith(".png") or name.startswith(".")], [])

    def test_wrong_usage_is_code_2(self):
        for option, value in (("--size", "10x10"), ("--size", "wide"), ("--size", "100000x100"), ("--view", "inside"),
                              ("--view", "10,100"), ("--cut", "w"), ("--cut", "x=there"), ("--colour", "red"),
                              ("--range", "2,1"), ("--background", "pink"), ("--without", "frames"), ("--without", ""), ("--threads", "-1"),
                              ("--up", "w"), ("-o", "-"), ("-o", ""), ("-o", "part.frames/field.vtu")):
            with self.subTest(option=option, value=value):
                self.refused(2, "part.frames", f"{option}={value}" if option.startswith("--") else option,
                             *([] if option.startswith("--") else [value]))
        self.refused(2, "part.frames", "--cut", "x=100", words=("outside the part",))
        self.refused(2, "part.frames", "--view", "front", "--cut", "x", words=("edge",))
        self.refused(2, "part.frames", "--range", "0,1", words=("colour",))

    def test_a_folder_without_a_surface_is_told_in_one_line(self):
        (self.folder / "part.frames" / "surface.vtu").unlink()
        self.refused(3, "part.frames", words=("no surface", "solve again"))

    def test_other_missing_or_damaged_files_are_code_3(self):
        self.refused(3, "nothing", words=("nothing",))
        for name in ("singularities.vtu", "surface.vtu", "field.vtu", "report.json"):
            with self.subTest(name=name):
                path = self.folder / "part.frames" / name
                content = path.read_bytes()
                path.write_bytes(content[: len(content) // 2])
                self.refused(3, "part.frames", words=(name,))
                path.write_bytes(content)
        (self.folder / "part.frames" / "singularities.vtu").unlink()
        self.refused(3, "part.frames", words=("singularities.vtu",))

    def test_a_place_that_cannot_be_written_is_code_4(self):
        self.refused(4, "part.frames", "-o", "nowhere/a.png", words=("nowhere/a.png",))
        self.assert_fails(self.run_here("render", "part.frames", "--size", "200x200", "-o", "/dev/full"), 4, "/dev/full")

    def test_an_interrupt_ends_it_with_130_and_nothing_written(self):
        process = subprocess.Popen([PROGRAM, "render", "part.frames", "--size", "8000x8000", "-o", "a.png"], cwd=self.folder,
                                   stderr=subprocess.PIPE, stdout=subprocess.PIPE)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + TIME_LIMIT
        # Its file is there before anything is drawn, which takes far longer than a signal.
        while not any(name.startswith(".a.png.") for name in self.names()):
            self.assertIsNone(process.poll())
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, errors)
        self.assertEqual(self.names(), ["part.frames"])


class Help(unittest.TestCase):
    def test_says_what_the_options_mean(self):
        result = run("render", "--help")
        self.assertEqual(result.returncode, 0)
        for word in ("--view", "--size", "--cut", "--colour", "--background"):
            self.assertIn(word, result.stdout)


if __name__ == "__main__":
    unittest.main()
