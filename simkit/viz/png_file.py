"""Pixels as a PNG file, without a library that loads slowly."""

from __future__ import annotations

import struct
import zlib

from simkit.viz.eye import Pixels


def png_of_pixels(pixels: Pixels) -> bytes:
    """A PNG file.

    Args:
        pixels: Red, green, blue, opacity of each pixel; shape (height, width, 4).

    Source:
        The PNG specification: signature, header, one block of rows each with filter 2 (differences to the row above), end.
    """
    height, width, _ = pixels.shape
    rows = pixels.reshape(height, width * 4)
    differences = rows.copy()
    differences[1:] -= rows[:-1]
    data = b"".join(b"\x02" + row.tobytes() for row in differences)
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(data, 9)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(kind, content) for kind, content in chunks)


def _chunk(kind: bytes, content: bytes) -> bytes:
    checksum = zlib.crc32(kind + content)
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", checksum)
