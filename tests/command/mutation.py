# SPDX-License-Identifier: Apache-2.0
"""Damage at random places of files, the same for the same seed."""

import re

NUMBERS = [b"0", b"-1", b"1", b"4", b"255", b"65536", b"2147483647", b"-2147483648", b"4294967295", b"4294967296", b"99999999999999999999",
           b"1e308", b"-1e-320", b"1e-9", b"1e12", b"1e999", b"nan", b"inf", b"0x10", b"1.5", b"", b"-"]
BYTES = b"\0\xff\x7f\x80\n\r \t-+.#/\\\"'<>&_0123456789eE"


def change_a_byte(data, random):
    at = random.randrange(len(data))
    data[at] = random.choice(BYTES) if random.random() < 0.5 else data[at] ^ 1 << random.randrange(8)


def remove_some(data, random):
    at = random.randrange(len(data))
    del data[at:at + random.randint(1, 16)]


def repeat_some(data, random):
    at = random.randrange(len(data))
    data[at:at] = data[at:at + random.randint(1, 40)] * random.randint(1, 3)


def replace_a_number(data, random):
    found = re.compile(rb"[\d.]+").search(data, random.randrange(len(data)))
    if found:
        data[found.start():found.end()] = random.choice(NUMBERS)


def swap_lines(data, random):
    lines = data.split(b"\n")
    a, b = random.randrange(len(lines)), random.randrange(len(lines))
    lines[a], lines[b] = lines[b], lines[a]
    data[:] = b"\n".join(lines)


def cut_short(data, random):
    del data[random.randrange(len(data)):]


# Numbers most often: they lead beyond the readers.
DAMAGES = [change_a_byte, remove_some, repeat_some, swap_lines, cut_short] + 4 * [replace_a_number]


def mutated(content, random):
    """The bytes with one to four damages."""
    data = bytearray(content)
    for damage in random.choices(DAMAGES, k=random.randint(1, 4)):
        if data:
            damage(data, random)
    return bytes(data)
