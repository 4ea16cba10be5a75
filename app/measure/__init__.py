"""Measure the trade of speed for accuracy on this machine, for one scene and one camera.

Every trade is a module with a function ``measure``, which runs each choice and compares its answers
with an independent reference. `measuring.measure_all` runs the requested trades and keeps finished
ones after a cancellation: a `Cancelled` that a watch raises holds the trade so far, with the errors
and the times until then. `results` defines the results and their file.
"""
