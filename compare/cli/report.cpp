#include "compare/cli/report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "compare/base/file.hpp"
#include "compare/base/standard_streams.hpp"
#include "compare/documents/bytes/run_h5_read.hpp"
#include "compare/documents/texts/report_html.hpp"
#include "compare/process/run_record.hpp"

namespace validate {
namespace {

struct ReportFlags {
  std::string run, out;
};

int report(const ReportFlags& flags) {
  namespace fs = std::filesystem;
  fs::path file = flags.run;
  if (fs::is_directory(file)) file /= "run.h5";
  const Result result = read_run_h5(file);
  const fs::path folder = fs::absolute(file).parent_path(), ours = file.parent_path() / "report.html";
  if (flags.out.empty()) {
    add_to_record(ours);
    write_report(result, folder, fs::absolute(ours));
  } else {  // a page that the user names is the user's
    check_users_file(flags.out);
    write_users_file(flags.out, report_page(result, folder));
  }
  print_result((flags.out.empty() ? ours.string() : flags.out) + "\n");
  return 0;
}

}  // namespace

void add_report(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("report", "report.html of a finished run, without computing");
  const auto flags = std::make_shared<ReportFlags>();
  command->add_option("run", flags->run, "run.h5, or the folder that holds it")->required()->type_name("FILE");
  command->add_option("--out", flags->out, "page to write; default: report.html beside run.h5")->type_name("FILE");
  command->footer("Example:\n  validate report runs/indentation-airebo-R110/run.h5");
  command->callback([flags, &exit_code] { exit_code = report(*flags); });
}

}  // namespace validate
