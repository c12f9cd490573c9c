// Before the program: what an earlier visit has kept, and what becomes of the files that it writes.
Module.home = '/home/web_user';
// Puts a link that opens `state` into the address and the clipboard.
Module.share = async state => {
  location.replace(`#${await Module.encodeState(state)}`);
  navigator.clipboard?.writeText(location.href).catch(() => {});
};

Module.print = line => {
  const text = document.getElementById('text');
  text.hidden = false;
  text.textContent += `${line}\n`;
};
Module.printErr = line => {
  console.log(line);
  Module.lastNote = line.replace(/^shading-sandbox: /, '');
};
Module.ended = code => {
  if (code !== 0 || !Module.keep) {
    document.documentElement.dataset.exit = code;
  }
  if (code !== 0 && Module.keptState) { // of another version, perhaps
    Module.store.set('state', '');
    location.reload();
  } else if (code !== 0 && Module.lastNote) {
    Module.fail(Module.lastNote);
  }
};
Module.onAbort = why => Module.fail(`The program has ended: ${why}. Reload the page; what was shown is kept.`);

// A picture or a report is a download; own shading opens in the editor.
Module.download = path => {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([FS.readFile(path)]));
  link.download = path.slice(path.lastIndexOf('/') + 1);
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
};
Module.edit = path => {
  const editor = document.getElementById('editor'), area = editor.querySelector('textarea');
  Module.edited = path;
  editor.querySelector('output').textContent = path.slice(path.lastIndexOf('/') + 1);
  area.value = FS.readFile(path, {encoding: 'utf8'});
  editor.hidden = false;
  area.focus();
  area.setSelectionRange(0, 0);
  area.scrollTop = 0;
};
// Files of own shading by their paths, as they are after the next visit begins.
const keptOwn = () => JSON.parse(Module.store.get('own') ?? '{}');
const keepOwn = (path, text) => Module.store.set('own', JSON.stringify({...keptOwn(), [path]: text}));
Module.sawFile = path => {
  if (path.endsWith('.glsl')) {
    keepOwn(path, FS.readFile(path, {encoding: 'utf8'}));
    Module.edit(path);
  }
};
Module.keepAll = () => {
  if (!Module.keep) {
    return;
  }
  const state = Module.keep();
  if (state) {
    Module.store.set('state', state);
  }
  try {
    Module.store.set('settings', FS.readFile(Module.settings, {encoding: 'utf8'}));
  } catch { /* none yet */ }
};
// Everything that was drawn is gone: begin again with what was shown, but without own shading, which may be why.
Module.lostContext = () => {
  if (Module.beginsAgain) { // another canvas has lost its own, too
    return;
  }
  if (!Module.keep) {
    return Module.fail('The browser has taken WebGL away. Reload the page.');
  }
  Module.beginsAgain = true;
  Module.keepAll();
  const state = JSON.parse(Module.store.get('state') ?? '{}');
  const own = state.techniques?.find(technique => technique.own !== undefined);
  if (own) {
    delete state.techniques;
    Module.store.set('state', JSON.stringify(state));
    Module.store.set('message', `${own.file}: the graphics driver gave up while it was shown, so it is shown no longer.`);
  }
  Module.keep = null; // or leaving would keep it again
  location.replace(location.pathname);
};

(Module.preRun ??= []).push(() => {
  Module.settings = `${Module.home}/.config/shading-sandbox/settings.json`;
  FS.mkdirTree(Module.settings.replace(/\/[^/]*$/, ''));
  FS.chdir(Module.home);
  const settings = Module.store.get('settings');
  if (settings) {
    FS.writeFile(Module.settings, settings);
  }
  for (const [path, text] of Object.entries(keptOwn())) {
    FS.writeFile(path, text);
  }
  if (Module.state) {
    FS.writeFile(Module.arguments[0], Module.state);
  }
  const rename = FS.rename;
  FS.rename = (from, to) => { // the program writes whole files by renaming
    rename(from, to);
    const path = to.startsWith('/') ? to : `${FS.cwd()}/${to}`;
    if (path.startsWith(Module.home) && path !== Module.settings) {
      path.endsWith('.glsl') ? Module.sawFile(path) : Module.download(path);
    }
  };
});
if (Module.store.get('message')) {
  Module.fail(Module.store.get('message'));
  Module.store.set('message', '');
  document.addEventListener('pointerdown', () => { document.getElementById('message').hidden = true; }, {once: true});
}
document.addEventListener('visibilitychange', () => { if (document.hidden) Module.keepAll(); });
window.addEventListener('pagehide', () => Module.keepAll());

const editor = document.getElementById('editor');
editor.querySelector('textarea').addEventListener('input', event => { // the program watches the file, as on a disk
  FS.writeFile(Module.edited, event.target.value);
  keepOwn(Module.edited, event.target.value);
});
document.getElementById('close').addEventListener('click', () => { editor.hidden = true; });
document.getElementById('download').addEventListener('click', () => Module.download(Module.edited));
