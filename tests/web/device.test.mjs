// What a device brings: fingers, a dense screen, fonts, WebGL that is lost or lacks something. PAGE: the folder of
// shading-sandbox.html and split/; PROGRAM: the native executable.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import path from 'node:path';
import {after, before, describe, test} from 'node:test';
import {newPage, openBrowser, pixelsAtRest, ready, runCommand, serve} from './browser.mjs';

let browser, host;
before(async () => {
  host = await serve(path.join(process.env.PAGE, 'split'));
  browser = await openBrowser();
});
after(async () => {
  await browser.close();
  host.close();
});

// How many of two pictures' pixels differ.
const differing = (a, b) => {
  assert.equal(a.length, b.length);
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    count += a.readUInt32LE(i) !== b.readUInt32LE(i);
  }
  return count;
};

describe('characters that no font of the page has', () => {
  const rare = ['龘', 'ἆ', 'ő']; // a Chinese one, a Greek, a Latin

  // Pixels of a PNG file.
  const pixelsOf = async bytes => {
    const {page} = await newPage(browser);
    const pixels = await page.evaluate(async base64 => {
      const file = await fetch(`data:image/png;base64,${base64}`);
      const picture = await createImageBitmap(await file.blob());
      const copy = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
      copy.drawImage(picture, 0, 0);
      return [...copy.getImageData(0, 0, picture.width, picture.height).data];
    }, bytes.toString('base64'));
    await page.browserContext().close();
    return Buffer.from(pixels);
  };

  // Each stands for itself: not left out, not "?".
  const judge = (pictures, blank, question) => {
    const ink = Math.max(differing(question, blank), 1);
    rare.forEach((character, i) => {
      assert.ok(differing(pictures[i], blank) > ink / 2, `${character} is not drawn`);
      assert.ok(differing(pictures[i], question) > ink / 2, `${character} is drawn as "?"`);
    });
  };

  test('labels in captures', async () => {
    const picture = async character => {
      const words = ['capture', 'box-5-specular', '--sweep', `name=${character}`, '--size', '200x100', '--out', 'a.png'];
      const run = await runCommand(browser, host.address, words);
      assert.equal(run.code, 0, run.notes.join('\n'));
      const pixels = await pixelsOf(await run.read('a.png'));
      await run.close();
      return pixels;
    };
    judge(await Promise.all(rare.map(picture)), await picture('.'), await picture('?'));
  });

  test('names in the window', async () => {
    const names = [...rare, '.', '?'];
    const files = {'/home/web_user/clicks': names.map((name, i) => `drop "x${name}x.json"\nwait 3\nshot ${i}.png`).join('\n')};
    for (const name of names) {
      files[`/home/web_user/x${name}x.json`] = JSON.stringify({objects: [{name, mesh: {shape: 'sphere'}}], lights: []});
    }
    const run = await runCommand(browser, host.address, ['view', '--script', 'clicks', '--size', '900x700', '--no-times'], files);
    assert.equal(run.code, 0, run.notes.join('\n'));
    const pictures = [];
    for (let i = 0; i < names.length; ++i) {
      pictures.push(await pixelsOf(await run.read(`${i}.png`)));
    }
    judge(pictures, pictures.at(-2), pictures.at(-1));
    await run.close();
  });
});

describe('fingers', () => {
  const tablet = {width: 700, height: 400, hasTouch: true, isMobile: true, deviceScaleFactor: 2};
  const opened = async () => {
    const {page, complaints} = await newPage(browser, tablet);
    await page.goto(`${host.address}?vase`);
    await ready(page);
    const touch = (type, ...points) => page.evaluate(() => new Promise(requestAnimationFrame)).then(() =>
      page.client.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([x, y], id) => ({x, y, id}))}));
    page.client = await page.createCDPSession();
    const camera = async () => {
      const {position, target = [0, 0, 0]} = JSON.parse(await page.evaluate(() => Module.keep())).scene.camera;
      const arm = position.map((value, i) => value - target[i]);
      return {arm, distance: Math.hypot(...arm)};
    };
    return {page, complaints, touch, camera};
  };
  const near = (a, b, within) => assert.ok(Math.abs(a - b) <= within, `${a}, ${b}`);

  test('one that drags turns the camera about its target', async () => {
    const {page, complaints, touch, camera} = await opened();
    const from = await camera();
    await touch('touchStart', [420, 200]); // in A's picture
    for (let x = 420; x <= 480; x += 10) {
      await touch('touchMove', [x, 200]);
    }
    await touch('touchEnd');
    await page.waitForFunction(arm => {
      const {position, target = [0, 0, 0]} = JSON.parse(Module.keep()).scene.camera;
      return Math.abs(position[0] - target[0] - arm[0]) > 0.1;
    }, {}, from.arm);
    near((await camera()).distance, from.distance, 1e-6 * from.distance);
    assert.deepEqual(complaints, []);
    await page.browserContext().close();
  });

  test('two that spread come nearer', async () => {
    const {page, complaints, touch, camera} = await opened();
    const from = await camera();
    await touch('touchStart', [440, 200]);
    await touch('touchStart', [440, 200], [480, 200]);
    for (let by = 0; by <= 40; by += 10) {
      await touch('touchMove', [440 - by, 200], [480 + by, 200]);
    }
    await touch('touchEnd');
    await page.waitForFunction(distance => {
      const {position, target = [0, 0, 0]} = JSON.parse(Module.keep()).scene.camera;
      return Math.hypot(...position.map((value, i) => value - target[i])) < 0.7 * distance;
    }, {}, from.distance);
    const to = await camera();
    to.arm.forEach((value, i) => near(value / to.distance, from.arm[i] / from.distance, 1e-6)); // it does not turn
    assert.deepEqual(complaints, []);
    await page.browserContext().close();
  });
});

describe('the canvas', () => {
  // How many levels of grey the last columns have.
  const levelsAtTheRight = (pixels, width) => {
    const levels = new Set();
    for (let i = 0; i < pixels.length; i += 4) {
      if (i / 4 % width > 0.9 * width) {
        levels.add(pixels[i]);
      }
    }
    return levels.size;
  };

  test('has every pixel of a dense screen, and follows the window', async () => {
    const {page} = await newPage(browser, {width: 640, height: 480, deviceScaleFactor: 2});
    await page.goto(host.address);
    await ready(page);
    const size = () => page.evaluate(() => [document.getElementById('canvas').width, document.getElementById('canvas').height]);
    assert.deepEqual(await size(), [1280, 960]);
    for (const viewport of [{width: 900, height: 500, deviceScaleFactor: 2}, {width: 800, height: 500, deviceScaleFactor: 1}]) {
      await page.setViewport(viewport);
      const wanted = [viewport.width, viewport.height].map(length => length * viewport.deviceScaleFactor);
      await page.waitForFunction(width => document.getElementById('canvas').width === width, {}, wanted[0]);
      assert.deepEqual(await size(), wanted);
      assert.ok(levelsAtTheRight(await pixelsAtRest(page), wanted[0]) > 16, 'nothing is drawn at the right');
    }
    await page.browserContext().close();
  });
});

describe('WebGL that is lost', () => {
  const lose = page => page.evaluate(() =>
    document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext());

  test('comes back with what was shown', async () => {
    const {page} = await newPage(browser, {width: 800, height: 600});
    await page.goto(`${host.address}?vase`);
    await ready(page);
    const pictures = async () => { // without what stands above and below them, run times for one
      const pixels = await pixelsAtRest(page);
      return pixels.subarray(pixels.length * 0.3, pixels.length * 0.6);
    };
    const before = await pictures();
    const again = page.waitForNavigation();
    await lose(page);
    await again;
    await ready(page);
    assert.equal(differing(await pictures(), before), 0);
    assert.equal(await page.evaluate(() => document.getElementById('message').hidden), true);
    await page.browserContext().close();
  });

  test('while own shading was shown, comes back without it and names the file', async () => {
    const own = execFileSync(process.env.PROGRAM, ['own', '--answer'], {encoding: 'utf8'});
    const {page} = await newPage(browser, {width: 800, height: 600}, {'/home/web_user/mine.glsl': own});
    await page.goto(`${host.address}?view&studio&--own-left&mine.glsl&--left&per-pixel/own&--right&per-pixel/phong`);
    await ready(page);
    await page.waitForFunction(() => Module.keep() && JSON.parse(Module.keep()).techniques[0].own);
    const again = page.waitForNavigation();
    await lose(page);
    await again;
    await ready(page);
    const kept = await page.waitForFunction(() => Module.keep()).then(state => state.jsonValue());
    assert.ok(!JSON.parse(kept).techniques.some(technique => technique.own));
    assert.match(await page.evaluate(() => document.getElementById('message').textContent), /^mine\.glsl: the graphics driver gave up/);
    await page.browserContext().close();
  });
});

describe('a browser that lacks something says so', () => {
  for (const [what, take, says] of [
    ['WebGL 2', () => {
      const all = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { return kind === 'webgl2' ? null : all.call(this, kind, ...rest); };
    }, /no WebGL 2\. Try a newer browser/],
    ['float targets', () => {
      const all = WebGL2RenderingContext.prototype.getSupportedExtensions;
      WebGL2RenderingContext.prototype.getSupportedExtensions = function () {
        return all.call(this).filter(name => name !== 'EXT_color_buffer_float');
      };
    }, /lacks .*EXT_color_buffer_float.*: try another browser/],
  ]) {
    test(what, async () => {
      const {page} = await newPage(browser);
      await page.evaluateOnNewDocument(take);
      await page.goto(host.address);
      await page.waitForFunction(() => !document.getElementById('message').hidden);
      assert.match(await page.evaluate(() => document.getElementById('message').textContent), says);
      await page.browserContext().close();
    });
  }

  test('room for uniforms: refused in our words, and no failure of a stability case', async () => {
    const phone = () => { // what WebGL 2 promises and no more
      const all = WebGL2RenderingContext.prototype.getParameter;
      WebGL2RenderingContext.prototype.getParameter = function (name) {
        return name === this.MAX_FRAGMENT_UNIFORM_VECTORS ? 224 : all.call(this, name);
      };
    };
    const name = 'magnitude-64-lights-of-1e4';
    const run = await runCommand(browser, host.address, ['stability', '--out', 's', '--case', name], {}, phone);
    assert.equal(run.code, 0, run.notes.join('\n'));
    const sentence = /the fragment stage needs room for \d{3} uniform vectors, and this device has 224: try fewer lights/;
    assert.match(run.printed, sentence);
    await run.close();
    const lights = [...Array(64)].map(() => ({type: 'spot', position: [0, 0, 3], direction: [0, 0, -1]}));
    const scene = {'/home/web_user/a.json': JSON.stringify({lights, objects: [{mesh: {shape: 'sphere'}}]})};
    const words = ['capture', 'a.json', '--technique', 'per-pixel/phong:program=full', '--out', 'a.png'];
    const capture = await runCommand(browser, host.address, words, scene, phone);
    assert.equal(capture.code, 3);
    assert.match(capture.notes.join('\n'), sentence);
    await capture.close();
  });
});
