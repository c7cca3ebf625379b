#include "src/cli/report_file.hpp"

#include "src/exchange/files/disk_io.hpp"
#include "src/results/page/report_page.hpp"

namespace rubicon::cli {

std::optional<std::string> write_report(const std::string& path, film::FilmWriter& writer,
                                        const std::string& schedule) {
  return files::write_file(path, page::report_page(page::viewer_page(), writer.finish(schedule)));
}

}  // namespace rubicon::cli
