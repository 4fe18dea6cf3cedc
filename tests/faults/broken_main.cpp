// `validate verify` alone, with --break NAME.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "compare/base/errors.hpp"
#include "compare/cli/verify.hpp"

int main(int argc, char** argv) {
  CLI::App app("validate verify with faults", "validate_broken");
  int exit_code = 0;
  validate::add_verify(app, exit_code);
  try {
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem);
  } catch (const validate::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.exit_code());
  }
}
