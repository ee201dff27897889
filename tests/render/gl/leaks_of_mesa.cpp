// SPDX-License-Identifier: MIT
// Leaks that are Mesa's, not ours; link this into every test program that opens a context. One line per
// library. Read by the leak checker of the asan preset, and by nothing else.

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa.so\n"
         "leak:libGLX_mesa.so\n"
         "leak:swrast_dri.so\n";
}

/// Libraries stay: what one leaked that is gone by the end could be told to be nobody's.
extern "C" int dlclose(void* /*library*/);
extern "C" int dlclose(void* /*library*/) { return 0; }
