// The page in a real browser against the native program: the same pictures, figures and verdicts, and a window that
// works. PROGRAM: the native executable; PAGE: the folder of shading-sandbox.html and split/.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import path from 'node:path';
import {pathToFileURL} from 'node:url';
import {brotliCompressSync, constants} from 'node:zlib';
import {after, before, describe, test} from 'node:test';
import {newPage, openBrowser, ready, runCommand, serve} from './browser.mjs';

const program = process.env.PROGRAM, folder = process.env.PAGE;
const scratch = mkdtempSync(path.join(tmpdir(), 'page-test-'));
const native = (...words) => {
  try {
    return execFileSync(program, words, {cwd: scratch, encoding: 'utf8', maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'ignore']});
  } catch (failed) {
    return failed.stdout; // exit code 1: a check failed, which is the figure
  }
};
let browser, host;
before(async () => {
  host = await serve(path.join(folder, 'split'));
  browser = await openBrowser();
});
after(async () => {
  await browser.close();
  host.close();
  rmSync(scratch, {recursive: true});
});

test('a server sends 1.8 MB at most', () => {
  let sent = 0;
  for (const name of readdirSync(path.join(folder, 'split'))) {
    const bytes = readFileSync(path.join(folder, 'split', name));
    sent += brotliCompressSync(bytes, {params: {[constants.BROTLI_PARAM_SIZE_HINT]: bytes.length}}).length; // quality 11
  }
  assert.ok(sent <= 1.8e6, `${sent} bytes`);
});

test('cmake --install places the page', () => {
  const prefix = path.join(scratch, 'installed');
  execFileSync('cmake', ['--install', folder, '--prefix', prefix]);
  for (const name of ['shading-sandbox.html', 'split/index.html', 'split/shading-sandbox.js', 'split/shading-sandbox.wasm']) {
    assert.ok(readFileSync(path.join(prefix, 'share/shading-sandbox', name)).equals(readFileSync(path.join(folder, name))), name);
  }
});

describe('commands', () => {
  const pictures = ['studio', 'vase', 'box-5-specular', 'spot-light', 'three-point-lights']
    .flatMap(scene => ['per-vertex/phong', 'per-pixel/blinn-phong'].map(technique => [scene, technique]));
  for (const [scene, technique] of pictures) {
    test(`${scene}, ${technique}: every float32 as native`, async () => {
      const words = ['capture', scene, '--technique', technique, '--size', '320x240', '--out', 'a.pfm'];
      const run = await runCommand(browser, host.address, words);
      assert.equal(run.code, 0, run.notes.join('\n'));
      native(...words);
      assert.ok((await run.read('a.pfm')).equals(readFileSync(path.join(scratch, 'a.pfm'))), 'the bytes differ');
      assert.deepEqual(run.complaints, []);
      await run.close();
    });
  }

  test('compare prints the figures of the native program', async () => {
    const words = ['compare', 'vase', '--left', 'per-vertex/phong', '--right', 'per-pixel/phong', '--size', '320x240'];
    const run = await runCommand(browser, host.address, words);
    const figures = text => text.split('\n').filter(line => !line.startsWith('renderer'));
    assert.deepEqual(figures(run.printed), figures(native(...words)));
    await run.close();
  });

  test('the lessons and famous bugs have the verdicts of the native program', async () => {
    for (const which of ['all', 'gallery']) {
      const run = await runCommand(browser, host.address, ['lesson', which, '--json']);
      assert.equal(run.code, 0);
      const verdicts = text => JSON.stringify(JSON.parse(text), (key, value) =>
        ['renderer', 'opengl', 'value', 'measured'].includes(key) ? undefined : value, 1);
      assert.equal(verdicts(run.printed), verdicts(native('lesson', which, '--json')));
      assert.deepEqual(run.complaints, []);
      await run.close();
    }
  });

  test('no stability case breaks its bound', async () => {
    const run = await runCommand(browser, host.address, ['stability', '--out', 's']);
    assert.equal(run.code, 0, run.notes.join('\n'));
    assert.deepEqual(run.complaints, []);
    await run.close();
  });

  test('bad input is a sentence and exit code 2', async () => {
    const run = await runCommand(browser, host.address, ['capture', 'vaze', '--out', 'a.png']);
    assert.equal(run.code, 2);
    assert.match(run.notes.join('\n'), /vase/);
    await run.close();
  });
});

describe('the window', () => {
  // A script of the window's own language, on a window in memory.
  const script = async lines => runCommand(browser, host.address, ['view', '--script', 'clicks'], {'/home/web_user/clicks': lines.join('\n')});

  for (const [where, size] of [['a server', {width: 1280, height: 720}], ['a file', {width: 390, height: 844}]]) {
    test(`opens from ${where} at ${size.width}x${size.height}`, async () => {
      const {page, complaints} = await newPage(browser, size);
      await page.goto(where === 'a file' ? pathToFileURL(path.join(folder, 'shading-sandbox.html')) : host.address);
      await ready(page);
      assert.equal(await page.title(), 'studio - Shading Sandbox');
      const levels = await page.evaluate(async () => {
        await new Promise(requestAnimationFrame);
        const copy = new OffscreenCanvas(64, 64).getContext('2d');
        copy.drawImage(document.getElementById('canvas'), 0, 0, 64, 64);
        return new Set(copy.getImageData(0, 0, 64, 64).data).size;
      });
      assert.ok(levels > 32, `only ${levels} levels of grey: nothing is drawn`);
      assert.deepEqual(complaints, []);
      await page.browserContext().close();
    });
  }

  test('?SCENE opens a scene', async () => {
    const {page} = await newPage(browser);
    await page.goto(`${host.address}?vase`);
    await ready(page);
    assert.equal(await page.title(), 'vase - Shading Sandbox');
    await page.browserContext().close();
  });

  test('widgets answer by name, jobs end, the lesson goes on', async () => {
    const run = await script([
      'click Scene', 'click Scene/vase', 'wait',
      'key 2', 'key Ctrl+Z', 'key S', 'wait 20', 'texts', 'shot a.png',
    ]);
    assert.equal(run.code, 0, run.notes.join('\n'));
    assert.equal((await run.read('a.png')).subarray(1, 4).toString(), 'PNG');
    await run.close();
  });

  test('a link opens what it was made of, a damaged one is a sentence', async () => {
    const {page} = await newPage(browser);
    await page.goto(`${host.address}?vase`);
    await ready(page);
    const shared = JSON.parse(await page.evaluate(() => { // at once: the first frames settle the pictures' size
      const kept = Module.keep();
      Module.share(kept);
      return kept;
    }));
    const link = await page.waitForFunction(() => location.hash.length > 1 && location.hash).then(hash => hash.jsonValue());
    await page.evaluate(() => { Module.keep = null; });
    const {page: other, complaints} = await newPage(browser);
    await other.goto(`${host.address}/${link}`);
    await ready(other);
    const opened = JSON.parse(await other.evaluate(() => Module.keep()));
    assert.deepEqual([opened.scene, opened.techniques, opened.layout], [shared.scene, shared.techniques, shared.layout]);
    assert.deepEqual(complaints, []);
    await other.goto('about:blank');
    await other.goto(`${host.address}/${link.slice(0, link.length / 2)}`);
    await other.waitForFunction(() => !document.getElementById('message').hidden);
    assert.match(await other.evaluate(() => document.getElementById('message').textContent), /link is damaged/);
    await page.browserContext().close();
    await other.browserContext().close();
  });

  test('what was edited is there when the page is opened again', async () => {
    const {page} = await newPage(browser);
    await page.goto(host.address);
    await ready(page);
    await page.keyboard.press('2'); // the wipe
    await page.waitForFunction(() => JSON.parse(Module.keep()).layout === 'wipe');
    await page.reload();
    await ready(page);
    assert.equal(await page.evaluate(() => JSON.parse(Module.keep()).layout), 'wipe');
    await page.browserContext().close();
  });

  test('own shading is written, edited and drawn in the page', async () => {
    const own = native('own', '--answer');
    const {page, complaints} = await newPage(browser, undefined, {'/home/web_user/mine.glsl': own});
    await page.goto(`${host.address}?view&studio&--own-left&mine.glsl&--left&per-pixel/own&--right&per-pixel/phong`);
    await ready(page);
    await page.waitForFunction(text => Module.keep() && JSON.parse(Module.keep()).techniques[0].own === text, {}, own);
    await page.evaluate(() => {
      Module.edit('/home/web_user/mine.glsl');
      const area = document.querySelector('#editor textarea');
      area.value += '// once more\n';
      area.dispatchEvent(new Event('input'));
    });
    await page.waitForFunction(() => JSON.parse(Module.keep()).techniques[0].own.endsWith('// once more\n'));
    assert.deepEqual(complaints, []);
    await page.browserContext().close();
  });
});

// Another rasterizer: edges fall otherwise, the rest is the same light.
describe('SwiftShader', () => {
  let other;
  before(async () => { other = await openBrowser('swiftshader'); });
  after(() => other.close());

  // It places vertices on a grid of 1/16 pixel, which moves whatever is steep: beside the truth on that grid, nothing is
  // left but float32.
  for (const scene of ['vase', 'three-point-lights']) test(`${scene} is the truth on its own grid`, async () => {
    const words = ['compare', scene, '--left', 'per-pixel/blinn-phong', '--right', 'reference', '--size', '320x240', '--json'];
    const run = await runCommand(other, host.address, words);
    const figures = JSON.parse(run.printed);
    assert.ok(figures.compared_share > 0.99, `${figures.compared_share} compared`);
    assert.ok(figures.max_abs < 5e-5, `differs by ${figures.max_abs}: more than float32 rounds in random scenes`);
    assert.ok(figures.differing_share < 1e-3, `${figures.differing_share} at another level`);
    await run.close();
  });

  // Beside llvmpipe, which has no grid: the more texture, the more differs.
  for (const [scene, share] of [['box-5-specular', 0.97], ['studio', 0.9]]) test(`${scene}: ${100 * share} % of the pixels at the same level`, async () => {
    const words = ['capture', scene, '--size', '320x240', '--out', 'a.pfm'];
    const run = await runCommand(other, host.address, words);
    assert.equal(run.code, 0, run.notes.join('\n'));
    native(...words);
    const floats = bytes => new Float32Array(new Uint8Array(bytes.subarray(bytes.length - 320 * 240 * 12)).buffer);
    const a = floats(await run.read('a.pfm')), b = floats(readFileSync(path.join(scratch, 'a.pfm')));
    const level = value => Math.round(255 * Math.min(Math.max(value, 0), 1));
    let same = 0, near = 0;
    for (let i = 0; i < a.length; i += 3) {
      const worst = Math.max(...[0, 1, 2].map(c => Math.abs(level(a[i + c]) - level(b[i + c]))));
      same += worst === 0;
      near += worst <= 1;
    }
    const pixels = a.length / 3;
    assert.ok(same >= share * pixels, `${same} of ${pixels} at 0 levels`);
    assert.ok(near >= 0.99 * pixels, `${pixels - near} of ${pixels} differ by more: edges alone are fewer`);
    await run.close();
  });
});
