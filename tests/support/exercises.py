"""An exercise that several tests practise, mark, print and record."""

WIDE = """vary fov: 20..100 step 5
vary a: 4/3, 16/9, 2, 1.5, 5/2
where: fov_x < 150
state: lens.fov_y_deg={=fov}; image.width={=720*a}; image.height=720
The picture is {=fov}° high and {=a} times as wide. How wide is its angle?
value: 2*atan(a*tan(fov/2))
unit: °
wrong angle-linear: a*fov
"""
"""The lines of the block; more lines may follow, such as ``why:``."""
