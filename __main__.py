"""Start the program by the path of this folder: ``python3 PATH``."""

import os
import sys

from app.__main__ import main

folder = os.path.dirname(os.path.abspath(__file__))
if not os.path.isdir(folder):
    sys.stderr.write("frustum-lab: it cannot run inside an archive; unpack " + folder + "\n")
    sys.exit(3)
sys.exit(main())
