"""The tests, one file per subject; run them with ``python3 -m tests``."""

import app  # noqa: F401  (refuses a Python that is too old to read what follows)

PATIENCE_S = 600
PATIENCE_MS = 1000 * PATIENCE_S
"""How long a test waits for what must come. Longer than it takes on any busy machine: only what
never comes should take it."""
