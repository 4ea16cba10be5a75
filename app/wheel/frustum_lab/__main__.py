"""``python3 -m frustum_lab``, the same as ``frustum-lab``."""

import sys

from app.__main__ import main

sys.exit(main())
