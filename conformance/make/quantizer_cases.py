# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The cases of suites/bifs-syntax with quantizers: every category on every field of the tables that has it, the scope
of a quantizer, efficient floats."""
import quantizer as q
from bifs_cases import group
from command_writer import SceneStream, command as c
from node_facts import NODES
from node_samples import HOSTS, hosted
from quantizer import number
from scene_values import Buffer, Node, Use, Vector

ON = {"position3DMin": [-10, -20, -30], "position3DMax": [10, 20, 30], "position2DMin": [-4, -5],
    "position2DMax": [4, 5],
      "drawOrderMin": -8, "drawOrderMax": 8, "scaleMin": 0, "scaleMax": 16, "sizeMin": -4, "sizeMax": 64, "keyMin": 0,
          "keyMax": 2}
TRIGONOMETRY = [{"path": "/accessUnits", "abs": 2e-6, "reason": "normals and rotations are restored with trigonometry"}]


def quantizer(*names, **more):
    """One that quantizes with these names alone, as wide as the defaults."""
    off = {name + "Quant": False for name in ("color", "textureCoordinate", "angle", "key",
        "normal") if name not in names}
    on = {name + "Quant": True for name in names if name not in ("color", "textureCoordinate", "angle", "key",
        "normal")}
    bounds = {key: value for key, value in ON.items() if key[:-3] in names}
    return Node("QuantizationParameter", **{**off, **on, **bounds, **more})


def samples(field, category, values):
    """Values of a field: within its bounds and beyond."""
    low, high = (number(b) for b in field.bounds or ("-inf", "+inf"))
    low, high = max(low, -12.0), min(high, 12.0)
    count = {"SFFloat": 1, "SFVec2f": 2, "SFVec3f": 3, "SFColor": 3}[field.element]

    def one(step):
        parts = [low + (high - low) * (((step + i) * 29) % 97) / 97 for i in range(count)]
        return parts if count > 1 else parts[0]
    return [one(values + step) for step in range(5)] if field.multiple else one(values)


def fields_of(category, kinds):
    for name, node in NODES.items():
        found = [f for f in node.mode("def") if f.category == category and f.element in kinds
                 and not (category == 2 and f.element == "SFVec3f")]  # the text has no bounds for a third component
        if found and name != "QuantizationParameter":
            yield name, found


def home(name):
    return next((d for d in NODES[name].data_types if d != "SFWorldNode"), "SFWorldNode")


def placed(name, fields):
    node = Node(name)
    node.fields = fields
    return hosted(node, home(name) if home(name) in HOSTS else "SFWorldNode")


def linear():
    for category, label in q.LINEAR.items():
        for part in (0, 1):
            nodes = []
            for step, (name, fields) in enumerate(fields_of(category, q.FLOATS)):
                # A third of a field's components has no bounds of its own in some categories: none is asked for.
                if step % 2 == part:
                    nodes.append(placed(name, {f.name: samples(f, category, step) for f in fields}))
            if not nodes:
                continue
            yield f"quant-{category}-{label.lower()}-{part + 1}", f"category {category}, {label}: fields of the tables under a quantizer", \
                SceneStream().unit(c("scene", group(quantizer(label), *nodes))), "9.linear 9.bounds 9.scope-list"
    for bits in (0, 1, 2, 15, 20):
        fan = [[x * 2.7 - 10, -x * 5.0, x / 7] for x in range(8)]
        yield f"quant-width-{bits}", f"a linear quantizer of {bits} bits, values at and beyond the bounds", SceneStream().unit(c("scene", group(
            quantizer("position3D", position3DNbBits=bits), Node("Transform", translation=[-10, 20, 0]), Node(
                "Shape", geometry=Node("PointSet", coord=Node("Coordinate", point=fan)))))), "9.linear 9.saturate"
    wide = SceneStream().unit(c("scene", group(quantizer("position3D", position3DNbBits=31), Node(
        "Transform", translation=[-9.99, 0.1, 12.3456]), Node("Transform", translation=[10, -20, 40]))))
    yield "quant-width-31", "a linear quantizer of 31 bits", wide, "9.linear", \
        [{"path": "/accessUnits", "abs": 1e-5, "reason": "above 20 bits rounding may move a code by one (9.3)"}]
    yield "quant-table-bounds", "the bounds of the table are narrower than those of the quantizer", SceneStream().unit(
        c("scene", group(
        quantizer("size", sizeMin=-100, sizeMax=50), Node(
            "Shape", geometry=Node("Sphere", radius=7.5)),
                Node("Shape", geometry=Node("Cone", height=60, bottomRadius=0.001))))), "9.bounds 9.saturate"
    yield "quant-defaults", "a quantizer without fields", SceneStream().unit(c("scene", group(
        Node("QuantizationParameter"), Node("PointLight", color=[0.1, 0.2, 0.3], intensity=0.7,
            location=[1.1, 2.2, 3.3]),
        Node("ScalarInterpolator", key=[0, 0.3, 0.9, 1], keyValue=[0.1, 0.2]),
        Node("Shape", geometry=Node("IndexedFaceSet", texCoord=Node("TextureCoordinate",
            point=[[0.1, 0.9], [0.5, 0.25]]), creaseAngle=1.5))))), "9.defaults"
    yield "quant-int-linear-off", "an integer field with a linear category that is off", SceneStream().unit(c("scene",
        group(
        quantizer("color"), Node("Shape", geometry=Node("ElevationGrid", xDimension=3,
            zDimension=70000))))), "9.int-linear"


def integers():
    nodes = []
    for step, (name, fields) in enumerate(fields_of(13, ("SFInt32",))):
        given = {}
        for i, field in enumerate(fields):
            low, high = int(number(field.bounds[0])), field.bounds[1]
            most = min(low + (1 << field.width) - 1, int(min(number(high), 2147483647)))
            given[field.name] = [low, most, (low + most) // 2, low] if field.multiple else (most, low,
                (low + most) // 2)[(step + i) % 3]
        nodes.append((name, given))
    for part in range(3):
        yield f"quant-13-{part + 1}", "category 13: integers of the width in the tables", SceneStream().unit(c("scene",
            group(
            quantizer(), *[placed(name, given) for name, given in nodes[part::3]]))), "9.int-13"
    for count in (0, 1, 2, 3, 4, 7, 8, 15, 16, 255, 256):
        points = [[i, 0, 1] for i in range(count)]
        top = [count - 1, -1, max(count - 2, -1), 0 if count else -1]
        yield f"quant-14-{count}", f"category 14: indices of {count} points", SceneStream().unit(c("scene",
            group(quantizer(), Node(
            "Shape", geometry=Node("IndexedFaceSet", coord=Node("Coordinate", point=points), colorIndex=top,
                coordIndex=top * 3,
                                   normalIndex=[-1, -1], texCoordIndex=[]))))), "9.index-14"
    used = Node("Shape", geometry=Node("IndexedLineSet", coord=Use(1), coordIndex=[0, 4, -1]))
    flat = Node("Shape", geometry=Node("IndexedLineSet2D", coord=Node("Coordinate2D", point=[[0, 1], [2, 3], [4, 5]]),
        coordIndex=[2, 0, -1], colorIndex=[1]))
    yield "quant-14-used", "the points are those of a Coordinate used again", SceneStream().unit(c("scene", group(
        quantizer(), Node("Shape", geometry=Node("PointSet",
            coord=Node("Coordinate", id=1, point=[[i, i, i] for i in range(5)]))), used, flat))), "9.index-used"
    for name in ("IndexedFaceSet", "IndexedFaceSet2D", "IndexedLineSet", "IndexedLineSet2D"):
        flat = name.endswith("2D")
        points = Node("Coordinate2D" if flat else "Coordinate", point=[[i, 1] if flat else [i, 1, 2] for i in range(9)])
        given = {f.name: [8, 0, -1, 4] for f in NODES[name].mode("def") if f.category == 14}
        yield f"quant-14-{name.lower()}", f"every index of {name}, in a list description", SceneStream().unit(
            c("scene", group(
            quantizer(), Node("Shape", geometry=Node(name, form="list", coord=points, **given))))), "9.index-14"


def directions():
    vectors = [[0, 0, 1], [0, 0, -1], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0.6, 0.8, 0], [-0.6, 0.8, 0],
        [0.6, -0.8, 0],
               [0.48, 0.6, 0.64], [-0.48, -0.6, -0.64], [0.48, -0.6, 0.64]]
    rotations = [[0, 1, 0, 1], [1, 0, 0, 3], [0, 0, 1, 0.001], [0.6, 0.8, 0, 2], [-0.6, 0, 0.8, 1.5], [0, 0, -1, 2.5],
        [0.48, 0.6, 0.64, 1.2]]
    for bits in (2, 8, 16):
        yield f"quant-9-{bits}", f"category 9: normals of {bits} bits, in every direction", SceneStream().unit(
            c("scene", group(
            quantizer("normal", normalNbBits=bits), Node("Shape",
                geometry=Node("IndexedFaceSet", normal=Node("Normal", vector=vectors)))))), \
            "9.normal", TRIGONOMETRY
        yield f"quant-10-{bits}", f"category 10: rotations of {bits} bits", SceneStream().unit(c("scene", group(
            quantizer("normal", normalNbBits=bits), *[Node("Transform", rotation=r) for r in rotations], Node(
                "OrientationInterpolator", key=[0, 1], keyValue=rotations)))), "9.rotation", \
            [{**TRIGONOMETRY[0], "abs": 2e-5, "reason": "angles near 0 are restored from a cosine"}]


def scopes():
    move = lambda x: Node("Transform", translation=[x, x, x])
    fine = lambda **more: quantizer("position3D", position3DNbBits=10, **more)
    coarse = lambda **more: quantizer("position3D", position3DNbBits=4, **more)
    yield "quant-scope-list", "a quantizer holds for later siblings and below, not before and not behind the list", SceneStream().unit(
        c("scene", group(move(1.1), group(move(1.2), fine(), move(1.3), group(move(1.4), id=2)),
            move(1.5)))), "9.scope-list 9.scope-before"
    yield "quant-scope-parent", "fields of the parent behind its list are not quantized", SceneStream().unit(
        c("scene", group(Node("Transform", children=[fine(), move(1.3)],
            translation=[1.7, 1.7, 1.7])))), "9.scope-before"
    yield "quant-second", "a second quantizer replaces the first, which it does not add to", SceneStream().unit(
        c("scene", group(fine(), move(1.1), quantizer("color"), move(1.2),
            Node("PointLight", color=[0.1, 0.2, 0.3], location=[1.3, 1, 1])))), "9.second"
    for form in (list, Vector):
        yield f"quant-local-{form.__name__.lower()}", "local quantizers hold for one sibling", SceneStream().unit(
            c("scene", Node("Group", children=form([
                fine(isLocal=True), group(move(1.1), move(1.2)), move(1.3), coarse(isLocal=True), move(1.4),
                    move(1.5)])))), "9.local"
    yield "quant-itself", "a quantizer is coded under the one before it", SceneStream().unit(
        c("scene", group(fine(), coarse(), move(1.1)))), "9.itself"
    yield "quant-nested", "a quantizer within the scope of another", SceneStream().unit(
        c("scene", group(fine(), move(1.1), group(coarse(), move(1.2)), move(1.3)))), "9.scope-before 9.itself"
    world = SceneStream().unit(c("scene", group(move(1.1), id=1)))
    world.unit(c("quantize", fine()), c("insert_node", 1, "last", Node("Transform", id=2, translation=[1.2, 1, 1])))
    world.unit(c("replace_field", 2, "translation", [1.3, 2.3, 3.3]),
        c("insert_node", 1, "last", group(move(1.4), quantizer("color"), move(1.5))),
               c("replace_field", 2, "rotation", [0, 1, 0, 0.3]))
    world.unit(c("quantize", None), c("replace_field", 2, "translation", [1.3, 2.3, 3.3]))
    yield "quant-global", "the global quantizer, in later access units, around a local one, ended by NULL", world, "9.global 9.global-null 5.global-quantizer"
    elements = SceneStream().unit(c("scene", group(Node("Shape",
        geometry=Node("PointSet", coord=Node("Coordinate", id=1, point=[[1, 2, 3]]))))))
    elements.unit(c("quantize", fine()), c("insert_value", 1, "point", "last", [1.7, 2.7, 3.7]),
        c("replace_values", 1, "point", [(0, [0.1, 0.2, 0.3])]),
                  c("replace_fields", 1, point=[[9, 9, 9]]), c("xreplace", 1, "point", [1.23, 4, 5], position=0))
    yield "quant-elements", "elements of a list in commands are quantized as the list is", elements, "3.one-element 9.global"
    buffered = SceneStream().unit(c("scene", group(Node("Transform", id=1), fine(),
        Node("Conditional", id=2, buffer=Buffer(
        c("replace_field", 1, "translation", [1.23, 1, 1]))), move(1.23))))
    yield "quant-command-buffer", "no quantizer is active in a command buffer", buffered, "8.command-buffer 9.scope-list"


def efficient():
    numbers = [0, 1, -1, 2, 0.5, 3, -3.25, 0.1, 100000, 1e-20, 1e30, 123.456, 0.333333]
    yield "quant-efficient", "efficient floats of every kind", SceneStream().unit(c("scene", group(
        quantizer(useEfficientCoding=True), Node("ScalarInterpolator", key=[0, 1], keyValue=numbers),
            Node("Transform", translation=[1, -2, 0.75],
                                                                                               rotation=[0, 1, 0, 1.5])))), "9.efficient 9.efficient-all"
    yield "quant-efficient-quantizer", "a quantizer coded with efficient floats, and quantized fields beside efficient ones", SceneStream().unit(
        c("scene", group(quantizer(useEfficientCoding=True), quantizer("position3D", useEfficientCoding=True), Node(
            "Transform", translation=[1.1, 2.2, 3.3], scale=[1.1, 2, 3])))), "9.efficient-all"


def all_cases():
    for part in (linear, integers, directions, scopes, efficient):
        yield from part()
