# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Quantization as bifs.md 9 has it, in binary32 with rounding after every operation."""
import math
import struct

from bits import bits_for
from node_facts import LARGEST, NODES, f32, plain

# Of each category: what switches it on, its bounds, its width.
LINEAR = {1: "position3D", 2: "position2D", 3: "drawOrder", 4: "color", 5: "textureCoordinate", 6: "angle",
          7: "scale", 8: "key", 11: "size", 12: "size"}
FLOATS = {"SFFloat": 1, "SFVec2f": 2, "SFVec3f": 3, "SFColor": 3}
INFINITE = {"+inf": LARGEST, "-inf": -LARGEST, "inf": LARGEST}


def number(value):
    return INFINITE.get(value, value) if isinstance(value, str) else value


class Code:
    """A quantized value: its numbers of `width` bits, of directions the orientation, of normals whether that is
    negative; and what a decoder must find."""

    def __init__(self, width, numbers, found, orientation=None, negative=None):
        self.width, self.numbers, self.found = width, numbers, found
        self.orientation, self.negative = orientation, negative


class Quantizer:
    """The values of a QuantizationParameter, with its defaults."""

    def __init__(self, fields):
        self.values = {f.name: f.default for f in NODES["QuantizationParameter"].fields}
        self.values.update(fields)

    def __getitem__(self, name):
        return self.values[name]

    def category(self, field):
        """The category that a field is coded with now; 0: none."""
        category, kind = field.category, field.element
        if category in (13, 14):
            return category if kind == "SFInt32" else 0
        if category in LINEAR and kind in (*FLOATS, "SFInt32"):
            return category if self[LINEAR[category] + "Quant"] else 0
        wanted = {9: "SFVec3f", 10: "SFRotation"}.get(category)
        return category if kind == wanted and self["normalQuant"] else 0

    def bits(self, field, category, points):
        """Of one number; `points` are those of the geometry."""
        if category in (13, 14):
            return field.width if category == 13 else bits_for(points)
        return self["normalNbBits" if category in (9, 10) else LINEAR[category] + "NbBits"]

    def code_of(self, field, category, value, points):
        width = self.bits(field, category, points)
        if category in (13, 14):
            low = 0 if category == 14 and field.bounds is None else field.bounds[0]
            return Code(width, [value - low], value)
        if category in (9, 10):
            return normal(value, width) if category == 9 else rotation(value, width)
        many = value if isinstance(value, (list, tuple)) else [value]
        bounds = [self.bounds(field, category, i) for i in range(len(many))]
        numbers = [quantized(one, *ends, width) for one, ends in zip(many, bounds)]
        found = [plain(restored(number, *ends, width)) for number, ends in zip(numbers, bounds)]
        return Code(width, numbers, found if isinstance(value, (list, tuple)) else found[0])

    def bounds(self, field, category, component):
        def of(name):
            value = self[LINEAR[category] + name]
            value = value[component] if isinstance(value, (list, tuple)) else value
            return f32(max(-LARGEST, min(LARGEST, number(value))))
        low, high = (f32(number(b)) for b in field.bounds or ("-inf", "+inf"))
        return max(low, of("Min")), min(high, of("Max"))


def quantized(value, low, high, bits):
    most = 2 ** bits - 1
    value = f32(value)
    if value <= low:
        return 0
    if value >= high:
        return most
    scaled = f32(f32(f32(value - low) * f32(most)) / f32(high - low))
    return math.floor(f32(scaled + 0.5))


def restored(code, low, high, bits):
    most = 2 ** bits - 1
    if code == 0:
        return low
    if code == most:
        return high
    return f32(low + f32(f32(f32(high - low) * f32(code)) / f32(most)))


def direction_code(components, bits, has_sign):
    """Of a unit normal or quaternion: sign, orientation, codes; and what these are decoded to."""
    count = len(components)
    largest = max(range(count), key=lambda i: (abs(components[i]), -i))
    codes = []
    half = 1 << (bits - 1)
    for i in range(count - 1):
        angle = 4 / math.pi * math.atan(components[(largest + 1 + i) % count] / components[largest])
        step = math.floor(abs(angle) * (half - 1) + 0.5)
        codes.append(half + (step if angle >= 0 else -step))
    negative = has_sign and components[largest] < 0
    return negative, largest, codes, direction_of(negative, largest, codes, bits)


def direction_of(negative, largest, codes, bits):
    half = 1 << (bits - 1)
    ratios = [math.tan((code - half) / (half - 1) * math.pi / 4) for code in codes]
    length = (-1 if negative else 1) / math.sqrt(1 + sum(r * r for r in ratios))
    count = len(codes) + 1
    components = [0.0] * count
    components[largest] = length
    for i, ratio in enumerate(ratios):
        components[(largest + 1 + i) % count] = ratio * length
    return components


def normal(vector, width):
    negative, largest, numbers, found = direction_code(vector, width, True)
    return Code(width, numbers, [plain(c) for c in found], largest, negative)


def rotation(value, width):
    _, largest, numbers, found = direction_code(quaternion(value), width, False)
    return Code(width, numbers, [plain(c) for c in rotation_of(found)], largest)


def quaternion(rotation):
    x, y, z, angle = rotation
    length = math.sqrt(x * x + y * y + z * z)
    sine = math.sin(angle / 2) / length
    return [math.cos(angle / 2), x * sine, y * sine, z * sine]


def rotation_of(components):
    w, x, y, z = components
    angle = 2 * math.acos(max(-1.0, min(1.0, w)))
    sine = math.sin(angle / 2)
    return [0, 0, 1, angle] if sine == 0 else [x / sine, y / sine, z / sine, angle]


def efficient(value):
    """Of a float that is not infinite: its parts (length, value) by name, and what they are decoded to."""
    word = struct.unpack(">I", struct.pack(">f", value))[0]
    negative, exponent, mantissa = word >> 31, (word >> 23 & 255) - 127, (word & 0x7FFFFF) >> 9
    if word << 1 & 0xFFFFFFFF == 0:
        return [("mantissaLength", 4, 0)], 0
    length = mantissa.bit_length() + 1
    width = abs(exponent).bit_length()
    parts = [("mantissaLength", 4, length), ("exponentLength", 3, width), ("mantissaSign", 1, negative),
             ("mantissa", length - 1, mantissa)]
    if width:
        parts += [("exponentSign", 1, int(exponent < 0)), ("exponent", width - 1, abs(exponent) - (1 << width - 1))]
    size = (1 + mantissa / 2 ** 14) * 2.0 ** exponent if exponent > -127 else mantissa / 2 ** 14 * 2.0 ** -126
    return parts, f32(-size if negative else size)
