// SPDX-License-Identifier: MIT
// Leaks that are Mesa's, not ours; link this into every test program that opens a context. One line per
// library. Read by the leak checker of the asan preset, and by nothing else.

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa.so\n"
         "leak:libGLX_mesa.so\n"
         "leak:swrast_dri.so\n";
}

/// Without a list of what was suppressed: the program's stderr is its own.
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }

/// The sanitizers of GCC 12 follow the thread-local storage of libraries that are opened late by what lies
/// before it in memory, and at the end of some programs the leak checker reads an address that is no address
/// ("Tracer caught signal 11"). They need not follow it: what only such storage points to is Mesa's, and
/// suppressed.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "intercept_tls_get_addr=0"; }

/// Libraries stay: what one leaked that is gone by the end could be told to be nobody's.
extern "C" int dlclose(void* /*library*/);
extern "C" int dlclose(void* /*library*/) { return 0; }
