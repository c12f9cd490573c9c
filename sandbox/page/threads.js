// Turns of the page's one thread (image/thread.h): a function of WebAssembly that waits for a promise stops there
// (JSPI), so that events and frames come in between. Every such function has a stack of its own in memory; whatever the
// page calls meanwhile uses the page's.
addToLibrary({
  $pageThreads__deps: ['$stackSave', '$stackRestore', '$wasmTable'],
  $pageThreads: {
    canSuspend: () => typeof WebAssembly.Suspending === 'function' && typeof WebAssembly.promising === 'function',
    pageStack: 0, // where the page's own stack begins: what events call
    // Calls `pointer` on the stack that begins at `stack`; gives its result, or a promise of it.
    enter(pointer, stack, ...values) {
      const call = wasmTable.get(pointer);
      if (!pageThreads.canSuspend()) {
        return call(...values);
      }
      pageThreads.pageStack ||= stackSave();
      stackRestore(stack);
      const end = WebAssembly.promising(call)(...values);
      stackRestore(pageThreads.pageStack);
      return end.finally(() => stackRestore(pageThreads.pageStack));
    },
    // A turn of events: a message comes sooner than the shortest timer.
    turn: () => new Promise(resolve => {
      const channel = new MessageChannel();
      channel.port1.onmessage = () => { channel.port1.close(); resolve(); };
      channel.port2.postMessage(0);
    }),
  },

  page_can_suspend__deps: ['$pageThreads'],
  page_can_suspend: () => pageThreads.canSuspend() ? 1 : 0,

  page_suspend__deps: ['$pageThreads'],
  page_suspend__postset: '_page_suspend.suspends = true;', // instantiateWasm in loader.js makes it wait
  page_suspend: () => {
    stackRestore(pageThreads.pageStack);
    return pageThreads.turn();
  },

  // Each thread draws in a context of its own.
  page_context__deps: ['$GL'],
  page_context: () => GL.currentContext?.handle ?? 0,
  page_use_context__deps: ['$GL'],
  page_use_context: context => { GL.makeContextCurrent(context); },

  page_start__deps: ['$pageThreads'],
  page_start: (run, argument, stack) => {
    pageThreads.turn().then(() => pageThreads.enter(run, stack, argument));
  },
});
