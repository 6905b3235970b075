# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Scripts: token trees as bifs.md 13 has them, and the text that they stand for.

Expressions are tuples: ("number", 1.5), ("id", "a"), ("+", a, b), ("call", "f", a, b), ("new", "SFVec3f", a),
(".", a, "x"), ("method", a, "f", b), ("index", a, b), ("?", a, b, c), ("string", "x"), ("bool", True),
("var", "a", "b"), ("function", ["a"], block), ("()", a), ("-x", a), ("!x", a), ("~x", a), ("++x", a), ("x++", a).
A comma makes a compound: a list of expressions. Statements: ("if", c, block, block), ("for", c, c, c, block),
("while", c, block), ("return", c), ("do", c), ("break",), ("continue",), ("switch", c, [(1, block)], block).
A block is a list of statements, or one statement alone."""
from bits import bits_for
from node_facts import INTERFACE_TYPES, NODES, Definition

UNARY = {"-x": 1, "!x": 2, "~x": 3, "++x": 4, "--x": 5, "x++": 6, "x--": 7}
BINARY = {name: 17 + i for i, name in enumerate(
    ("= += -= *= /= %= &= |= ^= <<= >>= >>>= == != < <= > >= + - * / % && || & | ^ << >> >>>").split())}
DIGITS = {**{str(i): i for i in range(10)}, ".": 10, "E": 11, "-": 12}


class Script:
    """`fields` are node_facts.Field, each with its value as default (None: none), or its link: `links`."""

    def __init__(self, fields=(), functions=(), vector=False, links=None):
        self.fields, self.functions, self.vector, self.links = list(fields), functions, vector, links or {}


def first_script(node):
    urls = node.fields.get("url", ())
    return urls[0] if node.name == "Script" and urls and isinstance(urls[0], Script) else Script()


def own_names(node):
    return [field.name for field in first_script(node).fields] if node.name == "Script" else []


def definition_of(node):
    return Definition("Script", NODES["Script"].fields + first_script(node).fields)


class ScriptWriter:
    def __init__(self, values, known):
        self.values, self.out, self.known = values, values.out, known

    def identifier(self, name):
        received = name in self.known
        self.out.u(1, int(received), "received")
        if received:
            self.out.u(bits_for(len(self.known) - 1), self.known.index(name), "identifier")
        else:
            self.values.name(name)
            self.known.append(name)
        return name

    def arguments(self, names):
        for name in names:
            self.out.u(1, 1, "hasArgument")
            self.identifier(name)
        self.out.u(1, 0, "hasArgument")
        return ",".join(names)

    def function(self, name, arguments, block):
        self.identifier(name)
        text = f"function {name}({self.arguments(arguments)})"
        return text + self.block(block)

    def block(self, block):
        compound = isinstance(block, list)
        self.out.u(1, int(compound), "isCompound")
        if not compound:
            return self.statement(block)
        text = ""
        for statement in block:
            self.out.u(1, 1, "hasStatement")
            text += self.statement(statement)
        self.out.u(1, 0, "hasStatement")
        return "{" + text + "}"

    def statement(self, statement):
        kinds = ("if", "for", "while", "return", "do", "break", "continue", "switch")
        kind, *rest = statement
        self.out.u(3, kinds.index(kind), "statement")
        return getattr(self, "write_" + kind)(*rest)

    def write_if(self, condition, block, otherwise=None):
        text = f"if ({self.compound(condition)}) {self.block(block)}"
        self.out.u(1, int(otherwise is not None), "hasElse")
        return text + (" else " + self.block(otherwise) if otherwise is not None else "")

    def optional(self, compound):
        self.out.u(1, int(compound is not None), "optional")
        return self.compound(compound) if compound is not None else ""

    def write_for(self, first, condition, step, block):
        head = ";".join(self.optional(part) for part in (first, condition, step))
        return f"for ({head})" + self.block(block)

    def write_while(self, condition, block):
        return f"while ({self.compound(condition)})" + self.block(block)

    def write_return(self, value=None):
        self.out.u(1, int(value is not None), "hasValue")
        return "return;" if value is None else f"return {self.compound(value)};"

    def write_do(self, value):
        return self.compound(value) + ";"

    def write_break(self):
        return "break;"

    def write_continue(self):
        return "continue;"

    def write_switch(self, value, cases, otherwise=None):
        text = f"switch ({self.compound(value)})" + "{"
        width = max(bits_for(case) for case, _ in cases)
        self.out.u(5, width, "caseBits")
        for i, (case, block) in enumerate(cases):
            if i:
                self.out.u(1, 1, "moreCases")
            self.out.u(width, case, "case")
            text += f"case {case}:" + self.block(block)
        self.out.u(1, 0, "moreCases")
        self.out.u(1, int(otherwise is not None), "hasDefault")
        if otherwise is not None:
            text += "default:" + self.block(otherwise)
        return text + "}"

    def compound(self, expressions):
        expressions = expressions if isinstance(expressions, list) else [expressions]
        texts = []
        for i, expression in enumerate(expressions):
            if i:
                self.out.u(1, 1, "moreExpressions")
            texts.append(self.expression(expression))
        self.out.u(1, 0, "moreExpressions")
        return ",".join(texts)

    def parameters(self, expressions):
        texts = []
        for expression in expressions:
            self.out.u(1, 1, "hasParameter")
            texts.append(self.expression(expression))
        self.out.u(1, 0, "hasParameter")
        return "(" + ",".join(texts) + ")"

    def expression(self, expression):
        kind, *rest = expression
        if kind in UNARY:
            return self.unary(kind, *rest)
        if kind in BINARY:
            self.out.u(6, BINARY[kind], "expression")
            return self.expression(rest[0]) + kind + self.expression(rest[1])
        codes = {"()": 0, "?": 8, "string": 9, "number": 10, "id": 11, "call": 12, "new": 13, ".": 14,
                 "method": 15, "index": 16, "bool": 48, "var": 49, "function": 50}
        self.out.u(6, codes[kind], "expression")
        write = {"()": "group", "?": "choice", ".": "member"}.get(kind, kind)
        return getattr(self, "expression_" + write)(*rest)

    def unary(self, kind, operand):
        self.out.u(6, UNARY[kind], "expression")
        return kind.replace("x", self.expression(operand), 1)

    def expression_group(self, inner):
        return "(" + self.compound(inner) + ")"

    def expression_choice(self, condition, yes, no):
        return f"{self.expression(condition)} ? {self.expression(yes)} : {self.expression(no)}"

    def expression_string(self, text):
        self.values.name(text)
        return f"'{text}'"

    def expression_number(self, value):
        self.out.u(1, int(isinstance(value, int)), "isInteger")
        if isinstance(value, int):
            self.out.u(5, bits_for(value), "integer")
            self.out.u(bits_for(value), value, "integerValue")
            return str(value)
        for character in value:
            self.out.u(4, DIGITS[character], "digit")
        self.out.u(4, 15, "digit")
        return value

    def expression_id(self, name):
        return self.identifier(name)

    def expression_call(self, name, *parameters):
        return self.identifier(name) + self.parameters(parameters)

    def expression_new(self, name, *parameters):
        return "new " + self.identifier(name) + self.parameters(parameters)

    def expression_member(self, value, name):
        return self.expression(value) + "." + self.identifier(name)

    def expression_method(self, value, name, *parameters):
        return self.expression(value) + "." + self.identifier(name) + self.parameters(parameters)

    def expression_index(self, value, index):
        return self.expression(value) + "[" + self.compound(index) + "]"

    def expression_bool(self, value):
        self.out.u(1, int(value), "boolean")
        return "true" if value else "false"

    def expression_var(self, *names):
        return "var " + self.arguments(names)

    def expression_function(self, names, block):
        return f"function({self.arguments(names)})" + self.block(block)


def write_field(values, script, field):
    out = values.out
    out.u(2, {"field": 0, "eventIn": 1, "eventOut": 2}[field.event], "event")
    out.u(6, INTERFACE_TYPES[field.kind], "fieldType")
    values.name(field.name)
    found = {"name": field.name, "event": field.event, "type": field.type_text}
    if values.scope.interface is not None:
        linked = field.name in script.links
        out.u(1, int(linked), "isIS")
        if linked:
            interface = values.scope.interface
            out.u(bits_for(len(interface.fields) - 1), interface.index("all", script.links[field.name]),
                "interfaceField")
            return found
    if field.event == "field":
        out.u(1, int(field.default is not None), "hasValue")
        if field.default is not None:
            found["value"] = values.value(field, field.default)
    return found


def write(values, script):
    out = values.out
    out.u(1, int(not script.vector), "isList")
    interface = []
    if script.vector:
        out.u(4, bits_for(len(script.fields)), "countBits")
        out.u(bits_for(len(script.fields)), len(script.fields), "count")
    for field in script.fields:
        if not script.vector:
            out.u(1, 0, "endFlag")
        interface.append(write_field(values, script, field))
    if not script.vector:
        out.u(1, 1, "endFlag")
    out.u(1, 1, "reserved")
    writer = ScriptWriter(values, [field.name for field in script.fields])
    texts = []
    for function in script.functions:
        out.u(1, 1, "hasFunction")
        texts.append(writer.function(*function))
    out.u(1, 0, "hasFunction")
    return {"interface": interface, "javascript": "\n".join(texts)}
