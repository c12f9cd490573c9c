// Unpacks the program, or fetches it, and starts it. Its words stand in the address: ?vase or
// ?compare&vase&--left&flat/phong are a command line, #... is a state that was shared. Without: what the last visit
// left.
(async () => {
  const store = {
    get: key => { try { return localStorage.getItem(`shading-sandbox.${key}`); } catch { return null; } },
    set: (key, value) => { try { localStorage.setItem(`shading-sandbox.${key}`, value); } catch { /* full, or forbidden */ } },
  };

  const squeezed = async (stream, bytes) =>
    new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
  const encodeState = async text => {
    const bytes = await squeezed(new CompressionStream('deflate-raw'), new TextEncoder().encode(text));
    return btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join(''))
      .replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
  };
  const decodeState = async code => {
    const bytes = Uint8Array.from(atob(code.replace(/-/g, '+').replace(/_/g, '/')), c => c.charCodeAt(0));
    return new TextDecoder('utf-8', {fatal: true}).decode(await squeezed(new DecompressionStream('deflate-raw'), bytes));
  };

  const message = document.getElementById('message');
  const fail = why => { message.textContent = why; message.hidden = false; };
  try {
    if (!document.createElement('canvas').getContext('webgl2')) {
      return fail('This browser gives the page no WebGL 2. Try a newer browser, or switch its hardware acceleration on.');
    }
    const inflate = async text => new Response(new Blob([Uint8Array.from(atob(text), c => c.charCodeAt(0))]).stream()
      .pipeThrough(new DecompressionStream('deflate-raw')));
    const packed = id => document.getElementById(id)?.textContent;
    const program = packed('program') ? await (await inflate(packed('program'))).arrayBuffer()
                                      : await (await fetch('shading-sandbox.wasm')).arrayBuffer();
    const script = packed('script') ? await (await inflate(packed('script'))).text() : null;
    const Module = window.Module = {
      canvas: document.getElementById('canvas'),
      store,
      encodeState,
      fail,
      instantiateWasm(imports, done) {
        for (const group of Object.values(imports)) {
          for (const [name, call] of Object.entries(group)) {
            if (call.suspends && typeof WebAssembly.Suspending === 'function') {
              group[name] = new WebAssembly.Suspending(call);
            }
          }
        }
        WebAssembly.instantiate(program, imports).then(result => done(result.instance, result.module))
          .catch(error => fail(`This browser cannot run the program (${error.message}). Try a newer one.`));
        return {};
      },
      firstFrame() {
        document.getElementById('loading').hidden = true;
        Module.firstFrame = null;
        document.documentElement.dataset.ready = performance.now();
      },
    };
    Module.arguments = location.search.slice(1).split('&').filter(word => word).map(decodeURIComponent);
    if (location.hash.length > 1) {
      Module.state = await decodeState(location.hash.slice(1)).catch(() => null);
      if (Module.state === null) {
        return fail('The link is damaged: a part of it after # may be missing. Ask for it again.');
      }
    } else if (Module.arguments.length === 0 && store.get('state')) {
      Module.state = store.get('state');
      Module.keptState = true;
    }
    if (Module.state) {
      Module.arguments = ['shared.json'];
    }
    const code = document.createElement('script');
    script ? code.textContent = script : code.src = 'shading-sandbox.js';
    document.body.append(code);
  } catch (error) {
    fail(`Shading Sandbox cannot start: ${error.message}`);
  }
})();
