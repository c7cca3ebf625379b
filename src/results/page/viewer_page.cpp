#include "src/results/page/report_page.hpp"

// The linker's section of constants gets the file as it is: as a literal it would take the compiler
// minutes.
asm(".pushsection .rodata, \"a\", @progbits\n"
    "rubicon_viewer_page_begin:\n"
    ".incbin \"" RUBICON_VIEWER_PAGE
    "\"\n"
    "rubicon_viewer_page_end:\n"
    ".byte 0\n"
    "rubicon_study_page_begin:\n"
    ".incbin \"" RUBICON_STUDY_PAGE
    "\"\n"
    "rubicon_study_page_end:\n"
    ".byte 0\n"
    ".popsection\n");

extern "C" {
extern const char rubicon_viewer_page_begin[];
extern const char rubicon_viewer_page_end[];
extern const char rubicon_study_page_begin[];
extern const char rubicon_study_page_end[];
}

namespace rubicon::page {

std::string_view viewer_page() { return {rubicon_viewer_page_begin, rubicon_viewer_page_end}; }

std::string_view empty_study_page() { return {rubicon_study_page_begin, rubicon_study_page_end}; }

}  // namespace rubicon::page
