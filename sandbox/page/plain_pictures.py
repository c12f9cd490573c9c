"""Copies the PNG files of FOLDER to OUT with their pixels filtered but not deflated: plain_pictures.py FOLDER OUT.

The page is compressed as a whole, by what knows more than PNG's deflate."""
import pathlib
import struct
import sys
import zlib

folder, out = map(pathlib.Path, sys.argv[1:])
out.mkdir(parents=True, exist_ok=True)


def chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


for file in folder.glob("*.png"):
    data = file.read_bytes()
    at, head, pixels = 8, b"", b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        content = data[at + 8:at + 8 + length]
        head += chunk(kind, content) if kind in (b"IHDR", b"PLTE") else b""
        pixels += content if kind == b"IDAT" else b""
        at += 12 + length
    plain = zlib.compress(zlib.decompress(pixels), 0)
    (out / file.name).write_bytes(data[:8] + head + chunk(b"IDAT", plain) + chunk(b"IEND", b""))
