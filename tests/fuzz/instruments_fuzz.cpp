// Damaged files of every instrument: a reader answers with curves that are consistent, or with an error that is the
// user's. usage: instruments_fuzz SEED_FOLDER SECONDS [NAME...]    SECONDS for each seed; NAME: of seeds, the beginning
// is enough A finding is written to finding-SEED beside where the program is called, and the exit code is 1. Memory
// that a file merely claims, and an endless loop, are findings too.
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "compare/base/errors.hpp"
#include "compare/instruments/format.hpp"
#include "tests/fuzz/mutate.hpp"

namespace {

using namespace validate;
using Clock = std::chrono::steady_clock;
using Members = std::map<std::string, std::string>;

constexpr long most_memory_kB = 1500000;  ///< of the whole process, the sanitizers' own included
constexpr unsigned longest_s = 30;
constexpr std::size_t curves_read = 3;

[[noreturn]] void inconsistent(const char* what) { throw std::logic_error(what); }

void check_column(const std::vector<double>& values, int points) {
  if (values.size() != static_cast<std::size_t>(points)) inconsistent("a column is not as long as the segments");
}

void check(const Recording& curve) {
  for (const RecordedSegment& segment : curve.segments)
    if (segment.points < 0) inconsistent("a segment of negative length");
  if (curve.metadata.points != curve.points()) inconsistent("the points are not those of the segments");
  describe(curve.columns, [&](const Field&, const std::optional<RecordedColumn>& column) {
    if (column) check_column(column->values, curve.points());
  });
  for (const OtherColumn& other : curve.other_columns) check_column(other.values, curve.points());
}

void read(const Recordings& recordings) {
  for (std::size_t i = 0; i < std::min(recordings.size(), curves_read); ++i) check(recordings.read(i));
}

/// Reads what a file has become; false where it is refused.
bool answered(const FileContent& content) {
  try {
    for (const InstrumentFormat& format : instrument_formats())
      if (format.recognises(content)) {
        read(*format.open(content, {.spring_constant_N_per_m = 1, .sensitivity = 1e-8}));
        return true;
      }
    return false;
  } catch (const Error& error) {
    if (error.exit_code() != ExitCode::bad_input && error.exit_code() != ExitCode::file_failed) throw;
    return false;
  }
}

std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A seed: the bytes of a file, and its members where it is an archive of them.
struct Seed {
  std::filesystem::path file;
  std::string bytes;
  Members members;
};

Seed seed_of(const std::filesystem::path& file) {
  Seed seed{file, content_of(file), {}};
  if (looks_like_zip(seed.bytes)) {
    const auto archive = open_zip(file);
    for (const std::string& name : archive->names()) seed.members[name] = archive->read(name);
  }
  return seed;
}

class Run {
 public:
  Run(const Seed& seed, const std::string& other, unsigned number)
      : seed_(seed),
        other_(other),
        mutate_(number),
        scratch_(fmt::format("fuzz-{}-{}", ::getpid(), seed.file.filename().string())) {
    running = &last_;
    std::signal(SIGALRM, give_up);
  }
  ~Run() { std::filesystem::remove(scratch_); }

  /// Returns how many damaged files were read and how many refused.
  std::pair<long, long> go(double seconds) {
    const auto start = Clock::now();
    long read = 0, refused = 0;
    while (std::chrono::duration<double>(Clock::now() - start).count() < seconds) {
      ::alarm(longest_s);
      (one() ? read : refused) += 1;
      ::alarm(0);
      rusage usage{};
      getrusage(RUSAGE_SELF, &usage);
      if (usage.ru_maxrss > most_memory_kB) throw std::logic_error("takes too much memory");
    }
    return {read, refused};
  }

  const std::string& last() const { return last_; }

  /// What an alarm has left to do: the file at which a reader does not end.
  static void give_up(int) {
    std::ofstream("finding-endless", std::ios::binary) << *running;
    fmt::print("FINDING: takes more than {} s\n", longest_s);
    std::_Exit(1);
  }

 private:
  inline static const std::string* running = nullptr;

  bool one() {
    // Of an archive mostly the members are changed: what is compressed seldom survives a change.
    if (!seed_.members.empty() && mutate_.below(8) != 0) return one_of_members();
    last_ = mutate_(seed_.bytes, other_);
    if (seed_.members.empty() && !last_.starts_with("\x89HDF")) return answered({.name = "damaged", .bytes = last_});
    std::ofstream(scratch_, std::ios::binary) << last_;
    try {
      read(*open_recordings(scratch_, {.spring_constant_N_per_m = 1, .sensitivity = 1e-8}));
      return true;
    } catch (const Error& error) {
      if (error.exit_code() != ExitCode::bad_input && error.exit_code() != ExitCode::file_failed) throw;
      return false;
    }
  }

  bool one_of_members() {
    Members members = seed_.members;
    const auto changed = std::next(members.begin(), static_cast<std::ptrdiff_t>(mutate_.below(members.size())));
    if (mutate_.below(16) == 0) {
      members.erase(changed);
    } else {
      changed->second = mutate_(changed->second, other_);
      last_ = changed->first + "\n" + changed->second;
      if (members.size() == 1 || !members.contains("header.properties"))
        return answered({.name = "damaged", .bytes = members.contains(changed->first) ? changed->second : ""});
    }
    return answered(
        {.name = "damaged", .bytes = "PK", .archive = std::make_shared<ArchiveInMemory>(std::move(members))});
  }

  const Seed& seed_;
  const std::string& other_;
  fuzz::Mutator mutate_;
  std::filesystem::path scratch_;
  std::string last_;
};

bool fuzz_seed(const Seed& seed, const std::string& other, double seconds, unsigned number) {
  const std::string name = seed.file.filename().string();
  Run run(seed, other, number);
  try {
    const auto [read, refused] = run.go(seconds);
    fmt::print("{}: {} read, {} refused\n", name, read, refused);
    std::fflush(stdout);
    return true;
  } catch (const std::exception& finding) {
    std::ofstream("finding-" + name, std::ios::binary) << run.last();
    fmt::print("{}: FINDING: {}\n", name, finding.what());
    return false;
  }
}

bool wanted(const std::string& name, int argc, char** argv) {
  bool found = argc == 3;
  for (int i = 3; i < argc; ++i) found = found || name.starts_with(argv[i]);
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: instruments_fuzz SEED_FOLDER SECONDS [NAME...]\n");
    return 2;
  }
  std::vector<Seed> seeds;
  std::vector<std::filesystem::path> files(std::filesystem::directory_iterator(argv[1]), {});
  std::ranges::sort(files);
  for (const auto& file : files)
    if (std::filesystem::is_regular_file(file)) seeds.push_back(seed_of(file));
  const char* number = std::getenv("FUZZ_NUMBER");
  bool clean = !seeds.empty();
  for (std::size_t i = 0; i < seeds.size(); ++i)
    if (wanted(seeds[i].file.filename().string(), argc, argv))
      clean = fuzz_seed(seeds[i], seeds[(i + 1) % seeds.size()].bytes, std::strtod(argv[2], nullptr),
                        number ? static_cast<unsigned>(std::strtoul(number, nullptr, 10)) : 1u) &&
              clean;
  return clean ? 0 : 1;
}
