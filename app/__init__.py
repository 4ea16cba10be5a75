"""Frustum Lab: how a camera turns a three-dimensional scene into a picture."""

import sys

__version__ = "0.1.0"

# Here, because an older Python cannot even read the other modules.
if sys.version_info < (3, 11):  # noqa: UP036
    here = sys.version.split()[0] + " (" + sys.executable + ")"
    sys.stderr.write("frustum-lab: this is Python " + here + "; 3.11 is needed\n")
    sys.stderr.write("frustum-lab: https://www.python.org/downloads has it for every system\n")
    raise SystemExit(3)
