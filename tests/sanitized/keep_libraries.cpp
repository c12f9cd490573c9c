// Part of every program that is built with the sanitizers: shared libraries stay loaded to the end. A driver that was
// unloaded leaves blocks that nothing refers to any more, and call stacks without names: LeakSanitizer takes these for
// leaks of ours, and no suppression can name them.

extern "C" __attribute__((visibility("default"))) int dlclose(void * /*library*/) { return 0; }
