"""Lessons for the player and for the window: with each kind of answer, and with one prediction."""

from pathlib import Path

from app.lessons.checking import CheckReport
from app.lessons.course import AtStep, Course
from app.lessons.lesson import parse_lesson
from app.model.refusal import Refusal


def asked_at(body: str, test: str = "", kind: str = "answer", *, state: str = "") -> AtStep:
    """Return the step of a lesson with one block, ``mine``, and perhaps a test of it."""
    shown = f"```state\n{state}```\n" if state else ""
    sample = f"```test\n{test}\n```\n" if test else ""
    text = f"---\ntitle: T\n---\n# A\n{shown}```{kind} mine\n{body}```\n{sample}"
    return Course(parse_lesson(text, Path("l.md"))).at(0)


def faults(*block: str, state: str = "") -> str:
    """Return what a check complains of; the arguments are those of `asked_at`."""
    report = CheckReport()
    try:
        report.take(asked_at(*block, state=state).course.lesson)
    except Refusal as error:
        return str(error)
    return "\n".join(map(str, report.wrong))


def lesson_of(*states: str) -> str:
    """Return a talk of steps s1, s2, … in these states; an empty one changes nothing."""
    blocks = (f"```state\n{state}\n```\n" if state else "" for state in states)
    steps = (f"# Step {at} {{#s{at}}}\n{block}" for at, block in enumerate(blocks, 1))
    return "---\ntitle: T\nletters: own\n---\n" + "---\n".join(steps) + "```note\nminutes: 1\n```\n"


LESSON = """---
title: How wide?
---
# The angle {#angle}
It is *vertical*, <script>alert(1)</script> $a = 9/16$.

```state
scene=letter-f
lens.fov_y_deg=45
```

```predict wide
60°, 16:9. How wide?
- [ ] 106.7° := aspect*fov {angle-linear}
- [x] 91.5° := fov_x
- [ ] 12°
  says: That is a telephoto lens.
show: lens.fov_y_deg=60
why: The tangent grows faster.
```

What comes of it.

---
# By hand {#hand}
```task near
Bring the near plane closer.
until: near < was_near
wrong look-n: near > 2*was_near
hint: Drag it.
right: lens.near=0.4
done: It is closer.
```

```task cube
Bring the cube into the large place.
until: view.large = ndc
```

```test
near: lens.near=11 -> look-n
near: lens.near=0.4 -> done
```

---
# Numbers {#numbers}
```answer wide
60° high, 2:1. How wide?
value: 2*atan(2*tan(60/2))
unit: °
wrong angle-linear: 2*60
hint: Take the tangent.
hint: Of half the angle.
why: It is 98.2.
```

```answer half
Half of it all?
value: 1/2
hint: One by two.
```

```answer which
Which is it?
- [x] this
- [ ] that
  says: That is another.
```

```test
half: 0.5 -> right
```

---
# The end {#end}
Read.
"""

PREDICTED = """---
title: T
---
# One {#one}
```state
scene=letter-f
```
```predict nearer
Where is near?
- [x] At 2 := near
- [ ] At 3
  says: It is nearer.
  state: lens.near=2
- [ ] At 4
  says: It is nearer.
  state: lens.near=4
show: lens.near=2
```
"""
