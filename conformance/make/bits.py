# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""A writer of bits that knows where each element is."""


def bits_for(number):
    """How many bits a number needs: 0 for 0."""
    return number.bit_length()


class BitWriter:
    """Most significant bit first. `places` has the bit at which each named element begins, in order."""

    def __init__(self):
        self.bits = []
        self.places = []

    def __len__(self):
        return len(self.bits)

    def u(self, count, value, name=None):
        if not 0 <= value < 1 << count:
            raise ValueError(f"{name}: {value} in {count} bits")
        self.mark(name)
        self.bits.extend((value >> i) & 1 for i in reversed(range(count)))

    def mark(self, name):
        if name:
            self.places.append((name, len(self.bits)))

    def data(self, data, name=None):
        self.mark(name)
        for byte in data:
            self.u(8, byte)

    def append(self, other):
        base = len(self.bits)
        self.places.extend((name, base + bit) for name, bit in other.places)
        self.bits.extend(other.bits)

    def align(self):
        while len(self.bits) % 8:
            self.bits.append(0)

    def at(self, name, nth=0):
        """The bit at which the nth element of that name begins (-1: the last)."""
        return [bit for known, bit in self.places if known == name][nth]

    def bytes(self):
        padded = self.bits + [0] * (-len(self.bits) % 8)
        return bytes(int("".join(map(str, padded[i:i + 8])), 2) for i in range(0, len(padded), 8))
