# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The cases of suites/bifs-syntax with predictive MF fields. They follow a summary and the choices of
bifs/predictive_model.h: no other program codes such fields, so that none has confirmed them."""
import itertools
import random

from bifs_cases import group
from bits import BitWriter
from command_writer import SceneStream, command as c
from node_facts import Field
from predictive_writer import HALF, QUARTER, ZEROS, ArithmeticCode, Model
from quantizer_cases import TRIGONOMETRY, placed, quantizer
from scene_values import Node, Predicted, Proto, Vector

ANGLES = [{**TRIGONOMETRY[0], "abs": 2e-5, "reason": "angles near 0 are restored from a cosine"}]
LAST = -8191  # as compMin: with 13 bits a residual of 0 is then the last symbol, that at the low end of the interval
MODES = {"first": {}, "periodic": {"mode": 1, "period": 3}, "flagged": {"mode": 2, "intra": (3, 4, 8)}}


def scene(*children, **settings):
    return SceneStream(**{"version": 2, "predictive": True, **settings}).unit(c("scene", group(*children)))


def keys(values, bits=8, **how):
    """A list of numbers from 0 to 1, category 8."""
    return scene(quantizer("key", keyNbBits=bits, keyMin=0, keyMax=1), Node(
        "ScalarInterpolator", key=Predicted(values, **how)))


def random_keys(count, seed, steps=16, codes=255):
    """A walk."""
    chance, code = random.Random(seed), codes // 2
    for _ in range(count):
        yield code / codes
        code = min(max(code + chance.randint(-steps, steps), 0), codes)


def modes():
    for name, how in MODES.items():
        values = list(random_keys(11, len(name)))
        yield f"predictive-{name}", f"intraMode {how.get('mode', 0)}, eleven values", keys(values, **how), \
            "10.header 10.intra-modes 10.parameters 10.residuals 2.predictive-flag"
        for count in (0, 1, 2):
            yield f"predictive-{name}-{count}", f"intraMode {how.get('mode', 0)} with a count of {count}", keys(
                values[:count], **how), "10.header 10.intra-modes" + (" 10.empty" if not count else "")
        if name != "first":
            yield f"predictive-{name}-renewed", f"intraMode {how['mode']} with new parameters", keys(
                values[:6] + [value / 9 for value in values], renewed=(3, 9) if name == "periodic" else (4, 8),
                **how), "10.new-parameters 10.intra-modes"
    yield "predictive-period-1", "a period of 1: intra values alone, one with new parameters", keys(
        [0.1, 0.9, 0, 1], mode=1, period=1, renewed=(2,)), "10.intra-modes 10.new-parameters 10.ends"
    yield "predictive-period-long", "a period longer than the list", keys([0.5, 0.6, 0.4], mode=1,
        period=70000), "10.intra-modes"
    yield "predictive-flagged-intra", "intraMode 2 with intra values alone", keys([0.1, 0.9, 0, 1, 0.5], mode=2,
        intra=range(5)), "10.intra-modes 10.ends"
    yield "predictive-flagged-predicted", "intraMode 2 where the first value alone is intra", keys(
        list(random_keys(20, 1)), mode=2), "10.intra-modes"


def categories():
    near = lambda low, high: [low + (high - low) * code for code in random_keys(9, int(high), codes=99)]
    vectors = lambda count, low, high: [list(v) for v in zip(*[[low + (high - low) * code for code in random_keys(9, i)]
        for i in range(count)])]
    cases = {
        1: ("Coordinate", "point", "position3D", vectors(3, -9, 9)),
        2: ("Coordinate2D", "point", "position2D", vectors(2, -4, 4)),
        3: ("OrderedGroup", "order", "drawOrder", near(0, 8)),
        4: ("Color", "color", "color", vectors(3, 0, 1)),
        5: ("TextureCoordinate", "point", "textureCoordinate", vectors(2, 0, 1)),
        6: ("DirectiveSound", "angles", "angle", near(0, 3)),
        7: ("MeshGrid", "vertexOffset", "scale", near(0, 2)),
        8: ("PositionAnimator", "keySpline", "key", vectors(2, 0, 1)),
        11: ("LOD", "range", "size", near(0, 60)),
        12: ("XLineProperties", "dashes", "size", near(0, 60))}
    for category, (name, field, switch, values) in cases.items():
        yield f"predictive-category-{category}", f"{name}.{field}, category {category}", scene(
            quantizer(switch, **{switch + "NbBits": 8}), placed(name, {field: Predicted(values)})), \
            "10.categories 10.parameters"
    yield "predictive-vec3-one-bound", "a vector of three in category 4: one bound and one model", scene(quantizer(
        "color", colorMin=-1), placed("PositionAnimator", {"keyValue": Predicted(vectors(3, -1, 1))})), "10.parameters"
    yield "predictive-category-13", "integers of 8 bits, at their ends too", scene(quantizer(), placed(
        "OctreeImage", {"octree": Predicted([7, 0, 255, 254, 128, 128, 3])})), "10.categories 9.int-13"
    for count in (3, 16):
        index = [i % count - 1 for i in range(0, 5 * count, 2)]
        yield f"predictive-category-14-{count}", f"indices of {count} points, -1 among them", scene(quantizer(), Node(
            "Shape", geometry=Node("IndexedFaceSet", coord=Node("Coordinate", point=[[i, 0, 1] for i in range(count)]),
                coordIndex=Predicted(index), colorIndex=Predicted(index[:4], mode=1, period=2)))), \
            "10.categories 9.index-14"


def normals(vectors, bits=8, **how):
    return scene(quantizer("normal", normalNbBits=bits), Node("Shape", geometry=Node("IndexedFaceSet", normal=Node(
        "Normal", vector=Predicted(vectors, **how)))))


def rotations(values, bits=8, **how):
    return scene(quantizer("normal", normalNbBits=bits), Node("OrientationInterpolator", key=[0, 1], keyValue=Predicted(
        values, **how)))


def normal_cases():
    near = [[0.6, 0.36, 0.72], [0.58, 0.4, 0.7], [0.5, 0.48, 0.71], [0.45, 0.45, 0.77]]
    yield "predictive-normals", "normals of one orientation", normals(near), "10.normals 10.parameters"
    flips = [[x * s, y * s, z * s] for (x, y, z), s in zip(near * 3, (1, 1, -1, 1, -1, -1, -1, 1, 1, 1, -1, 1))]
    for name, how in MODES.items():
        yield f"predictive-normals-flip-{name}", "normals whose direction flips", normals(flips, **how), \
            "10.normals 10.intra-modes"
    yield "predictive-normals-renewed", "new parameters begin the model of the direction anew too", normals(flips,
        mode=1, period=4, renewed=(8,)), "10.normals 10.new-parameters"
    ring = [[0.8, 0, 0.6], [0.7, 0, 0.72], [0.6, 0, 0.8], [-0.6, 0, 0.8], [-0.8, 0, 0.6], [-0.8, 0, -0.6],
        [-0.6, 0, -0.8], [0.6, 0, -0.8], [0.8, 0, -0.6]]
    yield "predictive-normals-edges", "normals once around, over the edges of four axes", normals(ring), \
        "10.orientation 10.normals"
    yield "predictive-normals-back", "and back, in 12 bits", normals(ring[::-1], 12), "10.orientation 10.normals"
    corners = [[0.62, 0.55, 0.56], [0.55, 0.62, 0.56], [0.55, 0.56, 0.62], [-0.55, 0.56, 0.62], [-0.62, 0.55, 0.56],
        [-0.56, -0.62, 0.55], [0.55, -0.56, -0.62], [0.62, 0.55, -0.56]]
    yield "predictive-normals-corners", "normals from axis to axis beside the corners of the cube", normals(corners), \
        "10.orientation 10.normals"
    yield "predictive-normals-axes", "normals along the axes", normals([[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1],
        [0, -1, 0], [-1, 0, 0], [0, 0, 1]], 6), "10.orientation 10.normals"
    yield "predictive-normals-on-edge", "a normal on the edge of two axes, reached from its other side", normals(
        [[-0.7027, 0.7115, 0], [0.5 ** 0.5, 0.5 ** 0.5, 0]]), "10.orientation 10.normals"


def rotation_cases():
    turns = [[0, 1, 0, angle / 2] for angle in range(8)]
    for name, how in MODES.items():
        yield f"predictive-rotations-{name}", "rotations about an axis, from one orientation to another", rotations(
            turns, **how), "10.rotations 10.orientation"
    yield "predictive-rotations-negative", "rotations about an axis that points the other way", rotations(
        [[0, -1, 0.1, angle / 2] for angle in range(8)]), "10.rotations 10.orientation"
    tumbling = [[0.6, 0.8, 0, 2], [-0.6, 0, 0.8, 1.5], [0, 0, -1, 2.5], [0.48, 0.6, 0.64, 1.2], [1, 0, 0, 3]]
    yield "predictive-rotations-any", "rotations about any axes", rotations(tumbling), "10.rotations 10.orientation"


def directions():
    for case in normal_cases():
        yield *case, TRIGONOMETRY
    for case in rotation_cases():
        yield *case, ANGLES


def codes():
    yield "predictive-constant", "compNbBits 0: forty times the same number", keys([0.25] * 40), \
        "10.no-bits 10.ends"
    yield "predictive-ramp", "compNbBits 0 and a compMin that is not: numbers in even steps", keys(
        [i / 255 for i in range(200, 20, -6)]), "10.no-bits 10.parameters"
    yield "predictive-no-width", "a quantizer of 0 bits", keys([0.25, 0.75, 0], bits=0), "10.no-bits 10.parameters"
    yield "predictive-widest", "compNbBits 13 and a quantizer of 31 bits", scene(quantizer("position3D",
        position3DNbBits=31), placed("Coordinate", {"point": Predicted([[-10, 20, 0], [-10, 20, 0], [-10, 20, 0]],
            width=13, minimum=-4096)})), "10.parameters", \
        [{"path": "/accessUnits", "abs": 1e-5, "reason": "above 20 bits rounding may move a code by one (9.3)"}]
    yield "predictive-ends", "residuals from one end of the range to the other", keys([0, 1, 0, 1, 1, 0]), \
        "10.parameters 10.residuals"
    for bits, count in ((8, 300), (12, 60)):
        yield f"predictive-random-{bits}", f"{count} numbers of {bits} bits", keys(list(random_keys(count, bits,
            1 << bits - 2, (1 << bits) - 1)), bits), "10.residuals"
    colours = [[random.Random(i // 9).random(), i % 3 / 2, 0.5] for i in range(2800)]
    yield "predictive-halved", "so many symbols that the frequencies are halved", scene(quantizer("color",
        colorNbBits=12), placed("Color", {"color": Predicted(Vector(colours), width=13, minimum=-4096)})), \
        "10.frequencies 10.residuals"


def zeros_at_end():
    """Numbers of 8 bits whose residuals, as symbols of 4 bits, end with so many zeros that a bit behind them would be
    stuffed: each symbol but the first two keeps the middle of the interval inside it."""
    for start in itertools.product(range(16), repeat=2):
        code, model, symbols = ArithmeticCode(BitWriter()), Model(16), []
        for step in range(40):
            inside = [symbol for symbol in range(16) if holds_middle(code, model, symbol)]
            if step >= len(start) and not inside:
                break
            symbols.append(start[step] if step < len(start) else inside[0])
            code.symbol(model, symbols[-1])
            if code.opposite == ZEROS - 1 and code.low >= QUARTER:
                return list(itertools.accumulate([128] + [symbol - 8 for symbol in symbols]))
    raise ValueError("no such symbols")


def holds_middle(code, model, symbol):
    low, high = code.interval(model, symbol)
    return low < HALF <= high


def stuffing():
    low = dict(width=13, minimum=LAST)
    for name, count in (("none", 2), ("one", 3), ("many", 12)):
        yield f"predictive-stuffing-{name}", f"{count} numbers of 0 that are each the last symbol: mostly zeros", keys(
            [0] * count, 13, **low), "10.stuffing 10.ends"
    yield "predictive-stuffing-codes", "zeros are counted from the begin of each code", keys([0] * 11, 13, **low,
        mode=1, period=4), "10.stuffing 10.ends 10.intra-modes"
    yield "predictive-zeros-at-end", "22 zeros at the end of a code: nothing is stuffed behind them", keys(
        [code / 255 for code in zeros_at_end()], width=4, minimum=-8), "10.stuffing 10.ends"


def places():
    walk = list(random_keys(5, 3))
    points = [[value, 1 - value, 0.5] for value in walk]
    fine = quantizer("position3D", "key", position3DMin=[-1, -1, -1], position3DMax=[1, 1, 1], keyMax=1)
    yield "predictive-beside", "predictive and plain fields in one node, in a list description", scene(fine, Node(
        "ScalarInterpolator", form="list", key=Predicted(walk), keyValue=[1, 2]), Node(
            "CoordinateInterpolator", key=walk, keyValue=Predicted(points))), "2.predictive-flag 10.header"
    commands = scene(Node("ScalarInterpolator", id=1), Node("Shape", geometry=Node("PointSet",
        coord=Node("Coordinate", id=2))))
    commands.unit(c("quantize", fine), c("replace_field", 1, "key", Predicted(walk)),
        c("replace_fields", 2, point=Predicted(points)), c("xreplace", 1, "key", Predicted(walk[::-1])))
    commands.unit(c("replace_field", 2, "point", Predicted(points, mode=2, intra=(3,))))
    yield "predictive-commands", "commands with predictive fields under a global quantizer", commands, \
        "10.header 9.global"
    proto = Proto(1, [Field("_field0", "exposedField", "MFVec3f", default=[[0, 1, 2]] * 7, category=1,
        bounds=[-1, 1])], [Node("Group")])
    instance = SceneStream(version=2, predictive=True, proto_bits=1).unit(c("scene", group(fine, Node(1,
        _field0=Predicted(points))), [proto]))
    yield "predictive-proto", "a field of a PROTO's instance, predictive; its default is not", instance, \
        "10.header 12.quantization 2.predictive-flag"


def all_cases():
    for part in (modes, categories, directions, codes, stuffing, places):
        yield from part()
