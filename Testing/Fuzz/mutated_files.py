# SPDX-License-Identifier: BSD-3-Clause
"""Damages sound files, each case from its number alone: every class of bytes of every format in turn."""

import random

from specimen_files import SPECIMENS

CLASSES = {
    "digit": b"0123456789",
    "letter": bytes(range(65, 91)) + bytes(range(97, 123)),
    "blank": b" \t\r\n",
    "sign": b"+-.,:;_/\\\"'=<>?!#%&()[]{}|*@^$~`",
    "binary": bytes(range(0, 9)) + bytes(range(14, 32)) + bytes(range(127, 256)),
}
NUMBERS = (b"0", b"-1", b"1", b"2", b"255", b"65536", b"2147483647", b"2147483648", b"-2147483648",
           b"4294967296", b"9223372036854775807", b"18446744073709551616", b"1e308", b"1e400", b"-0.0",
           b"nan", b"inf", b"1e-320", b"0x10", b"1000000", b"7")
WORDS = tuple(b"\0" * size for size in (1, 4, 8)) + tuple(b"\xff" * size for size in (1, 4, 8)) + (
    b"\x7f\xff\xff\xff", b"\xff\xff\xff\x7f", b"\x80\0\0\0", b"\0\0\0\x80", b"\x01\0\0\0", b"\0\0\0\x01",
    b"\0\0\xc0\x7f", b"\x7f\xf8\0\0\0\0\0\0", b"\0\0\0\0\0\0\xf0\x7f")


def byte_of(rng, name):
    return bytes([rng.choice(CLASSES[name])])


def run_at(data, place, members):
    """The longest run of bytes of one class around a place."""
    first = last = place
    while first > 0 and data[first - 1] in members:
        first -= 1
    while last < len(data) and data[last] in members:
        last += 1
    return first, last


def in_run(change):
    """Changes the run around a place, between what stands before and behind it."""
    def changed(data, place, kind, rng):
        first, last = run_at(data, place, CLASSES[kind])
        return data[:first] + change(data[first:last], kind, rng) + data[last:]
    return changed


def in_lines(change):
    """Changes the list of lines, and knows the number of that of a place."""
    def changed(data, place, _, rng):
        lines = data.split(b"\n")
        change(lines, data.count(b"\n", 0, place), rng)
        return b"\n".join(lines)
    return changed


def at_place(size, change):
    """Replaces this number of bytes at a place."""
    return lambda data, place, kind, rng: data[:place] + change(data[place:place + size], kind, rng) + data[place + size:]


def overwrite(data, place, _, rng):
    word = rng.choice(WORDS)
    return data[:place] + word + data[place + len(word):]


def swap_blocks(data, place, _, rng):
    other = rng.randrange(len(data))
    size = rng.randrange(1, 65)
    first, second = sorted((place, other))
    return (data[:first] + data[second:second + size] + data[first + size:second]
            + data[first:first + size] + data[second + size:])


def any_byte(rng):
    return byte_of(rng, rng.choice(list(CLASSES)))


replace_run = in_run(lambda _, kind, rng: rng.choice(WORDS if kind == "binary" else NUMBERS))
CHANGES = (
    at_place(1, lambda _, kind, rng: byte_of(rng, kind)),
    at_place(1, lambda _, kind, rng: any_byte(rng)),
    at_place(1, lambda old, kind, rng: bytes([old[0] ^ (1 << rng.randrange(8))])),
    at_place(1, lambda _, kind, rng: b""),
    in_run(lambda run, kind, rng: b""),
    in_run(lambda run, kind, rng: run + run * rng.choice((1, 2, 40))),
    replace_run, replace_run, overwrite,
    at_place(0, lambda _, kind, rng: any_byte(rng) * rng.choice((1, 1, 3, 500))),
    lambda data, place, *_: data[:place],
    in_lines(lambda lines, at, rng: lines.insert(rng.randrange(len(lines)), lines.pop(at))),
    in_lines(lambda lines, at, rng: lines.pop(at)),
    swap_blocks)


def mutated(number):
    """Specimen, class and bytes of a case."""
    name = list(SPECIMENS)[number % len(SPECIMENS)]
    data = SPECIMENS[name]
    present = [kind for kind, members in CLASSES.items() if any(byte in members for byte in data)]
    kind = present[number // len(SPECIMENS) % len(present)]
    rng = random.Random(number)
    for _ in range(rng.choice((1, 1, 1, 2, 5))):
        places = [k for k, byte in enumerate(data) if byte in CLASSES[kind]]
        if places:
            data = rng.choice(CHANGES)(data, rng.choice(places), kind, rng)
    return name, kind, data
