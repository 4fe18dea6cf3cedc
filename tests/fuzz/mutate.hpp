// Makes damaged files of good ones.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace fuzz {

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  /// One to six changes: bits, bytes and integers of extreme size, pieces cut out, doubled or taken from `other`,
  /// numbers of a text replaced by others, a new end.
  std::string operator()(std::string bytes, const std::string& other);

  std::size_t below(std::size_t end) {
    return end == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

 private:
  void change(std::string& bytes, const std::string& other);
  void replace_number(std::string& bytes);
  void put_integer(std::string& bytes);

  std::mt19937 random_;
};

}  // namespace fuzz
