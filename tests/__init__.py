"""The tests, one file for each room; run them with ``python3 -m tests``."""

import app  # noqa: F401  (refuses a Python that is too old to read what follows)
