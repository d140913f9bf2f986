"""What the window tests of skins share: steps by their labels, strokes of the mouse."""

import math


def label(window, text, what=None):
    window.wait(lambda: window.last("document")["label"] == text, what or f"step {text}; it is {window.last('document')}")
    window.wait_idle()
    return window.last("document")["position"]


def choose(window, menu, *items):
    window.click_on("menu." + menu)
    for item in items:
        window.click_on(item)


def skin_mark(window, name):
    return window.center("skin." + name)


def stroke(window, *corners, steps=8):
    """One stroke of the left button along a polyline."""
    window.move(*corners[0])
    window.press()
    for a, b in zip(corners, corners[1:]):
        for i in range(1, steps + 1):
            window.move(a[0] + (b[0] - a[0]) * i / steps, a[1] + (b[1] - a[1]) * i / steps)
    window.release()


def between(a, b, share=0.5):
    return a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share


def capsule(a, b, radius):
    """A closed curve round two points, at about this distance."""
    angle = math.atan2(b[1] - a[1], b[0] - a[0])
    points = []
    for centre, begin in ((b, angle - math.pi / 2), (a, angle + math.pi / 2)):
        for i in range(7):
            turn = begin + math.pi * i / 6
            points.append((centre[0] + radius * math.cos(turn), centre[1] + radius * math.sin(turn)))
    return points + [points[0]]
