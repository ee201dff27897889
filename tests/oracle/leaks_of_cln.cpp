// SPDX-License-Identifier: MIT
// A string that CLN, GiNaC's numbers, makes once and keeps: read by the leak checker of the asan preset
// alone.

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libcln.so\n"; }
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
