#include "compare/cli/bulge.hpp"

#include "compare/cli/experiment.hpp"

namespace validate {

namespace {

constexpr const char* bulge_examples =
    R"(The default is Figure 4 of Gil et al. 2010: a square whose edges slide in their plane, wrinkled along every side.

Examples:
  validate bulge
  validate bulge --extent full --cells 60
  validate bulge --shape disc --size "1 um" --edge clamped --E "1.0209 TPa" --thickness "0.335 nm" --nu 0.165 \
      --pretension "0.34 N/m" --pressures "0.1 MPa,1 MPa"
  validate bulge --unrelaxed     # what the sheet does if it could bear compression
  validate bulge --potential tersoff --shape disc --edge clamped --size 100 --pressures 1e-3,4e-3    # atoms beside it)";

}  // namespace

void add_bulge(CLI::App& app, int& exit_code) {
  add_experiment(app,
                 {.name = Command::bulge,
                  .description = "a wrinkling membrane under follower pressure, and atoms beside it",
                  .defaults = bulge_defaults(),
                  .case_file = "figure4.toml",
                  .examples = bulge_examples},
                 exit_code);
}

}  // namespace validate
