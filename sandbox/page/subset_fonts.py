"""Writes into FOLDER the fonts of the page with the characters that it shows: subset_fonts.py ASSETS FOLDER.

Latin, Greek, Cyrillic and signs for the text and the code; Chinese as the words, lessons and exercises use it."""
import pathlib
import sys

from fontTools import subset
from fontTools.ttLib import TTFont

assets, folder = map(pathlib.Path, sys.argv[1:])
folder.mkdir(parents=True, exist_ok=True)

latin = [*range(0x20, 0x7F), *range(0xA0, 0x100), *range(0x391, 0x3CA), *range(0x2010, 0x2028),
         *range(0x2030, 0x203B), *range(0x2190, 0x219A), 0x2212]
chinese = sorted({character for file in assets.rglob("*.json") for character in map(ord, file.read_text("utf-8"))
                  if character >= 0x2E80})


def write(name, characters):
    path = next(pathlib.Path("/usr/share/fonts").rglob(name), None)
    if path is None:
        sys.exit(f"subset_fonts.py: there is no font {name}: run third_party/install.sh web")
    font = TTFont(path)
    options = subset.Options(layout_features=[], hinting=False, name_IDs=[0, 1, 2, 13], glyph_names=False,
                             notdef_outline=True)
    options.drop_tables += ["vhea", "vmtx", "GSUB", "GPOS", "FFTM"]
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=characters)
    subsetter.subset(font)
    font.save(folder / name)


write("DroidSansFallbackFull.ttf", chinese)
write("DejaVuSansMono.ttf", latin)
write("DejaVuSans.ttf", latin)
