// What the user sees while a run works: on a terminal one line that is kept up to date, elsewhere one line per event.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace validate {

/// Of a clock that never goes back.
double seconds();

class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A line that stays.
  void say(std::string_view line);

  /// The transient line: nothing where stderr is not a terminal.
  void status(std::string_view line);

  double elapsed_s() const;

 private:
  bool quiet_, terminal_, shown_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// `[#####.....]  52 %` for a fraction of 0 to 1.
std::string bar(double fraction);

}  // namespace validate
