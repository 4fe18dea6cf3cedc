#include "tests/compare/results/complete_result.hpp"

#include <cmath>

#include "compare/base/walk.hpp"

namespace sample {

using namespace validate;

namespace {

constexpr std::size_t list_length = 3;

/// Gives each member a value that no other has.
class Fill {
 public:
  Fill(int& counter, Command command) : counter_(counter), command_(command) {}

  void operator()(const Field& field, double& value) {
    const auto [low, high, low_open, high_open] = field.range;
    const double fraction = 1 / (2.0 + next());
    value = std::isfinite(low) && std::isfinite(high) ? low + fraction * (high - low)
            : std::isfinite(low)                      ? low + counter_ + 0.25
                                                      : counter_ + 0.5;
  }
  void operator()(const Field& field, int& value) {
    if (field.name != "schema") value = 10 + next();
  }
  void operator()(const Field&, long& value) { value = 100000000000 + next(); }
  void operator()(const Field&, bool& value) { value = next() % 2 == 0; }
  void operator()(const Field& field, std::string& value) {
    if (!field.choices.empty())
      value = field.choices[static_cast<std::size_t>(next()) % field.choices.size()];
    else
      value = field.name.ends_with("sha256") ? std::string(64, static_cast<char>('a' + next() % 6))
                                             : "text " + std::to_string(next()) + ", κ";
  }
  void operator()(const Field&, Command& command) { command = command_; }
  template <Worded Enum>
  void operator()(const Field&, Enum& value) {
    value = static_cast<Enum>(static_cast<std::size_t>(next()) % all_words<Enum>.size());
  }
  void operator()(const Field& field, Pair& value) {
    (*this)(field, value[0]);
    (*this)(field, value[1]);
  }
  template <class T>
  void operator()(const Field& field, std::optional<T>& value) {
    (*this)(field, value.emplace());
  }
  void operator()(const Field& field, std::vector<bool>& values) {
    values.resize(list_length);
    for (std::size_t i = 0; i < list_length; ++i) {
      bool value = false;
      (*this)(field, value);
      values[i] = value;
    }
  }
  void operator()(const Field&, std::vector<Run>& runs) {  // of each model
    runs.resize(all_words<Model>.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      runs[i].model = static_cast<Model>(i);
      settle_part(runs[i]);
      describe(runs[i], *this);
    }
  }
  void operator()(const Field& field, Model& model) {
    if (field.meaning.find("resists bending") == std::string_view::npos) model = Model::sheet;  // not a run's own
  }
  template <class T>
  void operator()(const Field& field, std::vector<T>& values) {
    values.resize(list_length);
    for (T& value : values) (*this)(field, value);
  }
  template <class... T>
  void operator()(const Field&, std::variant<T...>& part) {
    std::visit([this](auto& members) { describe(members, *this); }, part);
  }
  void operator()(const Field&, std::shared_ptr<const std::vector<SheetPicture>>& pictures) {
    pictures = std::make_shared<const std::vector<SheetPicture>>(2, picture());
  }
  void operator()(const Field&, std::shared_ptr<const Result>& summary) {
    summary = std::make_shared<const Result>(complete(Command::indentation));
  }
  template <Described Struct>
  void operator()(const Field&, Struct& s) {
    describe(s, *this);
  }

 private:
  int next() { return ++counter_; }

  int& counter_;
  Command command_;
};

}  // namespace

SheetPicture picture() {
  SheetPicture picture;
  picture.mesh.nodes = {{0, 0}, {1, 0}, {1, 2}, {0, 2.5}};
  picture.mesh.triangles.resize(2);
  picture.mesh.triangles[0].nodes = {0, 1, 2};
  picture.mesh.triangles[1].nodes = {0, 2, 3};
  picture.mesh.copies = 4;
  picture.displacement = {0, 0, -1, 0.1, 0, -0.5, 0.1, 0.2, -0.25, 0, 0.3, 0};
  picture.nodes = {{"displacement_A", "Å", "from the flat sheet", 3, picture.displacement}};
  picture.triangles = {{"state", "", "0 taut, 1 wrinkled, 2 slack", 1, {0, 1}},
                       {"cauchy_1_eV_per_A3", "eV/Å³", "larger principal Cauchy stress", 1, {0.25, 0.5}},
                       {"direction", "", "of the larger stress", 3, {1, 0, 0, 0, 1, 0}}};
  picture.totals = {{"energy_eV", "eV", "of the full sheet", 12.5}, {"force_eV_per_A", "eV/Å", "of the load", 3.25}};
  picture.level = 7;
  picture.thickness_A = 3.35;
  return picture;
}

Result complete(Command command) {
  Result result;
  result.command = command;
  int counter = 0;
  describe(result, Fill(counter, command));
  if (result.is_experiment()) {  // these stand for what is not there
    for (Run& run : result.runs) {
      run.fit_skipped.clear();
      if (run.is_atomistic()) run.constants.reset();
    }
    result.agreement_skipped.clear();
  }
  return result;
}

}  // namespace sample
