#!/usr/bin/env python3
"""make.py libqtraj.so.0 PICTURE.svg: draws docs/pictures/curves.svg with an installed library.

Six keys of one motion, three methods: on the left the way of the body's x axis on the unit sphere, on the right the
angular speed. No background, colours of medium brightness: to be read on white and on black.
"""
import ctypes
import math
import sys
from ctypes import POINTER, byref, c_double, c_int32, c_size_t, c_void_p

KEY_TIMES = [0.0, 1.0, 1.8, 3.0, 3.6, 5.0]  # s
KEY_ANGLES = [(-64, 6, 5), (-42, -22, 25), (-12, 12, 50), (8, 48, 25), (36, 20, 5), (58, -28, -15)]  # degrees
LABELS = [("middle", 0, -10), ("middle", 0, 21), ("end", -10, 2), ("middle", 0, -10), ("start", 9, -4),
          ("start", 9, 12)]  # of the keys: anchor and place beside the dot
METHODS = [("SLERP", 1, "#d9822b"), ("SQUAD", 3, "#4c8dff"), ("ROTATION_SPLINE", 5, "#2ca66f")]
GREY = "#7d8590"
BODY, WORLD = 101, 102
STEPS = 300

WIDTH, HEIGHT = 840, 370
CENTRE, RADIUS = (178, 178), 158  # of the sphere
LEFT, RIGHT, TOP, BOTTOM = 410, 826, 62, 322  # of the plot
VIEW_TILT = math.radians(14)  # the eye is that much above the equator


def load(path):
    library = ctypes.CDLL(path)
    doubles = POINTER(c_double)
    library.qtraj_create.argtypes = [c_int32, doubles, doubles, c_size_t, POINTER(c_void_p), POINTER(c_size_t)]
    library.qtraj_sample_rates.argtypes = [
        c_void_p, c_int32, doubles, c_size_t, doubles, doubles, doubles, POINTER(c_size_t)]
    library.qtraj_rotate.argtypes = [doubles, c_size_t, doubles, c_size_t, c_size_t, doubles, POINTER(c_size_t)]
    library.qtraj_destroy.argtypes = [c_void_p]
    library.qtraj_destroy.restype = None
    return library


def array(numbers):
    return (c_double * len(numbers))(*numbers)


def rows(flat, length):
    return [tuple(flat[i:i + length]) for i in range(0, len(flat), length)]


def must(status):
    if status:
        sys.exit(f"status {status}")


def product(a, b):
    return (a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0])


def key(azimuth, elevation, roll):
    """Body to world: the x axis at that azimuth and elevation, rolled about itself; degrees."""
    def turn(axis, degrees):
        half = math.radians(degrees) / 2
        return tuple([math.cos(half)] + [math.sin(half) * (k == axis) for k in range(3)])
    return product(product(turn(2, azimuth), turn(1, -elevation)), turn(0, roll))


def sample(library, method, times):
    """World directions of the body's x axis, and angular speeds, rad/s."""
    curve, count = c_void_p(), len(times)
    q, omega, x_axis = (c_double * (4 * count))(), (c_double * (3 * count))(), (c_double * (3 * count))()
    keys = array([component for angles in KEY_ANGLES for component in key(*angles)])
    must(library.qtraj_create(method, array(KEY_TIMES), keys, len(KEY_TIMES), byref(curve), None))
    must(library.qtraj_sample_rates(curve, WORLD, array(times), count, q, omega, None, None))
    must(library.qtraj_rotate(q, count, array([1, 0, 0]), 1, count, x_axis, None))
    library.qtraj_destroy(curve)
    return rows(x_axis, 3), [math.hypot(*rate) for rate in rows(omega, 3)]


def on_sphere(v):
    """Picture coordinates, and whether the point is on the side of the eye, which looks along -x."""
    x = math.cos(VIEW_TILT) * v[0] + math.sin(VIEW_TILT) * v[2]
    up = math.cos(VIEW_TILT) * v[2] - math.sin(VIEW_TILT) * v[0]
    return CENTRE[0] + RADIUS * v[1], CENTRE[1] - RADIUS * up, x > 0


def in_plot(time, speed, top_speed):
    return (LEFT + (RIGHT - LEFT) * time / KEY_TIMES[-1], BOTTOM - (BOTTOM - TOP) * speed / top_speed)


def path(points, colour, width, opacity=1.0):
    steps = " ".join(f"{'L' if i else 'M'}{x:.1f} {y:.1f}" for i, (x, y) in enumerate(points))
    return (f'<path d="{steps}" fill="none" stroke="{colour}" stroke-width="{width}" stroke-opacity="{opacity}" '
            f'stroke-linejoin="round"/>')


def text(x, y, words, anchor="start", colour=GREY, size=13):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}" font-size="{size}">{words}</text>'


def front_pieces(points):
    """The parts of a line on the sphere that the eye sees."""
    piece = []
    for x, y, front in points:
        if front:
            piece.append((x, y))
        elif piece:
            yield piece
            piece = []
    if piece:
        yield piece


def sphere():
    x, y = CENTRE
    yield f'<circle cx="{x}" cy="{y}" r="{RADIUS}" fill="{GREY}" fill-opacity="0.06" stroke="{GREY}"/>'
    circle = [math.radians(degrees) for degrees in range(-180, 181, 3)]
    grid = [[(math.cos(a) * math.cos(e), math.sin(a) * math.cos(e), math.sin(e)) for a in circle]
            for e in map(math.radians, (-60, -30, 0, 30, 60))]
    grid += [[(math.cos(a) * math.cos(e), math.sin(a) * math.cos(e), math.sin(e)) for e in circle]
             for a in map(math.radians, range(0, 180, 30))]
    for line in grid:
        for piece in front_pieces([on_sphere(v) for v in line]):
            yield path(piece, GREY, 0.7, 0.45)


def axes(top_speed):
    yield path([(LEFT, TOP), (LEFT, BOTTOM), (RIGHT, BOTTOM)], GREY, 1)
    for time in KEY_TIMES:
        x, _ = in_plot(time, 0, top_speed)
        yield path([(x, TOP), (x, BOTTOM)], GREY, 0.7, 0.45)
        yield text(x, BOTTOM + 17, f"{time:g}", "middle")
    for half in range(0, int(2 * top_speed) + 1):
        speed = half / 2
        _, y = in_plot(0, speed, top_speed)
        yield path([(LEFT - 4, y), (LEFT, y)], GREY, 1)
        yield text(LEFT - 8, y + 4, f"{speed:g}", "end")
    yield text(LEFT, TOP - 12, "angular speed, rad/s")
    yield text(RIGHT, BOTTOM + 36, "time, s; lines at the keys", "end")


def main(library_path, picture):
    library = load(library_path)
    end = KEY_TIMES[-1]
    # just before and at each key too, where a speed may jump
    times = sorted({end * i / STEPS for i in range(STEPS + 1)} | set(KEY_TIMES) | {t - 1e-6 for t in KEY_TIMES[1:-1]})
    sampled = [(name, colour, *sample(library, method, times)) for name, method, colour in METHODS]
    top_speed = 1.04 * max(max(speeds) for *_, speeds in sampled)

    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" '
             f'height="{HEIGHT}" font-family="DejaVu Sans, Verdana, sans-serif">',
             "<title>One motion through six keys by SLERP, SQUAD and ROTATION_SPLINE</title>"]
    lines += sphere()
    lines += axes(top_speed)
    for name, colour, axis, speeds in sampled:
        for piece in front_pieces([on_sphere(v) for v in axis]):
            lines.append(path(piece, colour, 2.4))
        lines.append(path([in_plot(t, speed, top_speed) for t, speed in zip(times, speeds)], colour, 2.4))
    for angles, time, (anchor, right, down) in zip(KEY_ANGLES, KEY_TIMES, LABELS):
        azimuth, elevation = map(math.radians, angles[:2])
        x, y, _ = on_sphere((math.cos(azimuth) * math.cos(elevation), math.sin(azimuth) * math.cos(elevation),
                             math.sin(elevation)))
        lines.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5" fill="{GREY}"/>')
        lines.append(text(x + right, y + down, f"{time:g} s", anchor))
    x = LEFT
    for name, colour, *_ in sampled:
        lines.append(path([(x, 20), (x + 24, 20)], colour, 3))
        lines.append(text(x + 30, 25, name, colour=colour, size=14))
        x += 30 + 10.2 * len(name) + 26
    lines.append(text(CENTRE[0], HEIGHT - 8, "the body's x axis on the unit sphere", "middle"))
    lines.append("</svg>")
    with open(picture, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
