// Read by LeakSanitizer, unused without it. OpenImageIO 2.4's PNG reader holds
// a string when libpng jumps over its destructor, once a truncated file.
extern "C" const char* __lsan_default_suppressions();

const char* __lsan_default_suppressions() {
  return "leak:ImageInput::geterror\n";
}
