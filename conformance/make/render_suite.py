# SPDX-License-Identifier: BSD-2-Clause
"""Writes conformance/suites/render: small scenes, and pictures of them cast ray by ray.

    python3 conformance/make/render_suite.py

Nothing here is shared with the renderers of afx: each scene is a text and, beside it, the same surfaces in closed form,
seen through a pinhole by 4 x 4 rays a pixel. Colours are mixed as they stand (sRGB), so pixels at edges are a little
off those of a renderer that mixes light; the tolerances say so. Written again the files are the same.
"""
import hashlib
import json
import math
import os
import struct
import zlib

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'suites', 'render')
SIZE = 96
RAYS = 4
EDGES = 'edges are mixed in linear light or in sRGB, and sampled more or less finely'
VOXELS = 'a renderer may draw the surface anywhere in the outer voxels, half a voxel in or out'
SPLATS = 'voxels and pixels with depth are drawn as splats of some size, which a renderer chooses'


def add(a, b): return tuple(x + y for x, y in zip(a, b))
def sub(a, b): return tuple(x - y for x, y in zip(a, b))
def mul(a, s): return tuple(x * s for x in a)
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def norm(a): return mul(a, 1 / math.sqrt(dot(a, a)))


def rotation(axis, angle):
    """The rows of the matrix that turns around an axis, right-handed."""
    x, y, z = norm(axis)
    c, s, t = math.cos(angle), math.sin(angle), 1 - math.cos(angle)
    return ((t * x * x + c, t * x * y - s * z, t * x * z + s * y),
            (t * x * y + s * z, t * y * y + c, t * y * z - s * x),
            (t * x * z - s * y, t * y * z + s * x, t * z * z + c))


def turn(rows, v): return tuple(dot(r, v) for r in rows)
def turn_back(rows, v): return tuple(sum(rows[i][k] * v[i] for i in range(3)) for k in range(3))


class Placed:
    """A surface under a Transform: scale, then rotation, then translation."""

    def __init__(self, surface, move=(0, 0, 0), axis=(0, 0, 1), angle=0, scale=(1, 1, 1)):
        self.surface, self.move, self.rows, self.scale = surface, move, rotation(axis, angle), scale

    def hit(self, origin, way):
        o = turn_back(self.rows, sub(origin, self.move))
        d = turn_back(self.rows, way)
        found = self.surface.hit(tuple(a / s for a, s in zip(o, self.scale)),
                                 tuple(a / s for a, s in zip(d, self.scale)))
        if found is None:
            return None
        t, normal, colour = found
        return t, norm(turn(self.rows, tuple(a / s for a, s in zip(normal, self.scale)))), colour


class Sphere:
    def __init__(self, radius, colour): self.radius, self.colour = radius, colour

    def hit(self, o, d):
        a, b, c = dot(d, d), dot(o, d), dot(o, o) - self.radius ** 2
        root = b * b - a * c
        if root < 0:
            return None
        t = (-b - math.sqrt(root)) / a
        return (t, add(o, mul(d, t)), self.colour) if t > 0 else None


class Box:
    def __init__(self, size, colour): self.half, self.colour = mul(size, .5), colour

    def hit(self, o, d):
        near, far, side = -math.inf, math.inf, None
        for k in range(3):
            if d[k] == 0:
                if abs(o[k]) > self.half[k]:
                    return None
                continue
            sign = 1 if d[k] > 0 else -1
            t0, t1 = (-sign * self.half[k] - o[k]) / d[k], (sign * self.half[k] - o[k]) / d[k]
            if t0 > near:
                near, side = t0, tuple(-sign if i == k else 0 for i in range(3))
            far = min(far, t1)
        return (near, side, self.colour) if 0 < near < far else None


class PaintedBox(Box):
    """A cube whose points have the colour of the picture in front of them."""

    def __init__(self, size, rows): super().__init__(size, None); self.rows = rows

    def hit(self, o, d):
        found = super().hit(o, d)
        if found is None:
            return None
        x, y, _ = add(o, mul(d, found[0]))
        cell = [min(1, max(0, int((v / (2 * h) + .5) * 2))) for v, h in ((x, self.half[0]), (y, self.half[1]))]
        return found[0], found[1], self.rows[cell[1]][cell[0]]


class Cylinder:
    def __init__(self, radius, height, colour): self.radius, self.half, self.colour = radius, height / 2, colour

    def hit(self, o, d):
        best = None
        a, b = d[0] ** 2 + d[2] ** 2, o[0] * d[0] + o[2] * d[2]
        root = b * b - a * (o[0] ** 2 + o[2] ** 2 - self.radius ** 2)
        if a > 0 and root >= 0:
            t = (-b - math.sqrt(root)) / a
            p = add(o, mul(d, t))
            if t > 0 and abs(p[1]) <= self.half:
                best = (t, (p[0], 0, p[2]), self.colour)
        for y in (-self.half, self.half):
            if d[1] != 0 and (t := (y - o[1]) / d[1]) > 0 and (best is None or t < best[0]):
                p = add(o, mul(d, t))
                if p[0] ** 2 + p[2] ** 2 <= self.radius ** 2:
                    best = (t, (0, math.copysign(1, y), 0), self.colour)
        return best


class Cone:
    def __init__(self, radius, height, colour): self.radius, self.height, self.colour = radius, height, colour

    def hit(self, o, d):
        k, top = self.radius / self.height, self.height / 2
        best = None
        y = top - o[1]
        a = d[0] ** 2 + d[2] ** 2 - (k * d[1]) ** 2
        b = o[0] * d[0] + o[2] * d[2] + k * k * y * d[1]
        c = o[0] ** 2 + o[2] ** 2 - (k * y) ** 2
        root = b * b - a * c
        if abs(a) > 1e-12 and root >= 0:
            for t in sorted(((-b - math.sqrt(root)) / a, (-b + math.sqrt(root)) / a)):
                p = add(o, mul(d, t))
                if t > 0 and -top <= p[1] <= top:
                    best = (t, (p[0], k * k * (top - p[1]), p[2]), self.colour)
                    break
        if d[1] != 0 and (t := (-top - o[1]) / d[1]) > 0 and (best is None or t < best[0]):
            p = add(o, mul(d, t))
            if p[0] ** 2 + p[2] ** 2 <= self.radius ** 2:
                best = (t, (0, -1, 0), self.colour)
        return best


class Polygon:
    """Convex, in a plane; seen from both sides where it is not solid."""

    def __init__(self, points, colour, solid=False):
        self.points, self.colour, self.solid = points, colour, solid
        u, v = sub(points[1], points[0]), sub(points[2], points[0])
        self.normal = norm((u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]))

    def hit(self, o, d):
        facing = dot(self.normal, d)
        if facing == 0 or (self.solid and facing > 0):
            return None
        t = dot(self.normal, sub(self.points[0], o)) / facing
        p = add(o, mul(d, t))
        for a, b in zip(self.points, self.points[1:] + self.points[:1]):
            edge, to = sub(b, a), sub(p, a)
            cross = (edge[1] * to[2] - edge[2] * to[1], edge[2] * to[0] - edge[0] * to[2],
                     edge[0] * to[1] - edge[1] * to[0])
            if dot(cross, self.normal) < 0:
                return None
        return (t, self.normal, self.colour) if t > 0 else None


class Chequer:
    """A rectangle in z = 0 around the origin, of rows of coloured cells, the lowest row first."""

    def __init__(self, width, height, rows): self.size, self.rows = (width, height), rows

    def hit(self, o, d):
        if d[2] == 0 or (t := -o[2] / d[2]) <= 0:
            return None
        u, v = ((o[k] + d[k] * t) / self.size[k] + .5 for k in (0, 1))
        if not (0 <= u < 1 and 0 <= v < 1):
            return None
        row = self.rows[int(v * len(self.rows))]
        return t, (0, 0, 1), row[int(u * len(row))]


def picture(surfaces, sky, eye=(0, 0, 10), axis=(0, 0, 1), angle=0, fov=math.pi / 4, light=None):
    """RGB rows from the top. light: a direction and a surface's own part of light (emissive if None)."""
    rows, reach, view = [], math.tan(fov / 2), rotation(axis, angle)
    for j in range(SIZE):
        row = bytearray()
        for i in range(SIZE):
            total = [0.0, 0.0, 0.0]
            for k in range(RAYS * RAYS):
                x = (2 * (i + (k % RAYS + .5) / RAYS) / SIZE - 1) * reach
                y = (1 - 2 * (j + (k // RAYS + .5) / RAYS) / SIZE) * reach
                way = turn(view, (x, y, -1))
                hits = [h for s in surfaces if (h := s.hit(eye, way)) is not None]
                colour = sky
                if hits:
                    _, normal, colour = min(hits, key=lambda h: h[0])
                    if light is not None:
                        n = norm(normal)
                        if dot(n, way) > 0:
                            n = mul(n, -1)
                        colour = mul(colour, max(0, dot(n, mul(norm(light), -1))))
                total = [a + c for a, c in zip(total, colour)]
            row += bytes(min(255, int(255 * c / RAYS ** 2 + .5)) for c in total) + b'\xff'
        rows.append(bytes(row))
    return rows


def png(rows):
    def chunk(name, data):
        return struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data))
    head = struct.pack('>IIBBBBB', SIZE, len(rows), 8, 6, 0, 0, 0)
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) +
            chunk(b'IDAT', zlib.compress(b''.join(b'\0' + r for r in rows), 9)) + chunk(b'IEND', b''))


RED, GREEN, BLUE, YELLOW, SKY = (1, .2, .1), (.1, .8, .3), (.2, .3, 1), (1, .9, .2), (.1, .1, .2)
HEAD = '''#VRML V2.0 utf8
NavigationInfo { headlight FALSE }
Background { skyColor [ .1 .1 .2 ] }
'''
FRONT = 'Viewpoint { position 0 0 10 orientation 0 0 1 0 fieldOfView .785398163 }\n'


def text(values): return ' '.join(repr(float(v)) for v in values)
def glow(colour): return 'appearance Appearance { material Material { emissiveColor %s diffuseColor 0 0 0 } }' % text(colour)
def matt(colour): return 'appearance Appearance { material Material { diffuseColor %s ambientIntensity 0 } }' % text(colour)
def shape(look, geometry): return 'Shape { %s geometry %s }\n' % (look, geometry)


def under(inside, move=(0, 0, 0), axis=(0, 0, 1), angle=0, scale=(1, 1, 1)):
    return 'Transform { translation %s rotation %s %r scale %s children [\n%s] }\n' % (
        text(move), text(axis), angle, text(scale), inside)


def pixels(rows, depth=None):
    """A PixelTexture of three components, or of one that says a depth in each pixel."""
    width, height = len(rows[0]), len(rows)
    if depth is None:
        values = ['0x%02x%02x%02x' % tuple(int(255 * c + .5) for c in cell) for row in rows for cell in row]
    else:
        values = [str(depth)] * (width * height)
    return 'PixelTexture { image %d %d %d %s }' % (width, height, 3 if depth is None else 1, ' '.join(values))


def enlarged(rows, times): return [[cell for cell in row for _ in range(times)] for row in rows for _ in range(times)]


def simple_plane(rows, size, depth, near, far):
    """A DepthImage in front of the origin that looks along -z in parallel, all at one depth."""
    return ('DepthImage { position 0 0 5 orientation 0 0 1 0 orthographic TRUE fieldOfView %s nearPlane %r farPlane %r\n'
            'diTexture SimpleTexture { texture %s depth %s } }\n' %
            (text(size), near, far, pixels(rows), pixels(rows, depth)))


def cases():
    ball, block = Sphere(2, RED), Box((3, 2, 1), GREEN)
    yield ('sphere', 'a sphere that glows', ['render.sphere', 'render.viewpoint'],
           FRONT + shape(glow(RED), 'Sphere { radius 2 }'), [Placed(ball)], {}, .6, EDGES)
    tilt = dict(move=(.5, -.3, 1), axis=(1, 2, 3), angle=1.1)
    yield ('box-turned', 'a box, turned and moved', ['render.box', 'render.transform'],
           FRONT + under(shape(glow(GREEN), 'Box { size 3 2 1 }'), **tilt), [Placed(block, **tilt)], {}, .6, EDGES)
    egg = dict(axis=(0, 0, 1), angle=.7, scale=(1, .5, 2))
    yield ('sphere-scaled', 'an ellipsoid: scale comes before rotation', ['render.transform'],
           FRONT + under(shape(glow(RED), 'Sphere { radius 2 }'), **egg), [Placed(ball, **egg)], {}, .6, EDGES)
    lean = dict(axis=(1, 0, 0), angle=.6)
    yield ('cylinder-leaning', 'a cylinder that shows its top', ['render.cylinder'],
           FRONT + under(shape(glow(BLUE), 'Cylinder { radius 1.2 height 3 }'), **lean),
           [Placed(Cylinder(1.2, 3, BLUE), **lean)], {}, .6, EDGES)
    back = dict(axis=(1, 0, 0), angle=-.9)
    yield ('cone-leaning', 'a cone that shows its bottom', ['render.cone'],
           FRONT + under(shape(glow(YELLOW), 'Cone { bottomRadius 1.5 height 3 }'), **back),
           [Placed(Cone(1.5, 3, YELLOW), **back)], {}, .6, EDGES)
    through = dict(move=(1, .5, 0))
    yield ('pierced', 'a box that sticks out of a sphere: the nearest is seen at each point', ['render.occlusion'],
           FRONT + shape(glow(RED), 'Sphere { radius 2 }') + under(shape(glow(GREEN), 'Box { size 3 2 4.2 }'), **through),
           [Placed(ball), Placed(Box((3, 2, 4.2), GREEN), **through)], {}, .6, EDGES)
    eye = dict(eye=(6, 3, 7), axis=(-.35, .7, .1), angle=.8, fov=.9)
    yield ('viewpoint', 'a camera that stands aside, turned', ['render.viewpoint'],
           'Viewpoint { position 6 3 7 orientation -.35 .7 .1 .8 fieldOfView .9 }\n' +
           shape(glow(RED), 'Sphere { radius 2 }') + under(shape(glow(GREEN), 'Box { size 3 2 1 }'), move=(0, -2.5, 0)),
           [Placed(ball), Placed(block, move=(0, -2.5, 0))], eye, .6, EDGES)
    lamp = 'DirectionalLight { direction -1 -1 -2 intensity 1 ambientIntensity 0 }\n'
    yield ('light', 'a directional light on a matt sphere and box', ['render.light'],
           FRONT + lamp + under(shape(matt(YELLOW), 'Sphere { radius 1.4 }'), move=(-1.5, 0, 0)) +
           under(shape(matt(GREEN), 'Box { size 3 2 1 }'), move=(1.8, 0, 0), axis=(1, 2, 3), angle=1.1),
           [Placed(Sphere(1.4, YELLOW), move=(-1.5, 0, 0)),
            Placed(block, move=(1.8, 0, 0), axis=(1, 2, 3), angle=1.1)],
           dict(light=(-1, -1, -2)), 1, EDGES)
    roof = [(-2, -1, 0), (0, -1, 2), (0, 2, 0)], [(0, -1, 2), (2, -1, 0), (0, 2, 0)]
    yield ('faces', 'faces with a colour each; those that face away are not seen', ['render.faces'],
           FRONT + shape('appearance Appearance { material Material { } }',
                         'IndexedFaceSet { coord Coordinate { point [ -2 -1 0 0 -1 2 0 2 0 2 -1 0 ] }\n'
                         'coordIndex [ 0 1 2 -1 1 3 2 -1 1 0 2 -1 ] colorPerVertex FALSE\n'
                         'color Color { color [ 1 .2 .1 .2 .3 1 .1 .8 .3 ] } }') +
           'DirectionalLight { direction 0 0 -1 intensity 1 }\n',
           [Polygon(roof[0], RED, True), Polygon(roof[1], BLUE, True)], dict(light=(0, 0, -1)), 1, EDGES)
    yield ('switch', 'of a Switch only the choice is seen', ['render.switch'],
           FRONT + 'Switch { whichChoice 1 choice [ %s %s %s ] }\n' % (
               shape(glow(RED), 'Sphere { radius 2 }'), shape(glow(GREEN), 'Box { size 3 2 1 }'),
               shape(glow(BLUE), 'Cylinder { radius 1.2 height 3 }')), [Placed(block)], {}, .6, EDGES)
    flag = [[RED, GREEN], [BLUE, YELLOW]]
    fine = enlarged(flag, 16)
    yield ('simple-texture', 'a SimpleTexture at one depth: a rectangle of four colours, in its place',
           ['render.simple-texture', 'render.depth-rule'],
           FRONT + simple_plane(fine, (4, 4), 128, 1, 9), [Placed(Chequer(4, 4, flag), move=(0, 0, 5 - (1 + 127 / 254 * 8)))],
           {}, 2, SPLATS)
    yield ('simple-texture-turned', 'the same under a Transform and seen from aside', ['render.simple-texture', 'render.transform'],
           FRONT + under(simple_plane(fine, (4, 4), 128, 1, 9), axis=(0, 1, 0), angle=.8),
           [Placed(Placed(Chequer(4, 4, flag), move=(0, 0, 5 - (1 + 127 / 254 * 8))), axis=(0, 1, 0), angle=.8)],
           {}, 2, SPLATS)
    yield ('simple-texture-occluded', 'a sphere in front of, and through, a SimpleTexture', ['render.occlusion', 'render.simple-texture'],
           FRONT + simple_plane(fine, (4, 4), 128, 1, 9) + shape(glow(YELLOW), 'Sphere { radius 1.2 }'),
           [Placed(Chequer(4, 4, flag), move=(0, 0, 5 - (1 + 127 / 254 * 8))), Placed(Sphere(1.2, YELLOW))], {}, 2, SPLATS)
    full = '[ %s ]' % ' '.join(['255'] * (1 + 8 + 64 + 512))
    octree = ('OctreeImage { octreeResolution 16 octree %s voxelImageIndex [ 1 ]\n'
              'images [ DepthImage { position 0 0 1 orthographic TRUE fieldOfView 1 1 diTexture SimpleTexture { texture %s } } ] }\n'
              % (full, pixels(enlarged(flag, 8))))
    yield ('octree-image', 'a full OctreeImage: a cube coloured by one picture', ['render.octree-image'],
           FRONT + under(octree, scale=(4, 4, 4)),
           [PaintedBox((4, 4, 4), flag)], {}, 6, VOXELS)
    points = ' '.join(['1 128'] * 1024)
    colours = ' '.join(text(cell) for row in fine for cell in row)
    yield ('point-texture', 'a PointTexture of one depth a pixel: the same rectangle', ['render.point-texture', 'render.depth-rule'],
           FRONT + 'DepthImage { position 0 0 5 orthographic TRUE fieldOfView 4 4 nearPlane 1 farPlane 9\n'
           'diTexture PointTexture { width 32 height 32 depthNbBits 7 depth [ %s ] color [ %s ] } }\n' % (points, colours),
           [Placed(Chequer(4, 4, flag), move=(0, 0, 5 - (1 + 127 / 254 * 8)))], {}, 2, SPLATS)


RULES = [
    ('render.viewpoint', 'dibr-nodes, VRML97', 'A scene is seen from its first Viewpoint; fieldOfView is the angle of the shorter side.'),
    ('render.transform', 'VRML97', 'A Transform scales first, then turns, then moves.'),
    ('render.sphere', 'VRML97', 'A Sphere has its radius around the origin.'),
    ('render.box', 'VRML97', 'A Box has its size, half to each side of the origin.'),
    ('render.cylinder', 'VRML97', 'A Cylinder stands upright, with a top and a bottom.'),
    ('render.cone', 'VRML97', 'A Cone has its tip at half its height and its bottom as far below.'),
    ('render.faces', 'VRML97', 'Faces are seen from the side where their corners run anticlockwise; a face may have its own colour.'),
    ('render.light', 'VRML97', 'Diffuse light is that of the cosine between the light and the normal.'),
    ('render.switch', 'VRML97', 'Of a Switch the child of whichChoice alone is there.'),
    ('render.occlusion', 'dibr-nodes, Rendering', 'DIBR nodes and geometry hide each other by depth, point by point.'),
    ('render.simple-texture', 'dibr-nodes, SimpleTexture', 'A pixel of a SimpleTexture stands where its cell\'s centre and its depth put it.'),
    ('render.depth-rule', 'dibr-nodes, SimpleTexture', 'The depth 1 is the far plane, the largest the near plane, linear between.'),
    ('render.point-texture', 'dibr-nodes, PointTexture', 'The points of a PointTexture begin at the lower left corner, row by row upward.'),
    ('render.octree-image', 'dibr-nodes, OctreeImage', 'The octree fills the cube of side 1 around the origin; a voxel has the colour of the pixel its centre falls on.'),
]


def digest(data): return hashlib.sha256(data).hexdigest()


def write(name, data):
    with open(os.path.join(FOLDER, name), 'wb') as out:
        out.write(data)
    return digest(data)


def main():
    os.makedirs(FOLDER, exist_ok=True)
    listed = []
    for name, about, covers, body, surfaces, camera, most, reason in cases():
        image = png(picture(surfaces, SKY, **camera))
        listed.append({
            'name': name, 'about': about, 'kind': 'wrl', 'stream': name + '.wrl',
            'sha256': write(name + '.wrl', (HEAD + body).encode()), 'origin': 'rays', 'covers': covers,
            'expect': [{'check': 'render', 'file': name + '.png', 'sha256': write(name + '.png', image),
                        'width': SIZE, 'height': SIZE, 'maxMean': most, 'reason': reason}]})
    suite = {
        '$schema': '../suite.schema.json', 'suite': 'render', 'title': 'Pictures of scenes in closed form',
        'rules': ['../rules/render.json'],
        'origins': {'rays': {'text': 'written for this project; pictures cast ray by ray by conformance/make/render_suite.py',
                             'licence': 'BSD-2-Clause'}},
        'cases': listed}
    write('suite.json', (json.dumps(suite, indent=1) + '\n').encode())
    rules = {'$schema': '../rules.schema.json', 'area': 'render', 'source': 'dibr-nodes: Rendering; VRML97 for ordinary geometry',
             'rules': [{'id': i, 'section': s, 'text': t} for i, s, t in RULES]}
    os.makedirs(os.path.join(FOLDER, '..', 'rules'), exist_ok=True)
    write('../rules/render.json', (json.dumps(rules, indent=1) + '\n').encode())


if __name__ == '__main__':
    main()
