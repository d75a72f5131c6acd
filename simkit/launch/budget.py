"""How much one launch file may ask for: evaluation always ends, and soon."""

from __future__ import annotations

from simkit.launch.refusal import ours
from simkit.launch.rules import TOO_MUCH

MAX_TAGS = 10_000
"""Tags that are evaluated, those of included files too, and parameters and remappings that come of them."""
MAX_FILES = 300
"""Launch files that are read."""
MAX_INCLUDE_DEPTH = 25
"""Launch files that include each other in a chain."""
MAX_GROUP_DEPTH = 60
"""Groups in groups."""
MAX_STRING = 100_000
"""Characters of one value after its `$(...)` were replaced."""
MAX_FILE_BYTES = 10_000_000
"""Size of a file that a parameter is read from."""
MAX_LAUNCH_BYTES = 300_000
"""Size of a launch file."""
MAX_ALL_LAUNCH_BYTES = 1_000_000
"""Size of all launch files together."""
MAX_YAML = 100_000
"""Characters of YAML in all: it is slow to read."""
MAX_TOTAL = 50_000_000
"""Characters and bytes of all values and files together."""


class Budget:
    """Counts what an evaluation has used."""

    def __init__(self) -> None:
        self._tags = 0
        self._files = 0
        self._total = 0
        self._yaml = 0
        self._launch_bytes = 0

    def tag(self, count: int = 1) -> None:
        """One more tag, or so many.

        Raises:
            LaunchRefused: That is too many.
        """
        self._tags += count
        if self._tags > MAX_TAGS:
            raise ours(
                TOO_MUCH,
                f"the launch files come to more than {MAX_TAGS} tags in all",
                "Look for a file that is included again and again.",
            )

    def launch_file(self, size: int) -> None:
        """One more launch file, of so many bytes.

        Raises:
            LaunchRefused: That is too many.
        """
        self._launch_bytes += size
        if self._launch_bytes > MAX_ALL_LAUNCH_BYTES:
            raise ours(
                TOO_MUCH,
                f"the launch files have more than {MAX_ALL_LAUNCH_BYTES} bytes in all",
                "Look for a file that is included again and again.",
            )
        self._files += 1
        if self._files > MAX_FILES:
            raise ours(
                TOO_MUCH,
                f"more than {MAX_FILES} launch files are included",
                "Look for files that include each other.",
            )

    def string(self, length: int) -> None:
        """A value of so many characters.

        Raises:
            LaunchRefused: It is too long, or all together are.
        """
        if length > MAX_STRING:
            raise ours(
                TOO_MUCH,
                f"a value of {length} characters is longer than the {MAX_STRING} that are allowed",
                "Put long texts into a file, and use textfile=.",
            )
        self.total(length)

    def yaml(self, length: int) -> None:
        """A YAML text of so many characters.

        Raises:
            LaunchRefused: All together are too long.
        """
        self._yaml += length
        if self._yaml > MAX_YAML:
            raise ours(
                TOO_MUCH,
                f"the YAML of this launch file is longer than {MAX_YAML} characters",
                "Parameters are for settings; keep data in files that the node reads.",
            )

    def total(self, amount: int) -> None:
        """So many characters or bytes were read or made.

        Raises:
            LaunchRefused: All together are too many.
        """
        self._total += amount
        if self._total > MAX_TOTAL:
            raise ours(
                TOO_MUCH,
                f"the values of this launch file are longer than {MAX_TOTAL} characters in all",
                "Look for arguments that double again and again.",
            )
