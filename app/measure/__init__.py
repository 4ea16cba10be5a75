"""The trade of speed for accuracy, measured on this machine, for one scene and one camera.

Every trade is a module with a ``measure``; each of its choices is really run, and its answers are
held against an independent reference. `measuring.measure_all` runs what is asked for and keeps
what was done when it is cancelled. `results` says what comes out, and how it is written down.
"""
