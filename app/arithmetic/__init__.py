"""Numbers of more digits, double-double and rationals, and of fewer: the formats of hardware."""
