"""Makes the page out of what the build has linked: pack.py SOURCES BUILD OUT.

OUT/shading-sandbox.html holds everything, deflated. OUT/split/ has the program in a file of its own, for a server that
compresses what it sends."""
import base64
import pathlib
import shutil
import sys
import zlib

sources, build, out = map(pathlib.Path, sys.argv[1:])


def text_of(name):
    return (sources / name).read_text("utf-8")


def packed(name, content):
    deflate = zlib.compressobj(9, zlib.DEFLATED, -15)
    data = deflate.compress(content) + deflate.flush()
    return f'<script id="{name}" type="text/plain">{base64.b64encode(data).decode()}</script>'


script = (build / "shading-sandbox.js").read_bytes()
program = (build / "shading-sandbox.wasm").read_bytes()
icon = (sources.parent.parent / "assets/desktop/icon-48.png").read_bytes()
page = text_of("page.html").replace("@icon@", base64.b64encode(icon).decode()).replace("@style@", text_of("page.css"))
page = page.replace("@licences@", text_of("licences.html"))
start = "<script>@loader@</script>"

whole = page.replace(start, packed("script", script) + "\n" + packed("program", program) + "\n" +
                     start.replace("@loader@", text_of("loader.js")))
(out / "shading-sandbox.html").write_text(whole, "utf-8")

split = out / "split"
split.mkdir(exist_ok=True)
shutil.copy(build / "shading-sandbox.js", split)
shutil.copy(build / "shading-sandbox.wasm", split)
(split / "index.html").write_text(page.replace("@loader@", text_of("loader.js")), "utf-8")
