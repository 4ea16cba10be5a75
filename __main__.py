"""Start the program by the path of this folder: ``python3 PATH``."""

import sys

from app.__main__ import main

sys.exit(main())
