#include "compare/cli/flags.hpp"

#include <fmt/format.h>

#include <optional>

#include "compare/base/errors.hpp"
#include "compare/base/units.hpp"

namespace validate {
namespace {

std::string flag_of(const Field& field) { return fmt::format("--{}", field.name); }

// Kind of value, shown after the flag in --help.
std::string placeholder(const Field& field, double) { return field.unit.empty() ? "NUMBER" : "VALUE"; }
std::string placeholder(const Field& field, const std::optional<double>&) { return placeholder(field, 0.0); }
std::string placeholder(const Field&, const std::string&) { return "NAME"; }
template <Worded Enum>
std::string placeholder(const Field&, const Enum&) {
  return "NAME";
}
template <Worded Enum>
std::string placeholder(const Field&, const std::optional<Enum>&) {
  return "NAME";
}
template <Worded Enum>
std::string placeholder(const Field&, const std::vector<Enum>&) {
  return "NAME,...";
}
std::string placeholder(const Field& field, const std::vector<double>&) { return placeholder(field, 0.0) + ",..."; }

std::string shown_default(double value) { return fmt::format("{}", value); }
std::string shown_default(const std::optional<double>& value) { return value ? shown_default(*value) : ""; }
std::string shown_default(const std::string& value) { return value; }
std::string shown_default(const std::vector<double>& values) { return fmt::format("{}", fmt::join(values, ",")); }

template <Worded Enum>
std::string shown_default(const Enum& value) {
  return std::string(to_string(value));
}
template <Worded Enum>
std::string shown_default(const std::optional<Enum>& value) {
  return value ? shown_default(*value) : "";
}
template <Worded Enum>
std::string shown_default(const std::vector<Enum>& values) {
  std::vector<std::string_view> words;
  for (const Enum value : values) words.push_back(to_string(value));
  return fmt::format("{}", fmt::join(words, ","));
}

bool is_number(const std::string&) { return false; }
template <Worded Enum>
bool is_number(const Enum&) {
  return false;
}
template <Worded Enum>
bool is_number(const std::optional<Enum>&) {
  return false;
}
template <Worded Enum>
bool is_number(const std::vector<Enum>&) {
  return false;
}
template <class Number>
bool is_number(const Number&) {
  return true;
}

/// The field with its choices: an enumerator's are its words.
template <class Value>
Field with_choices(const Field& field, const Value&) {
  return field;
}
template <Worded Enum>
Field with_choices(const Field& field, const Enum&) {
  return with_words<Enum>(field);
}
template <Worded Enum>
Field with_choices(const Field& field, const std::optional<Enum>&) {
  return with_words<Enum>(field);
}
template <Worded Enum>
Field with_choices(const Field& field, const std::vector<Enum>&) {
  return with_words<Enum>(field);
}

template <class Value>
std::string help_line(const Field& plain, const Value& value) {
  const Field field = with_choices(plain, value);
  std::string line(field.meaning);
  if (!field.choices.empty()) line += fmt::format("; {}", fmt::join(field.choices, ", "));
  if (is_number(value)) line += fmt::format("; {}", describe_range(field));
  const std::string by_default = shown_default(value);
  if (!by_default.empty()) line += fmt::format("; default {}", by_default);
  return line;
}

std::string group_of(const Field& field) {
  return field.table.empty() ? "Case (keys of the case file)" : fmt::format("Case, table [{}]", field.table);
}

struct AddFlag {
  CLI::App& command;

  template <class Value>
  void operator()(const Field& field, const Value& value) {
    const std::string line = help_line(field, value);
    command.add_option(flag_of(field), line)
        ->take_all()  // a repeated flag is refused, or joined to a list, below
        ->type_name(placeholder(field, value))
        ->group(group_of(field));
  }
  void operator()(const Field& field, bool) {
    const std::string line(field.meaning);
    command.add_flag(flag_of(field), line)->group(group_of(field));
  }
};

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else if (c != ' ' || !parts.back().empty()) {  // no blanks in front
      parts.back() += c;
    }
  }
  return parts;
}

std::string single_text(const Field& field, const CLI::Option& option) {
  if (option.count() > 1) throw bad_input("{}: given {} times; one value is expected", flag_of(field), option.count());
  return option.results().front();
}

std::vector<std::string> parts_of(const CLI::Option& option) {
  return split_at_commas(fmt::format("{}", fmt::join(option.results(), ",")));
}

// One overload per type of field.
void read(const Field& field, const CLI::Option& option, double& value) {
  value = parse_number(field, single_text(field, option), flag_of(field));
}
void read(const Field& field, const CLI::Option& option, std::optional<double>& value) {
  value = parse_number(field, single_text(field, option), flag_of(field));
}
void read(const Field&, const CLI::Option& option, bool& value) { value = option.as<bool>(); }
void read(const Field& field, const CLI::Option& option, std::string& value) {
  value = parse_text(field, single_text(field, option), flag_of(field));
}
void read(const Field& field, const CLI::Option& option, std::vector<double>& values) {
  values.clear();
  for (const auto& part : parts_of(option)) {
    values.push_back(parse_number(field, part, flag_of(field)));
  }
}
template <Worded Enum>
void read(const Field& field, const CLI::Option& option, Enum& value) {
  value = *from_word<Enum>(parse_text(with_words<Enum>(field), single_text(field, option), flag_of(field)));
}
template <Worded Enum>
void read(const Field& field, const CLI::Option& option, std::optional<Enum>& value) {
  read(field, option, value.emplace());
}
template <Worded Enum>
void read(const Field& field, const CLI::Option& option, std::vector<Enum>& values) {
  values.clear();
  for (const auto& part : parts_of(option))
    values.push_back(*from_word<Enum>(parse_text(with_words<Enum>(field), part, flag_of(field))));
}

}  // namespace

CaseFlags::CaseFlags(CLI::App& command, const Case& defaults) : command_(command) {
  describe(defaults, AddFlag{command});
}

namespace {

/// The variant's text for a field, if it has one.
const std::optional<std::string>& text_for(const Field& field, const Variant& variant) {
  static const std::optional<std::string> none;
  return field.name == "potential" ? variant.potential : field.name == "radius" ? variant.radius : none;
}

void read_text(const Field& field, const std::string& text, double& value) {
  value = parse_number(field, text, flag_of(field));
}
void read_text(const Field& field, const std::string& text, std::string& value) {
  value = parse_text(field, text, flag_of(field));
}
template <class Other>
void read_text(const Field&, const std::string&, Other&) {}  // no list of these makes a batch

}  // namespace

void CaseFlags::apply(Case& c, Origins& origins, const Variant& variant) const {
  describe(c, [&](const Field& field, auto& value) {
    const CLI::Option& option = *command_.get_option(flag_of(field));
    if (option.count() == 0) return;
    if (const auto& text = text_for(field, variant)) {
      read_text(field, *text, value);
    } else {
      read(field, option, value);
    }
    origins[std::string(field.name)] = flag_of(field);
  });
}

std::vector<std::string> CaseFlags::texts() const {
  std::vector<std::string> all;
  const Case fields;
  describe(fields, [&](const Field& field, const auto&) {
    for (const std::string& text : command_.get_option(flag_of(field))->results())
      for (std::string& part : split_at_commas(text)) all.push_back(std::move(part));
  });
  return all;
}

std::vector<Variant> CaseFlags::variants() const {
  const auto list = [&](const char* flag) -> std::vector<std::optional<std::string>> {
    const CLI::Option& option = *command_.get_option(flag);
    if (option.count() != 1 || option.results().front().find(',') == std::string::npos) return {std::nullopt};
    std::vector<std::optional<std::string>> parts;
    for (const std::string& part : parts_of(option)) parts.emplace_back(part);
    return parts;
  };
  std::vector<Variant> all;
  for (const auto& potential : list("--potential"))
    for (const auto& radius : list("--radius")) all.push_back({potential, radius});
  return all;
}

void add_run_options(CLI::App& command, RunOptions& options) {
  const auto add_path = [&](const char* name, std::optional<std::filesystem::path>& path, const char* meaning) {
    const auto read_path = [&path, name](const std::string& text) {
      if (text.empty()) throw bad_input("{}: the path is empty", name);
      path = text;
    };
    command.add_option_function<std::string>(name, read_path, meaning)
        ->type_name(std::string(name) == "--out" ? "DIR" : "FILE")
        ->group("Run");
  };
  add_path("--case", options.case_file, "case file in TOML; default: the command's file in inputs/");
  add_path("--out", options.out, "run folder; default: runs/ and a name made from the case");
  add_path("--json", options.json, "write the summary there too; - is stdout");
  command.add_option("--ranks", options.ranks, "MPI ranks for the atoms; 0 to 4096; default 0: chosen")
      ->type_name("N")
      ->check(CLI::Range(0, 4096).description(""))
      ->group("Run");
  command.add_option("--launcher", options.launcher, "command that starts the ranks, e.g. \"srun -n 64\"")
      ->type_name("WORDS")
      ->group("Run");
  const auto add_switch = [&](const char* name, bool& value, const char* meaning) {
    command.add_flag(name, value, meaning)->group("Run");
  };
  add_switch("--dry-run", options.dry_run, "print the resolved case and an estimate, compute nothing");
  add_switch("--quiet", options.quiet, "no progress on stderr");
  add_switch("--resume", options.resume, "continue an unfinished run in --out");
  add_switch("--overwrite", options.overwrite, "replace a finished run in --out");
  add_switch("--allow-code", options.allow_code, "let a potential bring a program of its own (pair_style python)");
  add_switch("--all-fields", options.all_fields,
             "fields of the membranes (ParaView, run.h5) at every depth, not at the last only: 2 MB a depth and curve");
}

void add_output_options(CLI::App& command, OutputOptions& options, const std::string& meaning) {
  command.add_option("--out", options.out, meaning)->type_name("DIR");
  command.add_flag("--overwrite", options.overwrite, "first remove what was written into --out before");
}

void check(const RunOptions& options) {
  if (options.resume && options.overwrite) throw bad_input("--resume and --overwrite exclude each other");
}

std::vector<std::string> flag_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

}  // namespace validate
