# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Predictive MF fields as bifs.md 10 has them. That is a summary: where it leaves a choice, the one that
bifs/predictive_model.h names is made. No other program has confirmed any of it."""
from bits import bits_for

QUARTER, HALF, TOP = 1 << 14, 1 << 15, (1 << 16) - 1
MOST_COUNTED = 16383
WIDEST = 13  # compNbBits: frequencies of 1 are within MOST_COUNTED
ZEROS = 22  # in a row, and a 1 is stuffed in
BOUNDS = {1: 3, 2: 2}  # of these categories; else 1


class Model:
    """How often each symbol came, and once more."""

    def __init__(self, symbols):
        self.counts, self.total = [1] * symbols, symbols

    def count(self, symbol):
        if self.total == MOST_COUNTED:
            self.counts = [(count + 1) // 2 for count in self.counts]
            self.total = sum(self.counts)
        self.counts[symbol] += 1
        self.total += 1


class ArithmeticCode:
    """The coder of H.263 annex E: the first symbol has the top of the interval."""

    def __init__(self, out):
        self.out = out
        self.low, self.high, self.opposite, self.zeros = 0, TOP, 0, 0
        out.mark("residuals")

    def interval(self, model, symbol):
        above, size = sum(model.counts[symbol + 1:]), self.high - self.low + 1
        return (self.low + size * above // model.total,
                self.low - 1 + size * (above + model.counts[symbol]) // model.total)

    def symbol(self, model, symbol):
        self.low, self.high = self.interval(model, symbol)
        model.count(symbol)
        while True:
            if self.high < HALF:
                base = 0
                self.settle(0)
            elif self.low >= HALF:
                base = HALF
                self.settle(1)
            elif self.low >= QUARTER and self.high < HALF + QUARTER:
                base = QUARTER
                self.opposite += 1
            else:
                return
            self.low, self.high = 2 * (self.low - base), 2 * (self.high - base) + 1

    def end(self):
        self.opposite += 1
        self.settle(int(self.low >= QUARTER))

    def settle(self, bit):
        """This bit, and those that waited to be its opposite."""
        self.put(bit)
        for _ in range(self.opposite):
            self.put(1 - bit)
        self.opposite = 0

    def put(self, bit):
        if self.zeros == ZEROS:
            self.out.u(1, 1, "stuffing")
            self.zeros = 0
        self.out.u(1, bit)
        self.zeros = 0 if bit else self.zeros + 1


def step_between(before, after):
    """Whether the direction of a normal flips, and the difference of each component."""
    if before.orientation == after.orientation:
        return before.negative != after.negative, [b - a for a, b in zip(before.numbers, after.numbers)]
    ways = [crossing(before, after, side) for side in (1, -1)]
    return min((way for way in ways if way), key=lambda way: sum(map(abs, way[1])))


def crossing(before, after, side):
    """The step to a direction with another axis, over the positive or the negative edge of the component that has
    this axis. There the angle is measured from the new axis, which beyond the negative edge points the other way: all
    other components change their signs, and a normal its direction. None: it is on the edge and not beyond."""
    middle, axes = 1 << before.width - 1, len(before.numbers) + 1
    edge = middle - 1  # 45 degrees
    # Of each axis but its own: the angle that the new value has, seen from the axis of the one before.
    angles = {(after.orientation + 1 + i) % axes: side * (number - middle) for i, number in enumerate(after.numbers)}
    angles[after.orientation] = side * (2 * edge - angles[before.orientation])
    if abs(angles[after.orientation]) <= edge:
        return None
    residuals = [angles[(before.orientation + 1 + i) % axes] - (number - middle)
                 for i, number in enumerate(before.numbers)]
    return (before.negative != after.negative) != (before.negative is not None and side < 0), residuals


class PredictiveWriter:
    """Writes one field from behind usePredictive; `values` are scene_values.Predicted."""

    def __init__(self, writer, field, values):
        self.writer, self.values = writer, values
        self.category = writer.quantizer.category(field)
        self.bounds = BOUNDS.get(self.category, 1)
        self.codes = [writer.code_of(field, value) for value in values]
        self.bits = writer.quantizer.bits(field, self.category, writer.points_here())
        self.code = None

    def write(self):
        out, count = self.writer.out, len(self.values)
        out.u(5, bits_for(count), "countBits")
        out.u(bits_for(count), count, "count")
        out.u(2, self.values.mode, "intraMode")
        if self.values.mode == 1:
            out.u(5, bits_for(self.values.period), "periodBits")
            out.u(bits_for(self.values.period), self.values.period, "period")
        self.parameters(0)
        for i in range(count):
            self.value(i)
        self.end_code()
        return [code.found for code in self.codes]

    def is_intra(self, i):
        return i == 0 or (i % self.values.period == 0 if self.values.mode == 1 else i in self.values.intra)

    def bound(self, component):
        return min(component, self.bounds - 1)

    def residuals(self, begin):
        """By bound: those of the predicted values from `begin` to the next new parameters."""
        found = [[] for _ in range(self.bounds)]
        for i in range(begin + 1, min((r for r in self.values.renewed if r > begin), default=len(self.codes))):
            if not self.is_intra(i):
                for component, residual in enumerate(step_between(self.codes[i - 1], self.codes[i])[1]):
                    found[self.bound(component)].append(residual)
        return found

    def parameters(self, begin):
        """The least that the residuals need, or what the values ask for; and new models."""
        found = self.residuals(begin)
        least = [min(residuals, default=0) for residuals in found]
        self.least = least if self.values.minimum is None else [self.values.minimum] * self.bounds
        width = max(bits_for(max(residuals, default=low) - low) for residuals, low in zip(found, self.least))
        width = width if self.values.width is None else self.values.width
        if width > WIDEST:
            raise ValueError(f"residuals of {width} bits")
        self.writer.out.u(5, width, "compNbBits")
        for low in self.least:
            self.writer.out.u(self.bits + 1, low + (1 << self.bits), "compMin")
        self.models = [Model(1 << width) for _ in range(self.bounds)]
        self.flips, self.intra_flags = Model(2), Model(2)

    def value(self, i):
        if i and self.values.mode == 2:
            self.symbol(self.intra_flags, int(self.is_intra(i)))
        if not self.is_intra(i):
            return self.predicted(*step_between(self.codes[i - 1], self.codes[i]))
        self.end_code()
        if i:
            self.writer.out.u(1, int(i in self.values.renewed), "newParameters")
        if i and i in self.values.renewed:
            self.parameters(i)
        self.writer.quantized(self.codes[i])

    def predicted(self, flip, residuals):
        if self.category == 9:
            self.symbol(self.flips, int(flip))
        for component, residual in enumerate(residuals):
            bound = self.bound(component)
            self.symbol(self.models[bound], residual - self.least[bound])

    def symbol(self, model, symbol):
        self.code = self.code or ArithmeticCode(self.writer.out)
        self.code.symbol(model, symbol)

    def end_code(self):
        if self.code:
            self.code.end()
        self.code = None


def write(writer, field, values):
    """Gives back what a decoder must find."""
    return PredictiveWriter(writer, field, values).write()
