# SPDX-License-Identifier: Apache-2.0
"""Reads report.html with code of its own: the report in it, and the arrays of what it draws (viewer/README.md)."""

import base64
import gzip
import json
from html.parser import HTMLParser
from pathlib import Path

import numpy as np

TYPES = {"f32": "<f4", "u32": "<u4", "u16": "<u2", "i16": "<i2", "u8": "<u1"}


class Elements(HTMLParser):
    """The texts of elements with an id, by id, and what a browser would fetch."""

    def __init__(self):
        super().__init__()
        self.texts, self.fetched, self.inside = {}, [], None

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.fetched += [value for name, value in attributes.items() if name in ("src", "srcset") and value]
        if tag == "link" and attributes.get("href"):
            self.fetched.append(attributes["href"])
        self.inside = attributes.get("id") if tag == "script" else None

    def handle_data(self, data):
        if self.inside:
            self.texts[self.inside] = self.texts.get(self.inside, "") + data

    def handle_endtag(self, tag):
        self.inside = None


class Page:
    def __init__(self, path):
        elements = Elements()
        elements.feed(Path(path).read_text(encoding="utf-8"))
        self.fetched = [address for address in elements.fetched if not address.startswith("data:")]
        self.report = json.loads(elements.texts["crossgrain-report"])
        scene = gzip.decompress(base64.b64decode(elements.texts["crossgrain-scene"], validate=True))
        assert scene[:8] == b"CGSCENE1"
        length = int(np.frombuffer(scene, "<u4", 1, 8)[0])
        assert (12 + length) % 8 == 0
        self.header = json.loads(scene[12:12 + length])
        self.arrays = {name: self.array(scene[12 + length:], entry) for name, entry in self.header["arrays"].items()}

    @staticmethod
    def array(data, entry):
        assert entry["offset"] % 8 == 0
        count = int(np.prod(entry["shape"]))
        return np.frombuffer(data, TYPES[entry["type"]], count, entry["offset"]).reshape(entry["shape"])

    def lines(self, points, starts):
        return [self.arrays[points][a:b] for a, b in zip(self.arrays[starts][:-1], self.arrays[starts][1:])]

    def bfloat(self, name):
        return (self.arrays[name].astype("<u4") << 16).view("<f4")
