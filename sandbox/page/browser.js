// What the window's host (ui/page_host.cpp) and loop (ui/page_window.cpp) ask of the browser. What it hands over goes
// to the exported functions of page_host.cpp.
addToLibrary({
  $page__deps: ['$stringToNewUTF8', 'free', '$GL'],
  $page: {
    host: 0, window: 0,
    wake: null,  // ends the loop's waiting
    woken: false,
    canvas: () => document.getElementById('canvas'),
    // A canvas has lost what was drawn with: one that is still used, for there may be but few.
    lost(event) {
      event.preventDefault();
      if (GL.contexts.some(context => context?.GLctx.canvas === event.target)) {
        Module.lostContext();
      }
    },
    // Calls an exported function with a text.
    tell(call, text) {
      const copy = stringToNewUTF8(text);
      call(page.host, copy);
      _free(copy);
    },
    // What GLFW calls a key, after the keyboard's layout: letters by what they print, the rest by where they are.
    keys: {
      Space: 32, Quote: 39, Comma: 44, Minus: 45, Period: 46, Slash: 47, Semicolon: 59, Equal: 61, BracketLeft: 91,
      Backslash: 92, BracketRight: 93, Backquote: 96, Escape: 256, Enter: 257, Tab: 258, Backspace: 259, Insert: 260,
      Delete: 261, ArrowRight: 262, ArrowLeft: 263, ArrowDown: 264, ArrowUp: 265, PageUp: 266, PageDown: 267, Home: 268,
      End: 269, NumpadSubtract: 333, NumpadAdd: 334, NumpadEnter: 257, ShiftLeft: 340, ControlLeft: 341, AltLeft: 342,
      MetaLeft: 343, ShiftRight: 344, ControlRight: 345, AltRight: 346, MetaRight: 347,
    },
    keyOf(event) {
      if (/^[a-z]$/i.test(event.key)) {
        return event.key.toUpperCase().charCodeAt(0);
      }
      const number = /^(?:Digit(\d)|F(\d+))$/.exec(event.code);
      return number ? (number[1] ? 48 + +number[1] : 289 + +number[2]) : page.keys[event.code] ?? 0;
    },
    modsOf: event => event.shiftKey | event.ctrlKey << 1 | event.altKey << 2 | event.metaKey << 3,
  },

  page_listen__deps: ['$page', 'page_resize', 'page_pointer', 'page_lift', 'page_wheel', 'page_key', 'page_type', 'page_paste', 'page_drop', 'page_focus'],
  page_listen: host => {
    page.host = host;
    const canvas = page.canvas();
    const density = () => window.devicePixelRatio || 1;
    const resize = () => {
      const box = canvas.getBoundingClientRect();
      canvas.width = Math.max(Math.round(box.width * density()), 1);
      canvas.height = Math.max(Math.round(box.height * density()), 1);
      _page_resize(host, canvas.width, canvas.height, density());
    };
    new ResizeObserver(resize).observe(canvas);
    const watchDensity = () => window.matchMedia(`(resolution: ${density()}dppx)`)
      .addEventListener('change', () => { resize(); watchDensity(); }, {once: true});
    watchDensity();
    resize();

    // Mouse, pen and fingers. Two fingers pinch: the wheel.
    const fingers = new Map();
    let spread = 0;
    const at = event => {
      const box = canvas.getBoundingClientRect();
      return [(event.clientX - box.left) * density(), (event.clientY - box.top) * density()];
    };
    const spreadOf = () => {
      const [[ax, ay], [bx, by]] = [...fingers.values()];
      return Math.hypot(ax - bx, ay - by);
    };
    const move = event => {
      event.preventDefault();
      if (event.pointerType === 'touch') {
        if (event.type === 'pointerdown' || fingers.has(event.pointerId)) {
          fingers.set(event.pointerId, at(event));
        }
        if (fingers.size === 2) {
          const now = spreadOf();
          const [[ax, ay], [bx, by]] = [...fingers.values()];
          _page_pointer(host, (ax + bx) / 2, (ay + by) / 2, 0);
          if (spread > 0 && now > 0) {
            _page_wheel(host, Math.log(now / spread) / Math.log(1.1));
          }
          spread = now;
          return;
        }
      }
      _page_pointer(host, ...at(event), event.buttons & 7);
    };
    const lift = event => {
      fingers.delete(event.pointerId);
      spread = 0;
      _page_pointer(host, ...at(event), 0);
      if (event.pointerType === 'touch' && fingers.size === 0) {
        _page_lift(host);
        if (page.wantsText) {
          document.getElementById('keyboard').focus(); // the screen's: only a touch may open it
        }
      }
    };
    canvas.addEventListener('pointerdown', event => {
      canvas.setPointerCapture(event.pointerId);
      if (event.pointerType !== 'touch') {
        canvas.focus();
      }
      move(event);
    });
    canvas.addEventListener('pointermove', move);
    canvas.addEventListener('pointerup', event => event.pointerType === 'touch' ? lift(event) : move(event));
    canvas.addEventListener('pointercancel', lift);
    canvas.addEventListener('pointerleave', event => { if (!event.buttons) _page_lift(host); });
    canvas.addEventListener('contextmenu', event => event.preventDefault());
    canvas.addEventListener('wheel', event => {
      event.preventDefault();
      const notch = event.deltaMode === 0 ? 100 : event.deltaMode === 1 ? 3 : 1;
      _page_wheel(host, -event.deltaY / notch);
    }, {passive: false});

    // The keyboard, unless something of the page's own has it.
    const elsewhere = event => event.target.closest?.('#editor, dialog') != null;
    const key = (event, down) => {
      if (elsewhere(event)) {
        return;
      }
      const code = page.keyOf(event), mods = page.modsOf(event);
      const pastes = down && (mods & 10) !== 0 && code === 86;
      const browsers = (mods & 10) !== 0 && [76, 78, 82, 84, 87].includes(code) || code === 294; // Ctrl+L N R T W, F5
      if (pastes || browsers || code === 0) {
        return; // what is pasted comes first
      }
      if (event.key.length > 1 || (mods & 14) !== 0 || code === 32) {
        event.preventDefault();
      }
      _page_key(host, code, mods, down, event.repeat);
      if (down && event.key.length === 1 && (mods & 10) === 0 && event.target.id !== 'keyboard') {
        page.tell(_page_type, event.key);
      }
    };
    window.addEventListener('keydown', event => key(event, true));
    window.addEventListener('keyup', event => key(event, false));
    window.addEventListener('paste', event => {
      if (!elsewhere(event)) {
        page.tell(_page_paste, event.clipboardData.getData('text/plain'));
        _page_key(host, 86, 2, true, false);
        _page_key(host, 86, 0, false, false);
      }
    });
    document.getElementById('keyboard').addEventListener('input', event => {
      page.tell(_page_type, event.target.value);
      event.target.value = '';
    });
    window.addEventListener('blur', () => _page_focus(host));
    window.addEventListener('focus', () => _page_focus(host));

    // Files.
    const take = async files => {
      for (const file of files) {
        const path = `${FS.cwd().replace(/\/$/, '')}/${file.name}`;
        FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
        Module.sawFile?.(path);
        page.tell(_page_drop, path);
      }
    };
    window.addEventListener('dragover', event => event.preventDefault());
    window.addEventListener('drop', event => {
      event.preventDefault();
      take(event.dataTransfer.files);
    });
    const chooser = document.getElementById('chooser');
    chooser.addEventListener('change', () => take([...chooser.files]).then(() => { chooser.value = ''; }));

    canvas.addEventListener('webglcontextlost', page.lost);
    document.addEventListener('fullscreenchange', resize);
  },

  page_add_canvas__deps: ['$page', '$specialHTMLTargets', '$UTF8ToString'],
  page_add_canvas: name => {
    const canvas = specialHTMLTargets[UTF8ToString(name)] = new OffscreenCanvas(1, 1);
    canvas.addEventListener('webglcontextlost', page.lost);
  },

  page_wake__deps: ['$page'],
  page_wake: () => {
    page.woken = true;
    page.wake?.();
  },

  // Steps for as long as the page is open: after what arrives, or when a step has asked for the next one.
  page_loop__deps: ['$page', '$pageThreads', 'page_keep'],
  page_loop: (step, window_, stack) => {
    page.window = window_;
    const frame = () => new Promise(resolve => requestAnimationFrame(resolve));
    const idle = seconds => new Promise(resolve => {
      page.wake = resolve;
      if (page.woken) {
        resolve();
      } else if (seconds < 1e6) {
        setTimeout(resolve, 1000 * seconds);
      }
    });
    const run = async () => {
      let seconds = await pageThreads.enter(step, stack, window_);
      Module.firstFrame?.();
      for (;;) {
        if (seconds > 0) {
          await idle(seconds);
        }
        page.wake = null;
        page.woken = false;
        await frame();
        seconds = await pageThreads.enter(step, stack, window_);
      }
    };
    pageThreads.turn().then(run).catch(error => Module.fail(String(error)));
    Module.keep = () => UTF8ToString(_page_keep(window_));
  },

  page_fail__deps: ['$UTF8ToString'],
  page_fail: why => Module.fail(UTF8ToString(why)),
  page_ended: code => Module.ended(code),
  page_set_title__deps: ['$UTF8ToString'],
  page_set_title: title => { document.title = UTF8ToString(title); },
  page_set_full_screen: on => {
    if (on && !document.fullscreenElement) {
      document.documentElement.requestFullscreen?.().catch(() => {});
    } else if (!on && document.fullscreenElement) {
      document.exitFullscreen();
    }
  },
  page_set_clipboard__deps: ['$page', 'page_paste', '$UTF8ToString'],
  page_set_clipboard: text => {
    const copied = UTF8ToString(text);
    page.tell(_page_paste, copied);
    navigator.clipboard?.writeText(copied).catch(() => {});
  },
  page_pick_file: () => document.getElementById('chooser').click(),
  page_share__deps: ['$UTF8ToString'],
  page_share: state => Module.share(UTF8ToString(state)),
  page_show_licences: () => document.getElementById('licences').showModal(),
  page_want_text__deps: ['$page'],
  page_want_text: on => {
    page.wantsText = on !== 0;
    if (!on) {
      document.getElementById('keyboard').blur();
      page.canvas().focus();
    }
  },
});
