# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The cases of suites/bifs-rejects with predictive MF fields."""
from faults import Fault, changed, cut
from predictive_cases import keys, normals, random_keys, scene
from quantizer_cases import quantizer
from scene_values import Node

FEW = [0.5, 0.6, 0.4, 0.5]


def header():
    yield "predictive-mode-3", "the intraMode 3", changed(keys(FEW), "intraMode", 2, 3, covers="10.reserved-mode")
    yield "predictive-mode-3-empty", "the intraMode 3 of no values", changed(keys([]), "intraMode", 2, 3,
        covers="10.reserved-mode")
    yield "predictive-period-0", "a period of 0", changed(keys(FEW, mode=1, period=3), "period", 2, 0,
        covers="10.period")
    yield "predictive-period-none", "a period of 0 in 0 bits", changed(keys(FEW, mode=1, period=31), "periodBits", 5, 0,
        covers="10.period", shift=5)
    for width in (14, 31):
        yield f"predictive-width-{width}", f"compNbBits {width}", changed(keys(FEW), "compNbBits", 5, width,
            covers="10.width")
    yield "predictive-width-renewed", "compNbBits 14 in new parameters", changed(keys(FEW, mode=1, period=2,
        renewed=(2,)), "compNbBits", 5, 14, covers="10.width 10.new-parameters")
    plain = lambda *children: scene(*children, Node("ScalarInterpolator", key=FEW))
    for name, children in (("no-quantizer", ()), ("category-off", (quantizer("color"),))):
        yield f"predictive-{name}", "a predictive field that is not quantized", changed(plain(*children),
            "usePredictive", 1, 1, covers="10.quantized")
    yield "predictive-nodes", "a predictive list of nodes", changed(plain(), "usePredictive", 1, 1, 0,
        covers="10.quantized")


def truncations():
    header = "3.truncated 10.header"
    for element in ("intraMode", "period", "compNbBits", "compMin"):
        yield f"cut-predictive-{element.lower()}", f"a predictive field ends before its {element} is whole", cut(
            keys(list(random_keys(70, 3)), mode=1, period=300000), element, covers=header)
    yield "cut-predictive-intra", "a predictive field ends inside an intra value", cut(keys(FEW, bits=31, mode=1,
        period=1), "quantized", covers=header)
    yield "cut-predictive-direction", "a predictive field ends inside an intra normal", cut(normals([[1, 0, 0]] * 4,
        16, mode=1, period=1), "component", covers=header)
    yield "cut-residuals", "the data end inside residuals", cut(keys(list(random_keys(100, 5))), "residuals",
        covers="3.truncated 10.residuals")
    late = keys(list(random_keys(100, 5)))
    late.out.bits = late.out.bits[:(late.out.at("residuals") + 200) // 8 * 8]
    yield "cut-residuals-late", "the data end inside residuals, behind many", Fault(late, None, "truncated",
        "3.truncated 10.residuals")


def residuals():
    for name, values, up in (("above", [0.9, 0.95, 1, 0.98], 1), ("below", [0.1, 0, 0.05, 0.1], -1)):
        yield f"predictive-{name}", f"a predicted number {name} the range of the quantizer", shifted(
            keys(values), 8, up)
    late = shifted(keys(list(random_keys(80, 9, 2)) + [1]), 8, 1)
    yield "predictive-above-at-end", "the last number is above the range, and the data end soon behind it", Fault(late.stream, None,
        covers=late.covers)
    yield "predictive-second-edge", "a predicted normal more than 135 degrees from the axis", shifted(normals(
        [[0.69, 0, 0.72], [0.927, -0.374, 0.02]], 12), 12, 2150, "10.range 10.orientation")
    yield "predictive-two-edges", "a predicted normal over the edges of two components", shifted(normals(
        [[0.69, 0, 0.72]] * 2, 12), 12, 2100, "10.range 10.orientation")
    stream = keys([0] * 3, 13, width=13, minimum=-8191)
    yield "predictive-unstuffed", "22 zeros without a 1 behind them", Fault(changed(stream, "stuffing", 1, 0).stream,
        stream.out.at("residuals"), covers="10.stuffing")


def shifted(stream, bits, by, covers="10.range"):
    """Every residual is so much more."""
    bit = stream.out.at("compMin")
    least = int("".join(map(str, stream.out.bits[bit:bit + bits + 1])), 2)
    changed(stream, "compMin", bits + 1, least + by)
    return Fault(stream, stream.out.at("residuals"), covers=covers)


def all_cases():
    for part in (header, truncations, residuals):
        yield from part()
