// Opens the page in Debian's Chromium, on Mesa's llvmpipe as the program's other tests, or on SwiftShader.
import {createServer} from 'node:http';
import {readFile} from 'node:fs/promises';
import path from 'node:path';
import puppeteer from 'puppeteer-core';

const graphics = {
  llvmpipe: ['--use-gl=angle', '--use-angle=gl-egl'],
  swiftshader: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
};
const types = {'.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.wasm': 'application/wasm'};

// Serves a folder on loopback, as any static host does.
export async function serve(folder) {
  const server = createServer(async (request, response) => {
    const name = path.join(folder, path.normalize(new URL(request.url, 'http://x').pathname).replace(/\/$/, '/index.html'));
    try {
      const bytes = await readFile(name);
      response.writeHead(200, {'content-type': types[path.extname(name)] ?? 'application/octet-stream'});
      response.end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise(resolve => server.listen(0, '127.0.0.1', resolve));
  return {address: `http://127.0.0.1:${server.address().port}`, close: () => server.close()};
}

export async function openBrowser(renderer = 'llvmpipe', flags = []) {
  return puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--ignore-gpu-blocklist', ...graphics[renderer], ...flags],
    env: {...process.env, LIBGL_ALWAYS_SOFTWARE: '1'},
    protocolTimeout: 600000,
  });
}

// A page of its own storage, with the files that the program finds in its folder. `complaints`: what the console has
// said besides the program's own notes.
export async function newPage(browser, size = {width: 1280, height: 720}, files = {}) {
  const context = await browser.createBrowserContext();
  const page = await context.newPage();
  await page.setViewport(size);
  const complaints = [];
  page.on('console', message => {
    if (message.type() === 'error' || message.type() === 'warn') {
      complaints.push(message.text());
    }
  });
  page.on('pageerror', error => complaints.push(String(error)));
  if (Object.keys(files).length > 0) { // as if an earlier visit had kept them
    await page.evaluateOnNewDocument(kept => localStorage.setItem('shading-sandbox.own', kept), JSON.stringify(files));
  }
  return {page, complaints};
}

// Runs a command in the page; gives its exit code, what it printed and noted, and a reader of the files it wrote.
// `before`: what happens in the page before anything else.
export async function runCommand(browser, address, words, files = {}, before = () => {}) {
  const {page, complaints} = await newPage(browser, {width: 640, height: 480}, files);
  await page.evaluateOnNewDocument(before);
  const notes = [];
  page.on('console', message => notes.push(message.text()));
  await page.goto(`${address}?${words.map(encodeURIComponent).join('&')}`);
  await page.waitForFunction(() => 'exit' in document.documentElement.dataset, {timeout: 600000});
  const result = await page.evaluate(() => ({
    code: Number(document.documentElement.dataset.exit),
    printed: document.getElementById('text').textContent,
  }));
  const read = async name => Buffer.from(await page.evaluate(file => {
    const bytes = FS.readFile(file);
    let text = '';
    for (let i = 0; i < bytes.length; i += 4096) {
      text += String.fromCharCode(...bytes.subarray(i, i + 4096));
    }
    return btoa(text);
  }, name), 'base64');
  return {...result, notes, complaints, read, close: () => page.browserContext().close()};
}

export const ready = page => page.waitForFunction(() => document.documentElement.dataset.ready, {timeout: 60000});

// The pixels that the window shows once it has come to rest, RGBA.
export async function pixelsAtRest(page) {
  const look = () => page.evaluate(() => {
    const canvas = document.getElementById('canvas');
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
    copy.drawImage(canvas, 0, 0);
    const bytes = new Uint8Array(copy.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
    let text = '';
    for (let i = 0; i < bytes.length; i += 4096) {
      text += String.fromCharCode(...bytes.subarray(i, i + 4096));
    }
    return btoa(text);
  });
  for (let last = await look(), same = 0;;) {
    await new Promise(resolve => setTimeout(resolve, 500));
    const now = await look();
    same = now === last ? same + 1 : 0;
    last = now;
    if (same === 4) { // 2 s
      return Buffer.from(now, 'base64');
    }
  }
}
