"""A lesson with a block of every kind, and the mistakes that teachers make in one."""

LESSON = """---
title: Mistakes
topic: L3
---
# One {#one}
The angle is $2 \\arctan(h/2)$.

```state
scene=letter-f
lens.fov_y_deg=60
lens.near=2
```
```predict wide
Is the picture of 60° wider than high?
- [x] 91.5° := fov_x
- [ ] 106.7° := aspect*fov {angle-linear}
- [ ] 12°
  says: That is a telephoto lens.
show: lens.fov_y_deg=60
check: fov_x > fov
```
```task near
Bring the near plane closer.
until: near < was_near
hint: Drag it.
```
```answer angle
60° high, 2:1. How wide?
value: 2*atan(2*tan(60/2))
unit: °
wrong angle-linear: 2*60
wrong mine: 30
  says: That is half of it.
hint: Take the tangent.
```
```answer scale
Scale by 2 and by 3.
matrix: 2, 0; 0, 3
wrong order: 3, 0; 0, 2
```
```answer place
Where is the middle?
click: image
at: width/2, height/2
```
```exercise drawn
vary f: 20..100 step 1
vary a: 4/3, 16/9, 2
where: f < 90
state: lens.fov_y_deg={=f}
{=f}° high, {=a} times as wide. How wide?
value: 2*atan(a*tan(f/2))
unit: °
wrong angle-linear: a*f
hide: numbers
```
```test
wide: 1 -> right
near: lens.near=1 -> done
angle: 98.2 -> right
scale: 2 | 0; 0 | 3 -> right
place: 640 360 -> right
drawn: 1 1 -> wrong
```
"""
MISTAKES = {
    "two right choices": ("- [ ] 12°", "- [x] 12°", "just one of them right"),
    "no right choice": ("- [x] 91.5°", "- [ ] 91.5°", "just one of them right"),
    "a number that its formula does not have": ("91.5°", "92.5°", "another number than its"),
    "a wrong choice without a reply": (" {angle-linear}", "", "line 16 is wrong, but has no reply"),
    "two choices that are equal": ("- [ ] 12°", "- [ ] 91.5°", "'91.5°': is the choice of line 15"),
    "two ideas at one choice": ("12°", "12° {order} {angle-linear}", "'{order}': is shown as it"),
    "an idea in capitals": ("12°", "12° {Order}", "line 17 = '{Order}': is shown as it is typed"),
    "an idea at the right choice": (":= fov_x", ":= fov_x {order}", "stands at the right choice"),
    "a wrong value that is right": ("2*60", "98.2", "is wrong, but its formula gives the right"),
    "two wrong values that are equal": ("mine: 30", "mine: 120", "cannot be told from the wrong"),
    "an unclosed dollar": ("(h/2)$", "(h/2)", "no other $ on its line ends"),
    "TeX that cannot be typeset": ("\\arctan", "\\arctg", "cannot be typeset"),
    "a symbol that nothing defines": ("tan(60/2)", "tan(phi/2)", "unknown name, phi"),
    "a picture": ("The angle", "![F](f.png) The angle", "a picture or a link"),
    "a link": ("Drag it.", "See [this](http://a.b).", "a picture or a link"),
    "has HTML": ("Drag it.", "<b>Drag</b> it.", "has HTML"),
    "a comment in HTML": ("Drag it.", "Drag it. <!-- why -->", "has HTML"),
    "a formula without an exercise": ("Drag it.", "Drag {=a} of it.", "that only an exercise"),
    "an unknown kind of block": ("```task", "```tsak", "unknown kind of block, tsak"),
    "a block that is not closed": ("Drag it.\n```", "Drag it.", "is not closed"),
    "two blocks of a name": ("answer scale", "answer angle", "repeats the name of line"),
    "an unknown idea": ("wrong angle-linear: 2", "wrong angle-liner: 2", "unknown wrong idea"),
    "an unknown unit": ("unit: °\nwrong angle-linear: 2", "unit: furlong\nwrong angle-linear: 2",
                        "must be one of ×, x, %, °"),
    "a sample with another verdict": ("98.2 -> right", "98.2 -> wrong", "instead of “wrong”"),
    "a sample of no block": ("angle: 98.2", "angel: 98.2", "must be one of wide, near"),
    "a task that is done at once": ("near < was_near", "near > 0", "done before the student"),
    "a condition without a sign": ("near < was_near", "near", "must be a condition"),
    "a check that does not hold": ("fov_x > fov", "fov_x < fov", "does not hold"),
    "a setting that is unknown": ("lens.near=2\n", "lens.naer=2\n", "lens.naer is not known"),
    "a value that is impossible": ("lens.near=2\n", "lens.near=-2\n", "lens.near"),
    "an unknown scene": ("letter-f", "letter-g", "no scene “letter-g”"),
    "a file elsewhere": ("scene=letter-f", "scene=../f.obj", "beside the lesson"),
    "a range without values": ("20..100 step 1", "100..20 step 1", "must be a range"),
    "too few variants": ("20..100 step 1", "20..22 step 1", "variants"),
    "conditions that never hold": ("f < 90", "f < 9", "finds no numbers that suit"),
    "a name that no line varies": ("{=a} times", "{=b} times", "unknown name, b"),
    "something unknown to hide": ("hide: numbers", "hide: nubmers", "must be one of numbers"),
    "a place outside the picture": ("at: width/2", "at: 2*width", "not in the picture"),
    "a ragged matrix": ("2, 0; 0, 3", "2, 0; 3", "the same number of cells"),
    "a wrong matrix of another shape": ("3, 0; 0, 2", "3, 0, 0, 2", "cells; the answer has"),
    "a hint without a text": ("hint: Drag it.", "hint:", "needs a text"),
    "a misspelt key": ("hint: Take", "hnit: Take", "must be one of"),
    "a name that no picture has": ("lens.near=2\n", "lens.near=2\nview.names=eye,nose\n",
                                   "nose, which no picture"),
    "too many steps": ("# One {#one}", "".join(f"# {at}\n\n---\n" for at in range(8)) + "# One",
                       "is step 8 of a lesson; the limit is 7"),
    "too many words": ("The angle", "The angle is " * 60, "words in its step; the limit is 150"),
    "no title": ("title: Mistakes\n", "", "lacks a line “title: ...”"),
}  # fmt: skip
"""What is written instead of what, and a part of what is said."""
