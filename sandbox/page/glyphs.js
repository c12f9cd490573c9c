// Characters that the page's fonts lack, as the browser draws them, with whatever font it has (image/page_glyph.cpp).
addToLibrary({
  $pageGlyphs: {
    // Where the character is drawn, `height` pixels high.
    brush(character, height) {
      const brush = pageGlyphs.kept ??= new OffscreenCanvas(1, 1).getContext('2d', {willReadFrequently: true});
      brush.font = `${height}px system-ui, sans-serif`;
      return [brush, brush.measureText(String.fromCodePoint(character))];
    },
  },
  page_glyph_advance__deps: ['$pageGlyphs'],
  page_glyph_advance: (character, height) => pageGlyphs.brush(character, height)[1].width,

  // Fills box: how far the picture's left and top are from the pen on the baseline, its width and height. Gives its
  // bytes, for the caller to free, 255: ink.
  page_glyph__deps: ['$pageGlyphs', 'malloc'],
  page_glyph: (character, height, box) => {
    const [brush, found] = pageGlyphs.brush(character, height);
    const left = Math.floor(-found.actualBoundingBoxLeft) - 1, top = Math.floor(-found.actualBoundingBoxAscent) - 1;
    const width = Math.ceil(found.actualBoundingBoxRight) + 1 - left;
    const rows = Math.ceil(found.actualBoundingBoxDescent) + 1 - top;
    brush.canvas.width = width;
    brush.canvas.height = rows;
    pageGlyphs.brush(character, height)[0].fillText(String.fromCodePoint(character), -left, -top);
    const ink = brush.getImageData(0, 0, width, rows).data;
    const cover = _malloc(width * rows);
    for (let i = 0; i < width * rows; ++i) {
      HEAPU8[cover + i] = ink[4 * i + 3];
    }
    HEAP32.set([left, top, width, rows], box >> 2);
    return cover;
  },
});
