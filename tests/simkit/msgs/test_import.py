from __future__ import annotations

import subprocess
import sys


def test_importing_the_messages_loads_nothing_heavy():
    code = (
        "import sys, simkit.msgs as m\n"
        "m.message_class('nav_msgs/Odometry')().to_bytes()\n"
        "print(sorted({'numpy', 'rosbags', 'yaml'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"
