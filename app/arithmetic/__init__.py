"""Numbers of more digits: double-double, and rationals."""
