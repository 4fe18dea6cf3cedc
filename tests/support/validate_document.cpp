// validate_document SCHEMA FILE…: exit 0 if every document is valid, else 1 with what is wrong on stderr.
#include <exception>
#include <iostream>

#include "tests/support/json_schema.hpp"

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: validate_document SCHEMA FILE...\n";
    return 1;
  }
  try {
    const support::JsonSchema schema(support::read_json(argv[1]));
    bool valid = true;
    for (int i = 2; i < argc; ++i) {
      for (const std::string& problem : schema.problems(support::read_json(argv[i]))) {
        std::cerr << argv[i] << ": " << problem << '\n';
        valid = false;
      }
    }
    return valid ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "validate_document: " << error.what() << '\n';
    return 1;
  }
}
